// Chapter 1 - Three carts and their stops: condensation, and the exchange of wrong pairs.
// Run:  make ch01     Reads: nothing     Writes: ch01_three_carts.results, condensed.md, exchange.md
#include "three_carts.hpp"

#include <algorithm>
#include <iostream>

#include "addons/programme/dense_programme.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace {

using namespace ch01;
using Eigen::Index;
using Eigen::VectorXd;
using Sets = std::vector<Index>;

// 1. What a change of the displacements costs, to first order.
// \PaperEq{XuanLi2002, 7}, \PaperEq{XuanLi2002, 8}
double first_order(const DenseProgramme& carts, const VectorXd& u, const VectorXd& w) {
  return (carts.stiffness * u - carts.load).dot(w - u);
}

struct Step {
  Sets closed;
  VectorXd force, gap;
  Sets pull, overlap, next;  // wrong pairs, and those to close next
};

// 2. Close a set of pairs, look at what is wrong, exchange it. There are 8 sets.
// [exchange]
Step close_these(const ContactProblem& problem, const Sets& closed) {
  const Eigen::MatrixXd& G = problem.compliance;
  Step now;
  now.closed = closed;
  now.force = VectorXd::Zero(3);
  now.force(closed) = CholeskyFactor(G(closed, closed)).solve(-problem.free_gap(closed));
  now.gap = problem.free_gap + G * now.force;
  now.gap(closed).setZero();  // they are zero but for rounding
  for (Index i = 0; i < 3; ++i) {
    const bool is_closed = std::count(closed.begin(), closed.end(), i) > 0;
    if (is_closed && now.force(i) < 0) now.pull.push_back(i);
    if (!is_closed && now.gap(i) < 0) now.overlap.push_back(i);
    if (is_closed ? now.force(i) >= 0 : now.gap(i) < 0) now.next.push_back(i);
  }
  return now;
}
// [exchange]

std::vector<Step> exchange(const ContactProblem& problem, const Sets& start) {
  std::vector<Step> steps = {close_these(problem, start)};
  while (steps.back().next != steps.back().closed && steps.size() < 8)
    steps.push_back(close_these(problem, steps.back().next));
  return steps;
}

std::string list(const Sets& pairs) {  // from 1, as in the text
  std::string all;
  for (const Index i : pairs) all += (all.empty() ? "" : ", ") + std::to_string(i + 1);
  return all.empty() ? "none" : all;
}

void show(const std::vector<Step>& steps, Table& table) {
  for (const Step& now : steps) {
    std::vector<std::string> row = {list(now.closed)};
    for (Index i = 0; i < 3; ++i) row.push_back(number(now.force(i), "%.2f"));
    for (Index i = 0; i < 3; ++i) row.push_back(number(now.gap(i), "%.2f"));
    row.insert(row.end(), {list(now.pull), list(now.overlap)});
    table.row(row);
  }
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch01_three_carts");
  const DenseProgramme carts = three_carts();
  const DenseCondensed small = condense(carts);  // G = A K^-1 A^T, u0 = K^-1 p, d = g - A u0
  const ContactProblem& problem = small.problem;
  const Table condensed = table_of({{"cart", Vector3d(1, 2, 3), "%.0f"},
                                    {"$`u^0`$ [mm]", small.free_displacement, "%.0f"},
                                    {"$`b = u^0 - g`$ [mm]", -problem.free_gap, "%.0f"},
                                    {"$`G_{i1}`$ [mm/N]", problem.compliance.col(0), "%.0f"},
                                    {"$`G_{i2}`$", problem.compliance.col(1), "%.0f"},
                                    {"$`G_{i3}`$", problem.compliance.col(2), "%.0f"}});
  write_file(run.out / "condensed.md", condensed.markdown());
  Table exchanges({"closed", "$`\\lambda_1`$ [N]", "$`\\lambda_2`$", "$`\\lambda_3`$", "gap 1 [mm]",
                   "gap 2", "gap 3", "pull", "overlap"});
  show(exchange(problem, {0, 1, 2}), exchanges);  // from those that overlap without contact
  show(exchange(problem, {1}), exchanges);        // from any other guess
  write_file(run.out / "exchange.md", exchanges.markdown());
  std::cout << exchanges.markdown();
  const ContactState state = primal_dual_active_set(problem);  // the library's own
  for (Index i = 0; i < 3; ++i) results.add(text("cart_force_", i + 1), state.force(i), "N");
  const VectorXd u = small.factor.solve(carts.load - carts.A.transpose() * state.force);
  results.add("carts_back", first_order(carts, u, Vector3d(1, 5, 8)), "N*mm");
  results.add("carts_beyond", first_order(carts, u, Vector3d(3, 5.5, 9)), "N*mm");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch01_three_carts", "Three carts and their stops", SIGNORINI_CHAPTER_OUT, argc,
                     argv, chapter);
}

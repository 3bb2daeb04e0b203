// Chapter 21 - Three ways to factor one matrix, counted and timed.
// Run:  make ch21     Reads: nothing     Writes: ch21_factors.results, factors.md
#include <Eigen/SparseCholesky>
#include <iostream>

#include "../../bench/yardsticks.hpp"
#include "addons/frontal/frontal_factor.hpp"
#include "elimination_tree.hpp"
#include "scenes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/processor_time.hpp"

namespace {

using namespace ch21;
using Eigen::MatrixXd;
using signorini_test::processor_seconds;

// 1. Contact last: what is left of K when all other unknowns are gone is all that contact needs.
// [contact last]
MatrixXd compliance_by_contact_last(const Sparse& K, const NodalRows& A, const Order& order) {
  Eigen::PermutationMatrix<Eigen::Dynamic> P(
      Eigen::Map<const Eigen::VectorXi>(order.data(), K.cols()));  // column k of K P is order[k]
  const Sparse permuted = P.transpose() * K * P;
  const Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(permuted);
  const MatrixXd rows = MatrixXd(A * P).transpose();
  const Index last = (rows.array() != 0).rowwise().any().count();
  const MatrixXd L = MatrixXd(Sparse(factor.matrixL()).bottomRightCorner(last, last));
  const MatrixXd H = L.triangularView<Eigen::Lower>().solve(rows.bottomRows(last));
  return H.transpose() * H;  // A K^-1 A^T
}
// [contact last]

// 2. The same matrix in three orders, counted; and timed, up to A K^-1 A^T where the order leads there.
struct Timed {
  MatrixXd compliance;
  double seconds = 0;
};

template <typename Make>
Timed timed(const Make& make) {
  const double begin = processor_seconds();
  MatrixXd compliance = make();
  return {std::move(compliance), processor_seconds() - begin};
}

void three_ways(const ProgramOptions& run, Results& results) {
  const Model model = built(cantilever(32));
  const Sparse& K = model.programme.stiffness;
  const NodalRows& A = model.programme.A;
  Table table({"order", "entries of L [10⁶]", "operations [10⁶]", "height", "seconds ≈"});
  const auto row = [&](const std::string& name, const Order& order, double took) {
    const EliminationTree tree = elimination_tree(K, order);
    table.row({name, number(tree.entries / 1e6, "%.3f"), number(tree.operations / 1e6, "%.1f"),
               text(tree.height), number(took, "%.2g")});
    return tree;
  };
  const Timed last = timed([&] { return compliance_by_contact_last(K, A, contact_last(K, A)); });
  const Timed ours = timed([&] {
    Ledger unused;
    return FrontalFactor(K, separator_tree(K, unknown_positions(model)), unused).compliance(A);
  });
  const double differ = (last.compliance - ours.compliance).norm() / ours.compliance.norm();
  if (!(differ < 1e-6)) throw NotSolved(text("two ways to one compliance differ by ", differ));
  const EliminationTree of_last = row("contact last", contact_last(K, A), last.seconds);
  for (const bench::Yardstick& other : bench::yardsticks()) {
    if (other.name != "SimplicialLLT") continue;  // of those that may be installed or not
    const Timed plain = timed([&] { return other.solve(K, model.programme.load); });
    results.add(other.name + "_seconds", plain.seconds, "s", Repeats::No);
    results.add("height_minimum_degree",
                row("minimum degree", minimum_degree(K), plain.seconds).height, "-");
  }
  const EliminationTree of_ours =
      row("separators", separator_tree(K, unknown_positions(model)).order, ours.seconds);
  results.add("height_contact_last", of_last.height, "-");
  results.add("height_separators", of_ours.height, "-");
  results.add("operations_contact_last", of_last.operations / of_ours.operations, "-");
  write_file(run.out / "factors.md", table.markdown());
  std::cout << table.markdown();
  results.add("rows_with_contact", static_cast<double>(A.rows()), "-");
  results.add("compliances_differ", differ, "-", Repeats::No);
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch21_factors");
  three_ways(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch21_factors", "Three ways to factor", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}

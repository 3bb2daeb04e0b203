// Chapter 9 - Newton's method with all unknowns, and with contact forces only (Lin et al., sec. 2.3, eqs. 30, 31).
// Run:  make ch09     Reads: nothing     Writes: ch09_newton.results, newton.md,
//       fig_9_2.csv
#include <ctime>
#include <iostream>
#include <vector>

#include "papers/saddle_point_newton.hpp"
#include "round_block.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/complementarity_functions.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/readings.hpp"

namespace {

using namespace ch09;
using namespace signorini;

struct Way {
  Eigen::VectorXd force;
  std::vector<double> residuals;  // |Phi| at the start and after each step, over that at the start
};

// 1. phi(d + G lambda, force_scale lambda) = 0 with few unknowns. `force_scale` is the gap that forces 1 on all pairs make.
/// \PaperEq{LinEtAl, 28}
Way condensed_newton(const ContactProblem& problem) {
  const Eigen::MatrixXd& G = problem.compliance;
  const double force_scale = G.cwiseAbs().rowwise().sum().maxCoeff();
  Way way{Eigen::VectorXd::Zero(problem.free_gap.size()), {}};
  double first = 0;
  for (int k = 0; k <= 60; ++k) {
    const Eigen::VectorXd gap = problem.free_gap + G * way.force;
    Eigen::VectorXd phi = gap;
    Eigen::MatrixXd J = G;
    for (Eigen::Index i = 0; i < gap.size(); ++i) {
      const auto slope = fischer_burmeister_slope(gap(i), force_scale * way.force(i));
      phi(i) = fischer_burmeister(gap(i), force_scale * way.force(i));
      J.row(i) *= slope.a;
      J(i, i) += slope.b * force_scale;
    }
    if (k == 0) first = phi.norm();
    way.residuals.push_back(phi.norm() / first);
    if (way.residuals.back() <= 1e-12) break;
    way.force -= LuFactor(J).solve(phi);
  }
  return way;
}

// 2. Figure 9.2: residuals, one block of rows per method.
Table histories(const Way& condensed, const std::vector<const Report*>& reports) {
  Table table({"step", "residual"});
  for (std::size_t k = 0; k < condensed.residuals.size(); ++k)
    table.row({static_cast<double>(k), condensed.residuals[k]});
  for (const Report* report : reports) {
    table.blank_line();
    table.row({0.0, 1.0});
    for (std::size_t k = 0; k < report->history.size(); ++k)
      table.row({static_cast<double>(k + 1), report->history[k].residual});
  }
  return table;
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }  // of the processor

// 3. Condensed and uncondensed on the round block.
void compare(const ProgramOptions& run, Results& results) {
  Table table({"unknowns", "pairs", "closed", "condensed", "condensed, library", "uncondensed",
               "unscaled"});
  const std::vector<Index> sizes =
      run.full ? std::vector<Index>{16, 24, 40, 80, 132} : std::vector<Index>{16, 24, 40};
  for (const Index n : sizes) {
    const double begin = seconds();
    const SolvedScene one = solved(round_block(n, {"mm"}), "round block");
    const double middle = seconds();
    const SaddlePointSolution two = saddle_point_newton(one.model.programme);
    const double end = seconds();
    SaddlePointOptions printed;
    printed.form = SaddlePointForm::AsPrinted;
    const SaddlePointSolution three = saddle_point_newton(one.model.programme, printed);
    const Way way = condensed_newton(one.condensed.problem);
    const Eigen::VectorXd& force = one.solution.contact.force;
    if (two.report.status != SolveStatus::Solved) throw NotSolved("uncondensed Newton");
    results.add(text("time_ratio_", n), (end - middle) / (middle - begin), "-", Repeats::No);
    if (n > 40) continue;
    table.row({number(static_cast<double>(one.model.unknowns.count)),
               number(static_cast<double>(force.size())),
               number(static_cast<double>(one.solution.contact.active().size())),
               std::to_string(way.residuals.size() - 1),
               std::to_string(one.solution.contact.report.iterations),
               std::to_string(two.report.iterations), std::to_string(three.report.iterations)});
    if (n != 40) continue;
    results.add("total_force", force.sum(), "N");
    Ledger ledger;
    const Model in_metres = build(round_block(n, {"m, N", 1e-3, 1}), ledger);
    const SaddlePointSolution four = saddle_point_newton(in_metres.programme, printed);
    const Table curves = histories(way, {&two.report, &three.report, &four.report});
    write_file(run.out / "fig_9_2.csv", curves.csv("rel 1e-3 abs 1e-9"));
  }
  std::cout << table.markdown();
  write_file(run.out / "newton.md", table.markdown());
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch09_newton");
  compare(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch09_newton", "All unknowns, or contact forces only", SIGNORINI_CHAPTER_OUT,
                     argc, argv, chapter);
}

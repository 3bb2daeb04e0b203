// Many bodies: stacks that contact alone holds, from the scene to the certificate, walls of bricks and piles of rigid discs with friction, and pairs
// with friction of which each moves all others.
// Run:  make many_bodies     Reads: nothing     Writes: stacks.md, walls.md, piles.md, dense.md and their .csv
// Without --full small ones only: a test that all are certified after few sets, not a measurement.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>

#include "addons/certified/solve_with_proofs.hpp"
#include "bench/measure.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/report/program.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/pile_of_discs.hpp"
#include "support/random.hpp"
#include "support/stack.hpp"

namespace {

using namespace signorini;
using namespace signorini::bench;

const Eigen::Index most_sets = 10;  // of a stack, whatever its height

/// Stacks of growing height. \return whether all are certified after few sets
bool measure_stacks(const std::vector<int>& heights, const ProgramOptions& options) {
  Table table({"blocks", "pairs", "unknowns", "sets", "certificate", "s", "growth as n to the"});
  bool good = true;
  double last = 0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const int height = heights[k];
    const double begin = processor_seconds();
    const Solution solution = solve(signorini_test::stack(height, 0));
    const double seconds = processor_seconds() - begin;
    const Report& report = solution.contact.report;
    good = good && report.status == SolveStatus::Solved && solution.certificate.holds() &&
           report.iterations <= most_sets;
    const double growth =
        k == 0 ? 0 : std::log(seconds / last) / std::log(1.0 * height / heights[k - 1]);
    table.row({std::to_string(height), std::to_string(solution.contact.force.size()),
               std::to_string(solution.refined.displacement.size()),
               std::to_string(report.iterations), number(solution.certificate.worst(), "%.1e"),
               number(seconds, "%.3f"), k == 0 ? "-" : number(growth, "%.2f")});
    last = seconds;
  }
  write_table(options.out, "stacks", table);
  return good;
}

/// Walls of n by n bricks, elastic and with friction. \return whether all are certified
bool measure_walls(const std::vector<int>& sizes, const ProgramOptions& options) {
  Table table({"bricks", "pairs", "unknowns", "steps", "certificate", "s"});
  bool good = true;
  for (const int n : sizes) {
    const double begin = processor_seconds();
    const Solution solution = solve(signorini_test::brick_wall(n, 0.5));
    const double seconds = processor_seconds() - begin;
    const Report& report = solution.contact.report;
    good = good && report.status == SolveStatus::Solved && solution.certificate.holds();
    table.row({std::to_string(n * n), std::to_string(solution.contact.force.size()),
               std::to_string(solution.refined.displacement.size()),
               std::to_string(report.iterations), number(solution.certificate.worst(), "%.1e"),
               number(seconds, "%.2f")});
  }
  write_table(options.out, "walls", table);
  return good;
}

/// Piles of n by n discs. \return whether no claim is false
bool measure_piles(const std::vector<Eigen::Index>& sizes, const ProgramOptions& options) {
  Table table({"discs", "pairs", "mu", "ended", "steps", "factors", "certificate", "s"});
  bool good = true;
  for (const Eigen::Index n : sizes)
    for (const double mu : {0.1, 0.3, 0.6}) {
      const ContactProblem problem = signorini_test::pile(n, n, mu);
      const double begin = processor_seconds();
      const ContactState state = solve_with_proofs(problem, primal_dual_active_set(), {});
      const double seconds = processor_seconds() - begin;
      const Certificate certificate = certify(problem, state);
      const bool solved = state.report.status == SolveStatus::Solved;
      good = good && solved == certificate.holds();
      table.row({std::to_string(n * n), std::to_string(problem.free_gap.size()), number(mu, "%g"),
                 to_string(state.report.status), std::to_string(state.report.iterations),
                 std::to_string(state.report.factorisations),
                 number(certificate.worst(), "%.1e"), number(seconds, "%.2f")});
    }
  write_table(options.out, "piles", table);
  return good;
}

/// F = C C^T + I/10 with numbers from -1 to 1 in C, gaps from -1 to 1/2, slips from -1 to 1.
ContactProblem dense_problem(Eigen::Index pairs, double mu) {
  signorini_test::Random random(static_cast<std::uint64_t>(pairs));
  const auto numbers = [&](Eigen::Index rows, Eigen::Index columns, double high) {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(
        rows, columns, [&] { return random.uniform(-1, high); }));
  };
  const Eigen::MatrixXd C = numbers(2 * pairs, 2 * pairs, 1);
  ContactProblem problem;
  problem.compliance = C * C.transpose();
  problem.compliance.diagonal().array() += 0.1;
  problem.free_gap = numbers(pairs, 1, 0.5);
  problem.free_slip = numbers(pairs, 1, 1);
  problem.law = law_of_all(Eigen::VectorXd::Constant(pairs, mu), Eigen::VectorXd::Zero(pairs));
  return problem;
}

/// Fifteen sizes for each coefficient. \return whether all are solved
bool measure_dense(Eigen::Index largest, const ProgramOptions& options) {
  Table table({"mu", "problems", "solved", "pairs at most", "worst certificate", "most s"});
  bool good = true;
  for (const double mu : {0.1, 0.3, 0.6}) {
    const int sizes = 15;
    int solved = 0;
    double certificate = 0;
    double most = 0;
    for (int k = 1; k <= sizes; ++k) {
      const ContactProblem problem = dense_problem(largest * k / sizes, mu);
      const double begin = processor_seconds();
      const ContactState state = solve_with_proofs(problem, primal_dual_active_set(), {});
      most = std::max(most, processor_seconds() - begin);
      certificate = std::max(certificate, certify(problem, state).worst());
      if (state.report.status == SolveStatus::Solved) ++solved;
    }
    good = good && solved == sizes && certificate <= certificate_tolerance;
    table.row({number(mu, "%g"), std::to_string(sizes), std::to_string(solved),
               std::to_string(largest), number(certificate, "%.1e"), number(most, "%.2f")});
  }
  write_table(options.out, "dense", table);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    const bool stacks = measure_stacks(
        options.full ? std::vector<int>{100, 300, 1000} : std::vector<int>{30, 60}, options);
    const bool walls = measure_walls(
        options.full ? std::vector<int>{5, 6, 8, 12} : std::vector<int>{4}, options);
    const bool piles = measure_piles(options.full ? std::vector<Eigen::Index>{10, 15, 20, 26}
                                                  : std::vector<Eigen::Index>{8},
                                     options);
    const bool dense = measure_dense(options.full ? 1000 : 60, options);
    const bool good = stacks && walls && piles && dense;
    std::cout << "\nall as it must be: " << (good ? "yes" : "NO") << '\n';
    return good ? SolveStatus::Solved : SolveStatus::Breakdown;
  };
  return run_program("many_bodies", "Stacks and piles of many bodies; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}

// Many bodies: stacks that contact alone holds, from the scene to the certificate, and piles of rigid discs with friction.
// Run:  make many_bodies     Reads: nothing     Writes: stacks.md, piles.md and their .csv
// Without --full small ones only: a test that all are certified after few sets, not a measurement.
#include <cmath>
#include <iostream>

#include "addons/certified/solve_with_proofs.hpp"
#include "bench/measure.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/report/program.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "support/pile_of_discs.hpp"
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

}  // namespace

int main(int argc, char** argv) {
  const auto body = [](const ProgramOptions& options) {
    const bool stacks = measure_stacks(
        options.full ? std::vector<int>{100, 300, 1000} : std::vector<int>{30, 60}, options);
    const bool piles = measure_piles(options.full ? std::vector<Eigen::Index>{10, 15, 20, 26}
                                                  : std::vector<Eigen::Index>{8},
                                     options);
    std::cout << "\nall as it must be: " << (stacks && piles ? "yes" : "NO") << '\n';
    return stacks && piles ? SolveStatus::Solved : SolveStatus::Breakdown;
  };
  return run_program("many_bodies", "Stacks and piles of many bodies; --full measures",
                     SIGNORINI_BENCH_OUT, argc, argv, body);
}

// Chapter 4 - Random programmes of the sizes of table 1: what the printed and the repaired method make of them.
// Run:  make ch04     Reads: nothing     Writes: ch04_sizes.results, sizes.md, fig_4_3.csv
// --full: ten times as many programmes, half a minute.
#include <algorithm>
#include <cmath>

#include "addons/programme/dense_programme.hpp"
#include "papers/examples.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/solvers/quasi_active_set.hpp"

namespace {

using namespace signorini;
using Eigen::Index;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// 1. Many programmes of one size, with all violated rows.
struct Size {
  double one = 0, optimal = 0, feasible = 0;  // runs that end after one step, and at a limit
  double violated = 0, fresh = 0;             // mean number of rows that overlap at u^0 and at u^1
  double crowded = 0;                         // runs in which the former outnumber the unknowns
  double repaired = 0;
  std::vector<double> steps, repaired_steps;
  std::vector<double> gap, lost, lost_whole;  // over the energy that contact adds, or all energy
};

void lose(Size& size, const KnownProgramme& known, const ContactProblem& problem,
          const ContactState& end, const ContactState& best) {
  const double added = -0.5 * best.force.dot(problem.free_gap + best.gap);  // by contact
  const double above = end.report.history.back().dual_energy + energy_gap(end) - added;
  size.gap.push_back(energy_gap(end) / added);
  size.lost.push_back(above / added);
  size.lost_whole.push_back(above / std::abs(known.energy));
}

Size try_size(Index n, Index m, std::uint64_t runs) {
  Size size;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const KnownProgramme known = rosen_suzuki(n, m, seed);
    const ContactProblem problem = condense(known.programme).problem;
    const QuasiActiveRun way = run_quasi_active_set_literal(problem);
    const ContactState repaired = quasi_active_set(problem);
    const bool solved = way.state.report.status == SolveStatus::Solved;
    const auto& history = way.state.report.history;
    size.violated += static_cast<double>(history[0].changes) / static_cast<double>(runs);
    size.fresh += static_cast<double>(history[1].changes) / static_cast<double>(runs);
    size.crowded += history[0].changes > n ? 1 : 0;
    size.repaired += repaired.report.status == SolveStatus::Solved ? 1 : 0;
    size.repaired_steps.push_back(static_cast<double>(repaired.report.iterations));
    ++(way.outer_steps <= 1 ? size.one : solved ? size.optimal : size.feasible);
    if (way.outer_steps > 1) size.steps.push_back(static_cast<double>(way.outer_steps));
    if (!solved) lose(size, known, problem, way.state, repaired);
  }
  return size;
}

// 2. All sizes.
SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch04_sizes");
  const std::uint64_t runs = run.full ? 1000 : 100;
  const double percent = 100 / static_cast<double>(runs);
  Table table({"n, m", "one step", "limit, optimal", "limit, feasible", "steps to the limit",
               "gap %, median", "gap %, worst", "repaired: solved", "its steps"});
  Table shares({"n", "m", "one", "limit", "feasible", "violated", "fresh"});
  double worst_gap = 0, repaired = 0, total = 0, independence = 0;
  for (const Index n : {10, 20, 50})
    for (const Index m : {n / 2, n, 2 * n, 4 * n}) {
      const Size s = try_size(n, m, runs);
      const double worst = s.gap.empty() ? 0 : *std::max_element(s.gap.begin(), s.gap.end());
      const auto share = [&](double count) { return number(percent * count, "%.0f %%"); };
      table.row({text(n, ", ", m), share(s.one), share(s.optimal), share(s.feasible),
                 number(median(s.steps), "%.0f"), number(100 * median(s.gap), "%.1f"),
                 number(100 * worst, "%.1f"), share(s.repaired),
                 number(median(s.repaired_steps), "%.0f")});
      shares.row({static_cast<double>(n), static_cast<double>(m), percent * s.one,
                  percent * s.optimal, percent * s.feasible, s.violated, s.fresh});
      const std::string name = text(n, '_', m);
      results.add("violated_" + name, s.violated, "-");
      results.add("fresh_" + name, s.fresh, "-");
      results.add("crowded_" + name, s.crowded, "-");
      results.add("lost_" + name, 100 * median(s.lost), "%");
      results.add("lost_whole_" + name, 100 * median(s.lost_whole), "%");
      independence = std::max(independence, std::abs(percent * s.one - 100 * std::exp(-s.fresh)));
      worst_gap = std::max(worst_gap, 100 * worst);
      repaired += s.repaired;
      total += static_cast<double>(runs);
    }
  write_file(run.out / "sizes.md", table.markdown());
  write_file(run.out / "fig_4_3.csv", shares.csv());
  results.add("runs_of_a_size", static_cast<double>(runs), "-");
  results.add("runs", total, "-");
  results.add("independence_error", independence, "%");
  results.add("worst_gap", worst_gap, "%");
  results.add("repaired_solved", repaired, "-");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch04_sizes", "Sizes of table 1", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}

#include "papers/printed_method.hpp"

#include <algorithm>
#include <iterator>

#include "papers/weight_iteration.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

namespace {

double is_in(const std::vector<Index>& sorted, Index pair) {
  return std::binary_search(sorted.begin(), sorted.end(), pair) ? 1 : 0;
}

}  // namespace

PrintedMethod printed_method(const ContactProblem& problem) {
  constexpr Index no_limit = 1000000;  // both rules end by themselves
  PrintedMethod run;
  run.all = run_quasi_active_set_literal(problem);
  run.one = run_quasi_active_set_literal(problem, {}, QuasiActiveRows::MostViolated);
  require_argument(!run.all.steps.empty(), "printed_method: no pair overlaps without contact");
  run.group = run.all.steps.front().quasi_active;
  const ContactProblem part{problem.compliance(run.group, run.group), problem.free_gap(run.group)};
  run.weights = weight_supports(part, WeightRule::FullyCorrective, no_limit);
  run.jumps =
      static_cast<Index>(weight_supports(part, WeightRule::LiteralVertex, no_limit).size()) - 1;
  return run;
}

bool solved_in_one_step(const ContactProblem& problem, const ContactState& solution) {
  const QuasiActiveRows readings[] = {QuasiActiveRows::AllViolated,
                                      QuasiActiveRows::IndependentByIndex,
                                      QuasiActiveRows::IndependentByViolation};
  return std::all_of(std::begin(readings), std::end(readings), [&](QuasiActiveRows rows) {
    const QuasiActiveRun run = run_quasi_active_set_literal(problem, {}, rows);
    return run.outer_steps == 1 && run.state.report.status == SolveStatus::Solved &&
           run.state.active == solution.active &&
           (run.state.force - solution.force).norm() <= 1e-9 * solution.force.norm();
  });
}

Table outer_steps(const QuasiActiveRun& run, const Eigen::VectorXd& at) {
  require_argument(at.size() == run.state.gap.size(), "outer_steps: need ", run.state.gap.size(),
                   " positions, one per pair, got ", at.size());
  Table table({"step", "at", "quasi_active", "closed"});
  for (std::size_t k = 0; k < run.steps.size(); ++k)
    for (const Index pair : run.steps[k].violated)
      table.row({static_cast<double>(k), at(pair), is_in(run.steps[k].quasi_active, pair),
                 is_in(run.steps[k].closed, pair)});
  return table;
}

Table inner_steps(const std::vector<std::vector<Index>>& supports, const Eigen::VectorXd& at) {
  Table table({"step", "at", "joins"});
  for (std::size_t k = 0; k < supports.size(); ++k)
    for (const Index pair : supports[k]) {
      require_argument(pair < at.size(), "inner_steps: pair ", pair, " has no position, there are ",
                       at.size());
      table.row({static_cast<double>(k), at(pair), k == 0 ? 1 : 1 - is_in(supports[k - 1], pair)});
    }
  return table;
}

void write_printed_method(const std::filesystem::path& stem, const PrintedMethod& run,
                          const Eigen::VectorXd& at) {
  write_file(stem.string() + "_all.csv", outer_steps(run.all, at).csv());
  write_file(stem.string() + "_one.csv", outer_steps(run.one, at).csv());
  write_file(stem.string() + "_inner.csv", inner_steps(run.weights, at(run.group)).csv());
}

void add_counts(Results& results, const PrintedMethod& run, const std::string& suffix) {
  const auto add = [&](const char* name, Index count) {
    results.add(name + suffix, static_cast<double>(count), "-");
  };
  add("pairs", run.all.state.gap.size());
  add("overlaps", static_cast<Index>(run.group.size()));
  add("closed", static_cast<Index>(run.all.state.active.size()));
  add("weight_steps", static_cast<Index>(run.weights.size()) - 1);
  add("jumps", run.jumps);
  add("single_steps", run.one.outer_steps);
  add("single_closed", static_cast<Index>(run.one.state.active.size()));
}

}  // namespace signorini

// # The printed method, looked at
//
// Chapters 6 and 7 show on their own problems what the method of the paper does: which pairs
// overlap before a step, which of them are taken, which the step presses, and how the weights of
// the first step come about. Two limiting cases of ours are run: all pairs that overlap are taken
// at once, or only the one that overlaps most.

#include "papers/printed_method.hpp"

#include <algorithm>
#include <iterator>

#include "papers/weight_iteration.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/scaled.hpp"

namespace signorini {

using Eigen::Index;

namespace {

// Sets of pairs are sorted, so that a member is found by halving.
// In a table, membership is the number 1 or 0.
double is_in(const std::vector<Index>& sorted, Index pair) {
  return std::binary_search(sorted.begin(), sorted.end(), pair) ? 1 : 0;
}

}  // namespace

// The first quasi-active set is a problem of its own. The best rule for its weights and the printed
// one are both run on it. The best one runs on scaled rows, as in surrogate_dual(). The printed one runs on
// the rows as they are, since the paper scales none, and we count the vertices that it jumps to before one
// comes back.
PrintedMethod printed_method(const ContactProblem& problem) {
  constexpr Index no_limit = 1000000;  // both rules end by themselves
  PrintedMethod run;
  run.all = run_quasi_active_set_literal(problem);
  run.one = run_quasi_active_set_literal(problem, {}, QuasiActiveRows::MostViolated);
  require_argument(!run.all.steps.empty(), "printed_method: no pair overlaps without contact");
  run.group = run.all.steps.front().quasi_active;
  const ContactProblem part{problem.compliance(run.group, run.group), problem.free_gap(run.group)};
  const ScaledProblem scaled = equilibrate(part);
  run.weights =
      weight_supports({scaled.compliance, scaled.free}, WeightRule::FullyCorrective, no_limit);
  run.jumps =
      static_cast<Index>(weight_supports(part, WeightRule::LiteralVertex, no_limit).size()) - 1;
  return run;
}

// If no pair overlaps after the first step, the problem is solved: the step presses only pairs that
// it closes. Three of the four choices are asked. The fourth takes one pair per step, so it needs
// at least as many steps as it presses pairs.
bool solved_in_one_step(const ContactProblem& problem, const ContactState& solution) {
  const QuasiActiveRows choices[] = {QuasiActiveRows::AllViolated,
                                     QuasiActiveRows::IndependentByIndex,
                                     QuasiActiveRows::IndependentByViolation};
  return std::all_of(std::begin(choices), std::end(choices), [&](QuasiActiveRows rows) {
    const QuasiActiveRun run = run_quasi_active_set_literal(problem, {}, rows);
    return run.outer_steps == 1 && run.state.report.status == SolveStatus::Solved &&
           run.state.active() == solution.active() &&
           (run.state.force - solution.force).norm() <= 1e-9 * solution.force.norm();
  });
}

// The rest of this file is bookkeeping: sets of pairs as rows of a table, which gnuplot draws as
// points, a row of points per step.
//
//     step,at,quasi_active,closed
//     0,12.5,1,1
//     0,25,1,0
//
// says of step 0 that two pairs overlapped, both were taken, and the first was pressed.
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

// A pair that carries weight now and did not one step before has joined; the figure marks it.
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

// Pairs of the first group are numbered within the group, so their positions are picked first.
void write_printed_method(const std::filesystem::path& stem, const PrintedMethod& run,
                          const Eigen::VectorXd& at) {
  write_file(stem.string() + "_all.csv", outer_steps(run.all, at).csv());
  write_file(stem.string() + "_one.csv", outer_steps(run.one, at).csv());
  write_file(stem.string() + "_inner.csv", inner_steps(run.weights, at(run.group)).csv());
}

// The sizes of the sets are what the text of a chapter quotes.
void add_counts(Results& results, const PrintedMethod& run, const std::string& suffix) {
  const auto add = [&](const char* name, Index count) {
    results.add(name + suffix, static_cast<double>(count), "-");
  };
  add("pairs", run.all.state.gap.size());
  add("overlaps", static_cast<Index>(run.group.size()));
  add("closed", static_cast<Index>(run.all.state.active().size()));
  add("weight_steps", static_cast<Index>(run.weights.size()) - 1);
  add("jumps", run.jumps);
  add("single_steps", run.one.outer_steps);
  add("single_closed", static_cast<Index>(run.one.state.active().size()));
}

}  // namespace signorini

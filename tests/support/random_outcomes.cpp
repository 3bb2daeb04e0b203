#include "support/random_outcomes.hpp"

#include <algorithm>
#include <chrono>

#include "signorini/core/errors.hpp"

namespace signorini_test {
namespace {

using namespace signorini;

Outcome ending(const Solution& solution) {
  if (!solution.escape.empty()) return Outcome::Escaped;
  switch (solution.contact.report.status) {
    case Status::Solved:
      return Outcome::Solved;
    case Status::Infeasible:
      return Outcome::Infeasible;
    case Status::Ray:
      return Outcome::Ray;
    case Status::Jump:
      return Outcome::Jump;
    case Status::IterationLimit:
      return Outcome::Limit;
    case Status::Feasible:
    case Status::Breakdown:
      break;
  }
  return Outcome::Breakdown;
}

bool says_undetermined(const Solution& solution) {
  return std::any_of(solution.notes.begin(), solution.notes.end(), [](const std::string& note) {
    return note.find("do not determine") != std::string::npos;
  });
}

void say_end(const Solution& solution, Trial& trial) {
  const ContactState& contact = solution.contact;
  trial.text += text("\n  ", to_string(contact.report.status), " after ", contact.report.iterations,
                     " of ", contact.gap.size(), " pairs, ", solution.certificate, ' ',
                     solution.escape, contact.reason);
}

/// Keeps the worst of what is called solved.
void judge(const SceneErrors& errors, const Solution& solution, Trial& trial) {
  if (!(errors.worst() < trial.errors.worst())) trial.errors = errors;
  if (trial.outcome == Outcome::Wrong) return;
  if (!errors.held) trial.outcome = says_undetermined(solution) ? Outcome::Hovers : Outcome::Unsaid;
  if (!(errors.worst() <= most_error)) trial.outcome = Outcome::Wrong;
}

void try_once(const Scene& scene, void (*change)(Solution& solution), Trial& trial) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  Solution solution = solve(model, condense(model, ledger), std::move(ledger));
  trial.outcome = ending(solution);
  say_end(solution, trial);
  if (trial.outcome != Outcome::Solved) return;
  if (change != nullptr) change(solution);
  judge(check_scene(model, solution), solution, trial);
}

/// What stands in the way of the next step of a path.
Outcome try_next(const Scene& scene, const PathState& state, Trial& trial) {
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  const double time =
      *std::upper_bound(scene.path->times.begin(), scene.path->times.end(), state.time);
  const Solution solution = step(state, time, model, path, {}).solution;
  say_end(solution, trial);
  return ending(solution);
}

void try_path(const Scene& scene, void (*change)(Solution& solution), Trial& trial) {
  CheckedPath check(scene);
  trial.outcome = Outcome::Solved;
  const PathEnd end = solve_steps(scene, [&](const Model& model, Step step) {
    if (change != nullptr) {
      change(step.solution);
      step.state.solution = step.solution.refined;
    }
    judge(check.add(model, step), step.solution, trial);
  });
  trial.imbalance = check.imbalance();
  trial.halvings = end.halvings;
  if (end.status == Status::Solved) {
    if (!check.balances()) trial.outcome = Outcome::Wrong;
    return;
  }
  trial.text += "\n  " + end.reason;
  if (trial.outcome == Outcome::Wrong) return;
  trial.outcome = try_next(scene, end.state, trial);
  // As far as it went, the path was right; a whole step that is solved where its halves were not is a limit of them.
  if (trial.outcome == Outcome::Solved) trial.outcome = Outcome::Limit;
}

}  // namespace

Trial try_scene(std::uint64_t seed, RandomScenes kind, const std::string& solver,
                void (*change)(Solution& solution)) {
  RandomScene drawn = random_scene(seed, kind);
  if (!solver.empty()) drawn.scene.solver = solver;
  Trial trial;
  trial.text = std::move(drawn.text);
  const auto start = std::chrono::steady_clock::now();
  try {
    if (drawn.scene.path)
      try_path(drawn.scene, change, trial);
    else
      try_once(drawn.scene, change, trial);
  } catch (const ProblemError& error) {
    trial.outcome = Outcome::Refused;
    trial.text += text("\n  ", error.what());
  } catch (const std::exception& error) {
    trial.outcome = Outcome::Threw;
    trial.text += text("\n  ", error.what());
  }
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return trial;
}

}  // namespace signorini_test

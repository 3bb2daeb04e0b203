#include "support/random_outcomes.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <initializer_list>
#include <utility>

#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/lemke.hpp"
#include "support/balance.hpp"
#include "support/checked_motion.hpp"

namespace signorini_test {
namespace {

using namespace signorini;

/// Most that two methods may differ by: each is refined, and what is small beside the largest displacement may be lost.
constexpr double most_difference = 1e-9;

Outcome ending(const Solution& solution) {
  if (!solution.unbounded_direction.empty()) return Outcome::Escaped;
  switch (solution.contact.report.status) {
    case SolveStatus::Solved:
      return Outcome::Solved;
    case SolveStatus::Infeasible:
      return Outcome::Infeasible;
    case SolveStatus::Ray:
      return Outcome::Ray;
    case SolveStatus::Jump:
      return Outcome::Jump;
    case SolveStatus::IterationLimit:
      return Outcome::Limit;
    case SolveStatus::Feasible:
    case SolveStatus::Breakdown:
    case SolveStatus::SlidTooFar:
      break;
    case SolveStatus::TurnedTooFar:
      return Outcome::Turned;
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
                     solution.unbounded_direction, contact.reason);
}

void fold(const Eigen::VectorXd& values, std::uint64_t& bits) {
  for (const double value : values) {
    std::uint64_t own = 0;
    std::memcpy(&own, &value, sizeof own);
    bits = (bits ^ own) * 0x100000001b3;  // FNV-1a, by whole numbers
  }
}

void remember(const Solution& solution, Trial& trial) {
  for (const ContactStatus contact_status : solution.contact.contact_status)
    trial.statuses += "osfb"[static_cast<std::size_t>(contact_status)];
  trial.statuses += '.';
  fold(solution.refined.force, trial.bits);
  fold(solution.refined.displacement, trial.bits);
}

/// Keeps the worst of what is called solved.
void judge(const SceneErrors& errors, const Solution& solution, Trial& trial) {
  if (!(errors.worst() < trial.errors.worst())) trial.errors = errors;
  if (trial.outcome == Outcome::Wrong) return;
  if (!errors.held) trial.outcome = says_undetermined(solution) ? Outcome::Hovers : Outcome::Unsaid;
  if (!(errors.worst() <= most_error)) trial.outcome = Outcome::Wrong;
}

/// Another method with another way to the solution.
Solver other_method(const Model& model) {
  const Solver usual = Scene().solver;
  if (model.solver.solve != usual.solve) return usual;
  return model.law.pair.empty() ? lemke() : fischer_burmeister();
}

/// Whether another method finds other gaps or forces where the solution is the only one: those of pairs without
/// friction are, if pairs that carry hold the bodies, and so are those of which the library has proved it. The forces
/// are compared by what they do, since pairs that depend on each other may share one.
bool differs(const Model& model, const Solution& solution, Trial& trial) {
  const bool frictional = !model.law.pair.empty();
  if (model.pairs.weight.size() == 0) return false;
  if (frictional && solution.contact.uniqueness != Uniqueness::Proved) return false;
  Ledger ledger;
  const Condensed condensed = condense(model, ledger);
  const Solution other = solve(model, condensed, other_method(model), std::move(ledger));
  if (other.contact.report.status != SolveStatus::Solved) return false;
  const Eigen::VectorXd moved = solution.refined.displacement - other.refined.displacement;
  const double apart = moved.cwiseAbs().maxCoeff();
  const double size =
      std::max(solution.refined.displacement.cwiseAbs().maxCoeff(), trial.errors.length);
  trial.text += text("\n  ", other_method(model).name, " differs by ", apart, " of ", size);
  return !(apart <= most_difference * size);
}

void try_once(const Scene& scene, bool twice, void (*change)(Solution& solution), Trial& trial) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  Solution solution = solve(model, condense(model, ledger), std::move(ledger));
  trial.outcome = ending(solution);
  say_end(solution, trial);
  if (trial.outcome != Outcome::Solved) return;
  remember(solution, trial);
  if (change != nullptr) change(solution);
  SceneErrors errors = check_scene(model, solution);
  errors.balance = unbalanced(model, solution);
  judge(errors, solution, trial);
  if (twice && trial.outcome == Outcome::Solved && differs(model, solution, trial))
    trial.outcome = Outcome::Disputed;
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

/// The same of bodies that move. Work is not added up.
void try_motion(const Scene& scene, void (*change)(Solution& solution), Trial& trial) {
  Eigen::VectorXd before;
  trial.outcome = Outcome::Solved;
  const PathEnd end = solve_steps(scene, [&](const Model& model, Step step) {
    remember(step.solution, trial);
    if (change != nullptr) change(step.solution);
    judge(check_motion(scene, model, before, step), step.solution, trial);
    before = all_displacements(model, step.solution.displacements);
  });
  trial.halvings = end.halvings;
  if (end.status == SolveStatus::Solved || trial.outcome == Outcome::Wrong) return;
  trial.text += "\n  " + end.reason;
  trial.outcome = try_next(scene, end.state, trial);
  if (trial.outcome == Outcome::Solved) trial.outcome = Outcome::Limit;
}

void try_path(const Scene& scene, void (*change)(Solution& solution), Trial& trial) {
  CheckedPath check(scene);
  trial.outcome = Outcome::Solved;
  const PathEnd end = solve_steps(scene, [&](const Model& model, Step step) {
    remember(step.solution, trial);
    if (change != nullptr) {
      change(step.solution);
      step.state.solution = step.solution.refined;
    }
    judge(check.add(model, step), step.solution, trial);
  });
  trial.imbalance = check.imbalance();
  trial.halvings = end.halvings;
  if (end.status == SolveStatus::Solved) {
    if (!(check.imbalance() <= most_imbalance)) trial.outcome = Outcome::Wrong;
    return;
  }
  trial.text += "\n  " + end.reason;
  if (trial.outcome == Outcome::Wrong) return;
  trial.outcome = try_next(scene, end.state, trial);
  // As far as it went, the path was right; a whole step that is solved where its halves were not is a limit of them.
  if (trial.outcome == Outcome::Solved) trial.outcome = Outcome::Limit;
}

}  // namespace

bool is_clear(const std::string& message) {
  const auto has = [&](std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return message.find(word) != std::string::npos; });
  };
  const bool names =
      message.find('\'') != std::string::npos || has({"scene", "load", "gauss_points", "mortar"});
  const bool says = has({"must", "need", "expect", "can", "unknown", "neither", "refers", "gets",
                         "folds", " is ", " are ", " no ", " not ", " has ", " have ", " lies "});
  const bool helps = has({"must", "ive ", "se ", "ake ", "dd ", "eave ", "ove ", "hange ", "ook ",
                          "old ", "urn ", "expected", "here are", "the scene has", "needs",
                          "it has", "those that", "nearest", "but the "});
  return names && says && helps && message.size() < 2000;
}

Trial try_scene(std::uint64_t seed, RandomScenes kind, const std::string& solver,
                void (*change)(Solution& solution)) {
  RandomScene drawn = random_scene(seed, kind);
  if (!solver.empty()) drawn.scene.solver = find_solver(solver);
  // The linear problem is looked at, whether its pairs are those of bodies that moved or not.
  for (ContactSpec& contact : drawn.scene.contacts)
    contact.small_sliding = kind != RandomScenes::Moving;
  Trial trial;
  trial.text = std::move(drawn.text);
  const auto start = std::chrono::steady_clock::now();
  try {
    if (kind == RandomScenes::Moving)
      try_motion(drawn.scene, change, trial);
    else if (drawn.scene.path)
      try_path(drawn.scene, change, trial);
    else
      try_once(drawn.scene, kind == RandomScenes::Any && solver.empty(), change, trial);
  } catch (const ProblemError& error) {
    trial.outcome = is_clear(error.what()) ? Outcome::Refused : Outcome::Unclear;
    trial.text += text("\n  ", error.what());
  } catch (const std::exception& error) {
    trial.outcome = Outcome::Threw;
    trial.text += text("\n  ", error.what());
  }
  const bool honest = trial.outcome == Outcome::Refused || is_fault(trial.outcome);
  if (drawn.wrong && !honest) trial.outcome = Outcome::Accepted;
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return trial;
}

}  // namespace signorini_test

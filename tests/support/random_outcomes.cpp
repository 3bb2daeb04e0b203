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

}  // namespace

Trial try_scene(std::uint64_t seed, RandomScenes kind, const std::string& solver,
                void (*change)(Solution& solution)) {
  RandomScene drawn = random_scene(seed, kind);
  if (!solver.empty()) drawn.scene.solver = solver;
  Trial trial;
  trial.text = std::move(drawn.text);
  const auto start = std::chrono::steady_clock::now();
  try {
    Ledger ledger;
    const Model model = build(drawn.scene, ledger);
    Solution solution = solve(model, condense(model, ledger), std::move(ledger));
    trial.outcome = ending(solution);
    trial.text += text("\n  ", to_string(solution.contact.report.status), " after ",
                       solution.contact.report.iterations, " of ", model.pairs.weight.size(),
                       " pairs, ", solution.certificate, ' ', solution.escape);
    trial.text += solution.contact.reason;
    if (trial.outcome == Outcome::Solved) {
      if (change != nullptr) change(solution);
      trial.errors = check_scene(model, solution);
      if (!trial.errors.held)
        trial.outcome = says_undetermined(solution) ? Outcome::Hovers : Outcome::Unsaid;
      if (!(trial.errors.worst() <= most_error)) trial.outcome = Outcome::Wrong;
    }
  } catch (const ProblemError& error) {
    trial.text += text("\n  ", error.what());
  } catch (const std::exception& error) {
    trial.outcome = Outcome::Threw;
    trial.text += text("\n  ", error.what());
  }
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return trial;
}

}  // namespace signorini_test

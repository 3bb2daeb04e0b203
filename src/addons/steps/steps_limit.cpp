#include "addons/steps/steps_limit.hpp"

#include <algorithm>
#include <vector>

#include "addons/certified/proofs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// What the loads of a time do along the rigid modes.
VectorXd resultant_at(double time, const Model& model, const Eigen::MatrixXd& modes) {
  VectorXd load = VectorXd::Zero(model.unknowns.count);
  for (const LoadPart& part : model.parts) load += factor_of(model.path.histories, part.history, time) * part.load;
  return rigid_resultant(load, modes, direction_rounding(model.modes));
}

/// The scene in one step in which all that loads it grows from nothing.
Scene grown(Scene scene) {
  const History load = proportional("load");
  for (Body& body : scene.bodies)
    each_history(body, [&](std::string& history) { history = load.name; });
  for (const Effect& effect : effects())
    if (effect.grow != nullptr) effect.grow(scene, load.name);
  scene.path = Path{{1}, {load}};
  return scene;
}

}  // namespace

std::optional<double> balanced_until(double begin, double end, const Model& model,
                                     ContactProblem problem) {
  std::vector<double> times = {end};
  for (const History& history : model.path.histories)
    for (const double row : history.times)
      if (row > begin && row < end) times.push_back(row);
  std::sort(times.begin(), times.end());
  const Eigen::MatrixXd modes = mode_shapes(model.modes);
  VectorXd before = resultant_at(begin, model, modes);
  for (const double time : times) {
    problem.resultant = resultant_at(time, model, modes);
    const double share = balanced_share(problem, before);
    // What not even the first loads leave in balance has no limit, unless these are none.
    if (share <= 0 && !before.isZero(0)) return std::nullopt;
    if (share < 1) return begin + share * (time - begin);
    before = problem.resultant;
    begin = time;
  }
  return std::nullopt;
}

std::optional<double> first_change(const PathState& past, const ContactProblem& problem) {
  if (past.steps == 0) return std::nullopt;
  const ScaledProblem scaled = equilibrate(problem);
  const ActiveSetSolution end = solve_active_set(scaled, past.contact_status);
  if (!end.solvable) return std::nullopt;
  const VectorXd& now = past.solution.force;
  const VectorXd then = scaled.scale.cwiseProduct(end.force);
  double share = 1;
  const auto use_up = [&share](double room, double left) {
    if (left < 0) share = std::min(share, std::max(0.0, room / (room - left)));
  };
  const Index pairs = scaled.pairs();
  for (Index i = 0; i < pairs; ++i)
    if (past.contact_status[at(i)] != ContactStatus::Open) use_up(now(i), then(i));
  const FrictionLaw& law = problem.law;
  for (Index k = 0; k < law.coefficient.size(); ++k) {
    const Index pair = law.pair[at(k)];
    if (past.contact_status[at(pair)] != ContactStatus::Stick) continue;
    const auto room = [&](const VectorXd& force, double sign) {
      return law.coefficient(k) * force(pair) + law.cohesion(k) - sign * force(pairs + k);
    };
    for (const double sign : {-1.0, 1.0}) use_up(room(now, sign), room(then, sign));
  }
  return share < 1 ? std::optional<double>(share) : std::nullopt;
}

Solution solve_to_limit(const Scene& scene) {
  require_input(!scene.path, "the scene has load steps: solve_steps() solves it step by step");
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense_as_needed(model, ledger);
  return solve_to_limit(scene, model, condensed, std::move(ledger));
}

Solution solve_to_limit(const Scene& scene, const Model& model, const Condensed& condensed,
                        Ledger ledger) {
  Solution solution = solve(model, condensed, std::move(ledger));
  const SolveStatus status = solution.contact.report.status;
  if (status == SolveStatus::Solved || status == SolveStatus::SlidTooFar || solution.limit)
    return solution;
  if (std::none_of(scene.contacts.begin(), scene.contacts.end(), has_friction)) return solution;
  const PathEnd end = solve_steps(grown(scene));
  solution.limit = end.limit;
  if (end.status == SolveStatus::Solved)
    solution.notes.emplace_back(
        "not solved at once, but load steps solve it: grown from nothing in proportion, all of the "
        "load is held");
  return solution;
}

}  // namespace signorini

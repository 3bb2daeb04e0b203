#include "support/checked_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"
#include "support/checked_path.hpp"
#include "support/energy_forces.hpp"
#include "support/random_outcomes.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

/// The scene with everything that is held kept where it is.
Scene held_scene(Scene scene) {
  for (Body& body : scene.bodies)
    for (Support& support : body.supports)
      support.displacement = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); };
  return scene;
}

/// The scene with its bodies where a step has them, held there.
Scene moved_scene(Scene scene, const std::vector<NodeArray>& displacements) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    scene.bodies[b].mesh.nodes += displacements[b];
  return held_scene(std::move(scene));
}

/// The scene of a time as one that stands still, with the strains of small ones: for all but forces of bodies.
Scene still_scene(const Scene& scene, double time) {
  Scene still = at_time(scene, time);
  still.moves = false;
  for (Body& body : still.bodies) body.material.law = nullptr;
  return still;
}

/// Puts what bodies with a law answer into p, and takes them out of K. Where nothing loads them, forces are none that
/// rounding of displacements makes.
void answer_by_laws(const Scene& scene, const Scene& still, const Model& model,
                    const PrimalDual& found, QuadraticProgramme& programme) {
  Ledger ledger;
  const Model held = build(held_scene(still), ledger);  // so that p has the loads only
  const bool unloaded = held.programme.load.isZero(0) && found.force.isZero(0);
  const double rounding = 16 * 0x1p-52 * programme.stiffness.diagonal().maxCoeff() *
                          model.unknowns.held.cwiseAbs().maxCoeff();
  std::vector<bool> answered(static_cast<std::size_t>(programme.load.size()), false);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Material& material = scene.bodies[b].material;
    if (material.law == nullptr) continue;
    const BodyModel& body = model.bodies[b];
    const auto number = model.unknowns.number.middleRows(body.first_node, body.mesh.n_nodes());
    LongNodes u =
        model.unknowns.held.middleRows(body.first_node, body.mesh.n_nodes()).cast<long double>();
    for (Index node = 0; node < u.rows(); ++node)
      for (const Index axis : {0, 1})
        if (const Index k = number(node, axis); k >= 0)
          u(node, axis) = static_cast<long double>(found.displacement(k)) +
                          (found.displacement_low.size() > 0 ? found.displacement_low(k) : 0);
    const LongNodes force = energy_forces(body.mesh, body.element, material, u);
    for (Index node = 0; node < u.rows(); ++node)
      for (const Index axis : {0, 1}) {
        const Index k = number(node, axis);
        if (k < 0) continue;
        answered[at(k)] = true;
        programme.load(k) = static_cast<double>(held.programme.load(k) - force(node, axis));
        if (unloaded && std::abs(programme.load(k)) <= rounding) programme.load(k) = 0;
      }
  }
  programme.stiffness.prune(
      [&](Index row, Index /*column*/, double /*value*/) { return !answered[at(row)]; });
}

/// Whether friction does work on what its pair has slid since the last step. To first order the pair has slid along its
/// present tangent; what it has come nearer by counts to that as far as the tangent has turned. So only pairs are asked that
/// have slid a share of how far any has, and more than half of how far they have come.
/// \return infinity if it does
double driven(const Model& model, const VectorXd& moved, const ContactState& contact) {
  const VectorXd slid = selected_rows(model.pairs.sliding, model.law.pair) * moved;
  const VectorXd came = selected_rows(model.pairs.opening, model.law.pair) * moved;
  if (slid.size() == 0) return 0;
  const double least = 0.25 * slid.cwiseAbs().maxCoeff();
  for (Index k = 0; k < slid.size(); ++k)
    if (std::abs(slid(k)) > std::max(least, 0.5 * std::abs(came(k))) &&
        std::abs(contact.slip(k)) > least && contact.friction(k) * slid(k) > 0)
      return HUGE_VAL;
  return 0;
}

}  // namespace

SceneErrors check_motion(const Scene& scene, const Model& model, const VectorXd& before,
                         const Step& step) {
  Ledger ledger;
  const Scene now = still_scene(scene, step.state.time);
  Model check = build(now, ledger);
  const Model there = build(moved_scene(now, step.solution.displacements), ledger);
  SceneErrors errors;
  if (there.pairs.node != model.pairs.node) {
    errors.reading = HUGE_VAL;
    return errors;
  }
  const Index pairs = there.pairs.weight.size();
  const Index slips = static_cast<Index>(model.law.pair.size());
  const VectorXd& u = step.solution.refined.displacement;
  const VectorXd all = all_displacements(model, step.solution.displacements);
  // Meshes are moved by what is left of that in their positions.
  NodeArray rest(all.size() / 2, 2);
  for (std::size_t b = 0; b < check.bodies.size(); ++b) {
    const BodyModel& body = check.bodies[b];
    rest.middleRows(body.first_node, body.mesh.n_nodes()) =
        step.solution.displacements[b] - (there.bodies[b].mesh.nodes - body.mesh.nodes);
  }
  const NodalRows slip_rows = model.programme.A.bottomRows(slips);
  check.pairs = there.pairs;
  check.law = model.law;
  check.standing = model.standing;
  check.contact_of = model.contact_of;
  check.programme.A = below(NodalRows(there.programme.A.topRows(pairs)), slip_rows);
  check.programme.initial_gap = check.programme.A * u;
  check.programme.initial_gap.head(pairs) +=
      there.pairs.initial_gap +
      there.pairs.opening * Eigen::Map<const VectorXd>(rest.data(), rest.size());
  check.programme.initial_gap.tail(slips) += step.solution.contact.slip;
  // One rounding of a position is no error: it is `most_error` of the length that others are measured by at least.
  const double rounding = 0x1p-52 * there.pairs.position.cwiseAbs().maxCoeff();
  const double stiffest = check.programme.stiffness.diagonal().maxCoeff();
  answer_by_laws(scene, now, model, step.solution.refined, check.programme);
  errors = check_scene(check, step.solution, rounding / most_error, stiffest);
  if (pairs > 0)
    grow(errors.reading, (there.pairs.weight - model.pairs.weight).cwiseAbs().maxCoeff() /
                             there.pairs.weight.maxCoeff());
  grow(errors.sliding,
       driven(model, before.size() == 0 ? all : VectorXd(all - before), step.solution.contact));
  return errors;
}

}  // namespace signorini_test

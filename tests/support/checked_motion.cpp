#include "support/checked_motion.hpp"

#include <cmath>

#include "signorini/core/index.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"
#include "support/checked_path.hpp"
#include "support/random_outcomes.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

/// The scene with its bodies where a step has them, held there.
Scene moved_scene(Scene scene, const std::vector<NodeArray>& displacements) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    scene.bodies[b].mesh.nodes += displacements[b];
    for (Support& support : scene.bodies[b].supports)
      support.displacement = [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); };
  }
  return scene;
}

}  // namespace

SceneErrors check_motion(const Scene& scene, const Model& model, const VectorXd& before,
                         const Step& step) {
  Ledger ledger;
  Scene now = at_time(scene, step.state.time);
  now.moves = false;
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
  errors = check_scene(check, step.solution, rounding / most_error);
  // Friction does no work on what its pair has slid since the last step, but where that is a share of how far the step went.
  const VectorXd moved = before.size() == 0 ? all : VectorXd(all - before);
  const VectorXd slid = selected_rows(model.pairs.sliding, model.law.pair) * moved;
  const double far = slid.size() == 0 ? 0 : slid.cwiseAbs().maxCoeff();
  for (Index k = 0; k < slips; ++k)
    if (std::abs(slid(k)) > 0.25 * far && step.solution.contact.friction(k) * slid(k) > 0 &&
        std::abs(step.solution.contact.slip(k)) > 0.25 * far)
      errors.sliding = HUGE_VAL;
  return errors;
}

}  // namespace signorini_test

#include <algorithm>

#include "addons/effects/springs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini::effect {
namespace {

using Eigen::Index;

bool resists(const Spring& spring) { return (spring.stiffness.array() != 0).any(); }

bool on_springs(const Body& body) {
  return std::any_of(body.springs.begin(), body.springs.end(), resists);
}

/// A rigid motion that a spring resists, however little, is not free: the rows of the spring go into K.
void declare_springs(const Scene& scene, Plan& draft) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!on_springs(body)) continue;
    draft.bodies[b].springs = spring_stiffness(body.mesh, depth_of(body.material), body.springs);
    for (const Spring& spring : body.springs)
      if (resists(spring))
        draft.on.push_back(text("springs at '", spring.boundary, "' of '", body.mesh.name, "': (",
                                spring.stiffness.x(), ", ", spring.stiffness.y(),
                                spring.only_at ? "), at one node" : "), all along"));
  }
  draft.modes = rigid_modes(draft.bodies);
}

/// K does no work along a rigid motion but for its rounding. Says so where springs that alone stop the motion are not
/// much stiffer than that: the certificate, which takes K as it is, cannot.
void note_soft_springs(const BodyModel& body, Model& model) {
  const QuadraticProgramme& programme = model.programme;
  for (const FreeMotion& motion :
       free_motions(body.mesh, body.pieces, body.unknowns, body.material.base.state)) {
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(programme.load.size());
    const Eigen::VectorXd shape = motion.shape;
    moves.segment(body.first_unknown, shape.size()) = shape.cwiseAbs();
    const double rounding = epsilon * moves.dot(programme.stiffness.cwiseAbs() * moves);
    Eigen::VectorXd nodes = Eigen::VectorXd::Zero(body.springs.cols());
    for (Index k = 0; k < nodes.size(); ++k)
      if (const Index own = body.unknowns.number(k / 2, k % 2); own >= 0)
        nodes(k) = shape(own);
    const double resisted = nodes.dot(body.springs * nodes);
    if (resisted > 0 && rounding > 1e-8 * resisted)
      model.notes.push_back(
          text(in_words(motion), " but for its springs, which are so soft beside ",
               "the body that rounding changes this motion by up to ", 100 * rounding / resisted,
               " %: make them stiffer, or add a support"));
  }
}

}  // namespace

Effect springs() {
  return {"springs",
          [](const Scene& scene, const Plan& /*draft*/) {
            return std::any_of(scene.bodies.begin(), scene.bodies.end(), on_springs);
          },
          declare_springs,
          [](Model& model) {
            for (const BodyModel& body : model.bodies)
              if (body.springs.rows() > 0) {
                note_soft_springs(body, model);
                add_springs(body, model.programme);
              }
          }};
}

}  // namespace signorini::effect

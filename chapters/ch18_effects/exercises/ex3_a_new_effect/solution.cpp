#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex18_3 {
namespace {

using namespace signorini;
using Eigen::Vector2d;

bool spins(const std::optional<Spin>& spin) {
  return spin && spin->density != 0 && spin->speed != 0;
}

VectorField centrifugal(const Spin& spin, PlaneState state) {
  const double factor = spin.density * spin.speed * spin.speed;
  const double along_y = state == PlaneState::Axial ? 0 : factor;
  return [=](const Vector2d& x) -> Vector2d {
    const Vector2d arm = x - spin.centre;
    return {factor * arm.x(), along_y * arm.y()};
  };
}

}  // namespace

bool present(const SpinningScene& spinning) {
  return std::any_of(spinning.spin.begin(), spinning.spin.end(), spins);
}

void declare(const SpinningScene& spinning, Plan& draft) {
  require_input(spinning.spin.size() == draft.bodies.size(), "spin: expected one entry per body, ",
                draft.bodies.size(), ", got ", spinning.spin.size());
  for (std::size_t b = 0; b < draft.bodies.size(); ++b) {
    if (!spins(spinning.spin[b])) continue;
    const Spin& spin = *spinning.spin[b];
    const std::string what = text("spin of '", draft.bodies[b].mesh.name, "': ");
    require_input(std::isfinite(spin.density) && spin.density > 0, what,
                  "the density must be > 0, got ", spin.density,
                  "; leave the spin out if there is no mass");
    require_input(std::isfinite(spin.speed) && spin.centre.allFinite(), what,
                  "speed and centre must be finite");
    require_input(
        draft.bodies[b].material.base.state != PlaneState::Axial || spin.centre.x() == 0, what,
        "a body of revolution turns about its axis x = 0, not about x = ", spin.centre.x());
    draft.on.push_back(text(what, "speed ", spin.speed, ", density ", spin.density));
  }
}

void add(const SpinningScene& spinning, Model& model) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!spins(spinning.spin[b])) continue;
    BodyModel& body = model.bodies[b];
    const VectorField force = centrifugal(*spinning.spin[b], body.material.base.state);
    const NodeArray nodal =
        nodal_loads(body.mesh, body.element, body.material, Loads{force, {}, {}});
    for (Eigen::Index node = 0; node < body.mesh.n_nodes(); ++node)
      for (int axis = 0; axis < 2; ++axis)
        if (const Eigen::Index unknown = body.unknowns.number(node, axis); unknown >= 0)
          model.programme.load(body.first_unknown + unknown) += nodal(node, axis);
    const VectorField given = body.loads.body_force;
    body.loads.body_force = [given, force](const Vector2d& x) -> Vector2d {
      return given ? Vector2d(given(x) + force(x)) : force(x);
    };
  }
}

}  // namespace ex18_3

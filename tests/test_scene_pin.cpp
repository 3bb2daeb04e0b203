// A rigid pin in an elastic plate, Xuan & Li 2002, section 4, example 3.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "reference/pin.hpp"
#include "signorini/closed_form/pin.hpp"
#include "signorini/complementarity/solvers.hpp"
#include "signorini/mesh/annulus.hpp"
#include "signorini/scene/solved.hpp"
#include "support/message.hpp"
#include "support/pin.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::pin_in_plate;

namespace {

const double degree = std::acos(-1.0) / 180;

/// What the pin does to the half hole, from its pole on, the pole included.
struct Bearing {
  Eigen::VectorXd angle;     // from the pole [rad]
  Eigen::VectorXd force;     // of the half model [kN]
  Eigen::VectorXd pressure;  // [kN/cm^2]
  double resultant;          // of both halves, along x [kN/cm]
  double right;              // u_x in the middle of the right side [cm]
};

Bearing bearing(const Scene& scene) {
  const SolvedScene run = solved(scene, "the pin");
  const double side = scene.loads.edges.front().pressure > 0 ? 1 : -1;
  const std::vector<Index> nodes = boundary_nodes(scene.mesh, "hole");
  const Eigen::VectorXd weight = boundary_weights(scene.mesh, "hole", 1);
  const NodeArray support = support_forces(run.model, scene.loads, run.solution);
  const Index n = static_cast<Index>(nodes.size());
  Bearing out{Eigen::VectorXd(n), Eigen::VectorXd::Zero(n), Eigen::VectorXd(n), 0, 0};
  for (Index k = 0; k < n; ++k) {
    const Index place = side > 0 ? n - 1 - k : k;  // the hole is walked from its left pole
    const Index node = nodes[static_cast<std::size_t>(place)];
    const Vector2d x = scene.mesh.nodes.row(node);
    out.angle(k) = std::atan2(x.y(), side * x.x());
    for (Index pair = 0; pair < run.solution.contact.force.size(); ++pair)
      if (run.model.gaps.node[static_cast<std::size_t>(pair)] == node)
        out.force(k) = run.solution.contact.force(pair);
    if (k == 0) out.force(k) = side * support(node, 0);
    out.pressure(k) = out.force(k) / weight(place);
    out.resultant += 2 * side * out.force(k) * std::cos(out.angle(k));
  }
  out.right = run.solution.displacements(boundary_nodes(scene.mesh, "right").front(), 0);
  return out;
}

/// Linear between nodes.
double at(const Bearing& bearing, double angle) {
  Index k = 1;
  while (k + 1 < bearing.angle.size() && bearing.angle(k) < angle) ++k;
  const double t = (angle - bearing.angle(k - 1)) / (bearing.angle(k) - bearing.angle(k - 1));
  return (1 - t) * bearing.pressure(k - 1) + t * bearing.pressure(k);
}

}  // namespace

// Tolerances: half a unit of the last digit of the reference.
TEST_CASE("the pin reproduces the mesh-exact forces, the pole included", "[pin][reference]") {
  for (const reference::PinReading& expected : reference::pin_readings) {
    CAPTURE(expected.name);
    const Bearing now = bearing(pin_in_plate(expected.pressure));
    REQUIRE(now.force.size() == 16);
    for (Index k = 0; k < 16; ++k) {
      CAPTURE(k);
      CHECK(now.angle(k) == Approx(12 * k * degree).margin(1e-14));
      const double force = k < 8 ? expected.force[static_cast<std::size_t>(k)] : 0;
      CHECK(now.force(k) == Approx(force).epsilon(1e-7).margin(6e-8));
    }
    CHECK(now.right == Approx(expected.right_displacement).epsilon(0).margin(6e-7));
  }
}

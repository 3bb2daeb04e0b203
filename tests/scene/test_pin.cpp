// A rigid pin in an elastic plate, Xuan & Li 2002, section 4, example 3.
#include <cmath>

#include "catch_compat.hpp"
#include "reference/pin.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/pin.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::pin_in_plate;

namespace {

const double degree = pi / 180;

/// What the pin does to the half hole, from its pole on, the pole included.
struct Bearing {
  Eigen::VectorXd angle;     // from the pole [rad]
  Eigen::VectorXd force;     // of the half model [kN]
  Eigen::VectorXd pressure;  // [kN/cm^2]
  double resultant;          // of both halves, away from the pole [kN/cm]
  double right;              // u_x in the middle of the right side [cm]
};

Bearing bearing(const Scene& scene) {
  const SolvedScene run = solved(scene, "the pin");
  const double side = scene.bodies[0].loads.edges.front().pressure > 0 ? 1 : -1;
  const BoundaryForces hole = boundary_forces(run, {"hole"});  // from the left pole to the right
  const Index n = hole.weight.size();
  Bearing out{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), 0, 0};
  for (Index k = 0; k < n; ++k) {
    const Index place = side > 0 ? n - 1 - k : k;
    const Eigen::RowVector2d x = hole.position.row(place);
    out.angle(k) = std::atan2(x.y(), side * x.x());
    out.force(k) = hole.force.row(place).dot(x) / 5;
    out.pressure(k) = out.force(k) / hole.weight(place);
    out.resultant += 2 * side * hole.force(place, 0);
  }
  out.right =
      run.solution.displacements[0](boundary_nodes(scene.bodies[0].mesh, "right").front(), 0);
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
      CHECK(now.angle(k) == Approx(12 * static_cast<double>(k) * degree).margin(1e-14));
      const double force = k < 8 ? expected.force[static_cast<std::size_t>(k)] : 0;
      CHECK(now.force(k) == Approx(force).epsilon(1e-7).margin(6e-8));
    }
    CHECK(now.right == Approx(expected.right_displacement).epsilon(0).margin(6e-7));
  }
}

// 1e-10: what the displacements in doubles leave of the balance; the digits that matter are more.
TEST_CASE("the pin bears the load of both halves", "[pin]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"})
    for (const double q : {-25.0, 25.0}) {
      CAPTURE(element, q);
      const Bearing now = bearing(pin_in_plate(q, 15, 15, 0.2, element));
      CHECK(now.resultant == Approx(500).epsilon(1e-10).margin(0));
      CHECK(now.force.minCoeff() >= 0);  // the pole too: its support could be a pair
    }
}

// Reference of five digits on other meshes. Within two cells of the edge a square root ends: not compared.
TEST_CASE("60 x 30 cells have the converged pressures to two percent", "[pin][reference]") {
  for (const reference::PinReading& expected : reference::pin_readings) {
    CAPTURE(expected.name);
    const Bearing now = bearing(pin_in_plate(expected.pressure, 60, 30));
    for (int k = 0; k < 8; ++k) {
      CAPTURE(k);
      CHECK(at(now, 10 * k * degree) ==
            Approx(expected.limit[static_cast<std::size_t>(k)]).epsilon(0.02).margin(0.1));
    }
    CHECK(now.right == Approx(expected.limit_displacement).epsilon(0.003));
  }
}

TEST_CASE("a part of load and clearance gives that part of the pressure", "[pin][units]") {
  const Bearing whole = bearing(pin_in_plate(-25));
  const Bearing part = bearing(pin_in_plate(-1, 15, 15, 0.2 / 25));
  CHECK((25 * part.force - whole.force).norm() < 1e-12 * whole.force.norm());
}

// Contact that every element must get exactly right, on any mesh.
#include <cmath>

#include "catch_compat.hpp"
#include "signorini/scene/scene.hpp"
#include "support/chosen.hpp"
#include "support/meshes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::block_for;
using signorini_test::chosen;
using signorini_test::distorted;

namespace {

/// A block 3 wide and 2 high whose top is pushed down by 0.1 onto a base that is 0.04 away.
Scene pressed_block(const Element& element, PlaneState state) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = distorted(block_for(element, {3, 2}, 4, 3), {3, 2}, {0.75, 2.0 / 3.0}, 21);
  body.element = element.name;
  body.material = {500, 0.3, state, 0.7};
  body.supports = {symmetric("left"), prescribed("top", Axis::Y, -0.1)};
  scene.contacts = {{{"bottom"}, half_plane({0, -0.04}, {0, 1})}};
  return scene;
}

}  // namespace

// Closed form: uniform pressure E' (delta - g) / h, E' = E in plane stress and E / (1 - nu^2) in plane strain.
TEST_CASE("every element: a pressed block has the uniform pressure of the closed form",
          "[conformance][closed-form]") {
  for (const Element& element : chosen(elements()))
    for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain}) {
      CAPTURE(element.name);
      const Scene scene = pressed_block(element, state);
      const Solution solution = solve(scene);
      REQUIRE(solution.contact.report.status == SolveStatus::Solved);
      const double modulus = state == PlaneState::Stress ? 500 : 500 / (1 - 0.09);
      const double pressure = modulus * (0.1 - 0.04) / 2;
      REQUIRE(solution.contact.active().size() ==
              boundary_nodes(scene.bodies[0].mesh, "bottom").size());
      for (Index pair = 0; pair < solution.pressure.size(); ++pair)
        CHECK(solution.pressure(pair) == Approx(pressure).epsilon(1e-11).margin(0));
      CHECK(solution.contact.force.sum() == Approx(pressure * 3 * 0.7).epsilon(1e-11).margin(0));
      // Sideways the block grows freely by nu' p / E'.
      const double nu = state == PlaneState::Stress ? 0.3 : 0.3 / 0.7;
      const Index corner = boundary_nodes(scene.bodies[0].mesh, "right").front();
      CHECK(solution.displacements[0](corner, 0) == Approx(nu * 0.03 * 3).epsilon(1e-11).margin(0));
      CHECK(solution.certificate.holds());
    }
}

TEST_CASE("every element: a block that is not pushed far enough stays free of force",
          "[conformance]") {
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    Scene scene = pressed_block(element, PlaneState::Stress);
    scene.bodies[0].supports = {symmetric("left"), prescribed("top", Axis::Y, -0.03)};
    const Solution solution = solve(scene);
    CHECK(solution.contact.active().empty());
    CHECK(solution.contact.force.norm() == 0);
    for (Index pair = 0; pair < solution.contact.gap.size(); ++pair)
      CHECK(solution.contact.gap(pair) == Approx(0.01).epsilon(1e-11).margin(0));
  }
}

TEST_CASE("every element: a block on a slanted plane has the same pressure as on a level one",
          "[conformance]") {
  // Everything turned by 30 degrees: supports by given displacements, the plane and the push with it.
  const double c = std::sqrt(0.75);
  const double s = 0.5;
  Eigen::Matrix2d R;
  R << c, -s, s, c;
  const double nu = 0.3;
  const VectorField pushed = [&](const Vector2d& x) {
    const Vector2d level = R.transpose() * x;
    return Vector2d(R * Vector2d(0.03 * nu * level.x(), -0.1));
  };
  for (const Element& element : chosen(elements())) {
    CAPTURE(element.name);
    Scene scene = pressed_block(element, PlaneState::Stress);
    scene.bodies[0].mesh =
        mapped(scene.bodies[0].mesh, [&](const Vector2d& x) { return Vector2d(R * x); });
    scene.bodies[0].supports = {{"top", true, true, pushed, false}};
    scene.contacts = {{{"bottom"}, half_plane(R * Vector2d(0, -0.04), R * Vector2d(0, 1))}};
    const Solution solution = solve(scene);
    REQUIRE(solution.contact.report.status == SolveStatus::Solved);
    for (Index pair = 0; pair < solution.pressure.size(); ++pair)
      CHECK(solution.pressure(pair) == Approx(15).epsilon(1e-11).margin(0));
  }
}

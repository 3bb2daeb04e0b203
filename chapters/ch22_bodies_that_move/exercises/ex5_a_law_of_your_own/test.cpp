#include <cmath>

#include "addons/motion/register.hpp"
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/strain_laws.hpp"

using namespace ex22_5;
using namespace signorini;

namespace {

const Lame rubber{3, 2};

Components gradient(double a, double b, double c, double d, double e) {
  return (Components() << a, b, c, d, e).finished();
}

StressResponse at(const Lame& lame, const Components& H) {
  StressResponse response;
  stress(lame, H, response);
  return response;
}

// A unit block of modulus 1 between smooth plates, pressed to half of its height in ten steps: the force at the end.
double pressed(const StrainLaw* law) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.element = "q4";
  body.mesh = block("block", {0, 0}, {1, 1}, 2, 2);
  body.material = {1, 0.3, PlaneState::Strain, 1};
  body.material.law = law;
  body.supports = {symmetric("bottom"), symmetric("left"), prescribed("top", Axis::Y, -0.5)};
  body.supports[2].history = "press";
  scene.path = Path{equal_steps(10), {proportional("press")}};
  double force = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
    force = 0;
    const NodeArray all = support_forces(model, step.solution);
    for (const Eigen::Index node : boundary_nodes(model.bodies[0].mesh, "top"))
      force -= all(node, 1);
  });
  REQUIRE(end.status == SolveStatus::Solved);
  return force;
}

}  // namespace

TEST_CASE("ex22.5 a stretch along x", "[ex22.5]") {
  const Components P = at(rubber, gradient(0.1, 0, 0, 0, 0)).piola;
  CHECK(P(0) == Approx(2 * (1.1 - 1 / 1.1) + 1.5 * (1.21 - 1) / 1.1).epsilon(1e-13));
  CHECK(P(3) == Approx(1.5 * (1.21 - 1)).epsilon(1e-13));
  CHECK(P(4) == Approx(1.5 * (1.21 - 1)).epsilon(1e-13));
  CHECK(P(1) == Approx(0).margin(1e-15));
  CHECK(at(rubber, Components::Zero()).piola.norm() == Approx(0).margin(1e-15));
}

TEST_CASE("ex22.5 each the derivative of the one before", "[ex22.5]") {
  const Components H = gradient(0.2, 0.3, -0.2, -0.1, 0.15);
  const StressResponse here = at(rubber, H);
  const double h = 6e-6;
  for (int k = 0; k < 5; ++k) {
    CAPTURE(k);
    const Components D = h * Components::Unit(k);
    const StressResponse up = at(rubber, H + D), down = at(rubber, H - D);
    CHECK(here.piola(k) == Approx((up.energy - down.energy) / (2 * h)).epsilon(1e-8));
    CHECK((here.tangent.col(k) - (up.piola - down.piola) / (2 * h)).norm() < 1e-7);
  }
}

// Nothing presses on the sides, so mu (w^2 - 1) + lambda/2 (w^2 s^2 - 1) = 0 gives the width w at the height s = 1/2.
TEST_CASE("ex22.5 a block that is pressed to half of its height", "[ex22.5]") {
  register_motion();
  add_strain_law(quadratic_volume());
  const double mu = 1 / 2.6, lambda = 0.3 / (1.3 * 0.4), s = 0.5;
  const double width_squared = (mu + lambda / 2) / (mu + lambda / 2 * s * s);
  const double exact = -(mu * (s * s - 1) + lambda / 2 * (width_squared * s * s - 1)) / s;
  CHECK(exact == Approx(0.9413).epsilon(1e-4));
  CHECK(pressed(find_strain_law("quadratic_volume")) == Approx(exact).epsilon(1e-10));
}

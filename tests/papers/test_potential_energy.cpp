// The energy that contact makes least: the strains of the mesh less the work of the load, and the form K, p.
#include <cmath>

#include "catch_compat.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/random.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/scene.hpp"

using namespace signorini;

namespace {

// A block of 3 x 2 under the pressure 5 at its top, on rollers at the bottom and at the left.
Scene pressed_block(double foundation) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {3, 2}, 6, 4);
  body.material = {/*E*/ 100, /*nu*/ 0.25, PlaneState::Stress, /*thickness*/ 2};
  body.supports = {prescribed("left", Axis::X, 0.0), prescribed("bottom", Axis::Y, 0.0)};
  body.loads.edges = {{"top", 5, {}}};
  if (foundation > 0)  // above the block, out of reach or in touch
    scene.contacts = {{{"right"}, half_plane({3 + foundation, 0}, {-1, 0})}};
  return scene;
}

}  // namespace

// sigma_y = -5, u_y = -5 y / 100, and the least energy is minus half of the work: -1/2 25/100 V with V = 12.
TEST_CASE("the least energy of a block under pressure is that of the theory of elasticity",
          "[energy][closed-form][XuanLi2002-9][XuanLi2002-10][XuanLi2002-12]") {
  Ledger ledger;
  const Scene scene = pressed_block(1);
  const Model model = build(scene, ledger);
  const Solution solution = solve(scene);
  const double energy = potential_energy(model.programme, solution.refined.displacement);
  CHECK(energy == Approx(-1.5).epsilon(1e-13));
  const auto& body = model.bodies[0];
  const double stored =
      strain_energy(body.mesh, body.element, body.material, solution.displacements[0]);
  CHECK(stored == Approx(1.5).epsilon(1e-13));
  // The top sinks by 0.1 under a force of 5 * 3 * 2.
  CHECK(energy == Approx(stored - 30 * 0.1).epsilon(1e-13));
}

// The wall at the right is 0.01 away; pressed, the block would widen by 0.25 * 0.05 * 3 = 0.0375.
TEST_CASE("of displacements that do not overlap, that of the solution has the least energy",
          "[energy][XuanLi2002-9][XuanLi2002-11][XuanLi2002-12]") {
  Ledger ledger;
  const Scene scene = pressed_block(0.01);
  const QuadraticProgramme programme = build(scene, ledger).programme;
  const Solution solution = solve(scene);
  const Eigen::VectorXd& u = solution.refined.displacement;
  REQUIRE(solution.contact.force.sum() > 0);
  const double least = potential_energy(programme, u);
  CHECK(least > -1.5);  // the wall takes work
  CHECK(least == Approx(lagrangian(programme, u, solution.contact.force)).epsilon(1e-12));
  const Eigen::VectorXd slope = programme.stiffness * u - programme.load;
  Random random(3);
  for (int sample = 0; sample < 50; ++sample) {
    Eigen::VectorXd w = u;
    for (double& entry : w) entry += 0.01 * random.uniform(-1, 1);
    w -= programme.A.transpose() * (programme.A * w - programme.initial_gap).cwiseMax(0.0);
    // Rows of A have length 1, each its own node.
    REQUIRE((programme.A * w - programme.initial_gap).maxCoeff() <= 1e-14);
    // (A 7): energy does not fall from u towards w; rounding of terms of size 1.
    CHECK(slope.dot(w - u) >= -1e-12);
    // With all gaps as they are there is neither a way down nor up.
    CHECK(std::abs(slope.dot(w - u - programme.A.transpose() * (programme.A * (w - u)))) <= 1e-12);
    CHECK(potential_energy(programme, w) > least);
  }
  CHECK_THROWS_AS(potential_energy(programme, Eigen::VectorXd::Zero(3)), std::invalid_argument);
}

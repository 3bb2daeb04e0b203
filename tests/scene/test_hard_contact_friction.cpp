// Friction between two bodies at both ends of its range, of bodies that float, and where it cannot act.
#include <cmath>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/hertz.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// A disc ten times stiffer than its plate, which draws the plate's surface together.
Scene stiffer_disc(double coefficient, double ratio = 10, Index cells = 10, double lift = 0) {
  HertzProblem given;
  given.disc_modulus *= ratio;
  given.lift = lift;
  given.mesh.disc_cells = given.mesh.plate_cells = cells;
  Scene scene = scene_of(given);
  scene.contacts[0].friction = Friction{coefficient, 0};
  return scene;
}

/// A block pressed on a wider one by 0.01 and pulled to the right by 0.002.
Scene pulled_block(double coefficient) {
  Scene scene = two_blocks(named_block("lower", {-2, -2}, {4, 2}, 14, 6),
                           named_block("upper", {-1, 0}, {2, 1}, 9, 4));
  scene.bodies[1].supports = {prescribed("top", Axis::Y, -0.01), prescribed("top", Axis::X, 0.002)};
  scene.contacts[0].friction = Friction{coefficient, 0};
  return scene;
}

}  // namespace

// 1e-6: the bound is nearly nothing, and the forces differ from those without friction by that share. 1e4: nothing
// slides; a higher coefficient changes nothing any more. Methods that differ agree.
TEST_CASE("hardly any friction, and friction that nothing overcomes", "[contact][hard][friction]") {
  for (const bool floats : {true, false}) {
    const auto scene_with = [&](double mu) { return floats ? stiffer_disc(mu) : pulled_block(mu); };
    const SolvedScene smooth = solved(scene_with(0), "without friction");
    for (const char* solver : {"primal_dual_active_set", "fischer_burmeister", "lemke"}) {
      CAPTURE(floats, solver);
      const auto run = [&](double mu) {
        Scene scene = scene_with(mu);
        scene.solver = find_solver(solver);
        return solved(scene, "with friction");
      };
      const SolvedScene little = run(1e-6);
      const ContactState& slides = little.solution.contact;
      CHECK(little.solution.certificate.worst() <= 1e-13);
      CHECK((slides.force - smooth.solution.contact.force).norm() <= 2e-6 * slides.force.norm());
      CHECK(slides.friction.cwiseAbs().maxCoeff() > 0);
      const Eigen::VectorXd bound = 1e-6 * slides.force(slides.frictional_pairs);
      CHECK(((slides.friction.cwiseAbs() - bound).array() <= 1e-20).all());

      const SolvedScene much = run(1e4);
      const ContactState& sticks = much.solution.contact;
      CHECK(much.solution.certificate.worst() <= 1e-13);
      for (std::size_t k = 0; k < sticks.frictional_pairs.size(); ++k)
        if (sticks.force(sticks.frictional_pairs[k]) > 0)
          CHECK(std::abs(sticks.slip(static_cast<Index>(k))) <= 1e-14);
      const Eigen::VectorXd one = run(1).solution.contact.friction;
      CHECK((sticks.friction - one).norm() <= 1e-9 * one.norm());
    }
  }
}

// What rounding makes of K times a rigid motion must not pile up at one node.
TEST_CASE("friction of bodies that float is certified on fine meshes too",
          "[contact][hard][friction]") {
  for (const double ratio : {1.0, 1e3, 1e9})
    for (const double lift : {0.0, 0.1, 1000.0}) {
      CAPTURE(ratio, lift);
      const SolvedScene run = solved(stiffer_disc(0.3, ratio, 32, lift), "the disc");
      CHECK(run.solution.certificate.worst() <= 2e-14);
      CHECK(run.solution.contact.force.sum() == Approx(hertz_load / 2).epsilon(1e-11));
    }
}

// On the axis of a half-model nothing slides and any friction force would do; a whole model has none there.
TEST_CASE("a pair that supports keep from sliding has no friction", "[contact][hard][friction]") {
  for (const char* solver : {"primal_dual_active_set", "lemke", "friction_split"}) {
    CAPTURE(solver);
    Scene scene = stiffer_disc(0.3);
    scene.solver = find_solver(solver);
    const SolvedScene run = solved(scene, "the disc");
    REQUIRE(run.model.pairs.position(0, 0) == 0);
    CHECK(run.solution.contact.force(0) > 0);
    CHECK(run.solution.contact.frictional_pairs.front() == 1);
    const NodeArray on_disc = contact_forces(run.model, run.solution, 0);
    const Index pole = run.model.pairs.node[0];
    CHECK(std::abs(on_disc(pole, 0)) <= 1e-15);
  }
}

// Friction in scenes: published and mesh-exact values, and what friction must not change.
#include <cmath>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "reference/published.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"
#include "support/message.hpp"
#include "support/paths.hpp"
#include "support/same_scenes.hpp"

using Eigen::Index;
using namespace signorini;
using namespace signorini_test;

namespace {

/// The square block pressed on a rough plane of the GRECO benchmark, half of it, in metres and pascal.
Scene rough_block(const char* element, double coefficient) {
  BlockSpec spec;
  spec.size.x() = 0.04;
  spec.size.y() = 0.04;
  spec.cells_x = 32;
  spec.cells_y = 32;
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = make_block(spec);
  body.element = element;
  body.material = {1.3e11, 0.2, PlaneState::Strain, 1};
  body.supports = {symmetric("right"), prescribed_at("bottom", {0.04, 0}, Axis::Y)};
  body.loads.edges = {{"top", 5e7, {}}, {"left", 15e7, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{coefficient, 0};
  return scene;
}

/// A block on a wider block, pressed by q and dragged along by s.
Scene dragged_block(double q, double s, Friction law) {
  Scene scene;
  scene.bodies.resize(2);
  BlockSpec spec;
  spec.size.x() = 4;
  spec.size.y() = 1;
  spec.cells_x = 12;
  spec.cells_y = 3;
  spec.name = "ground";
  scene.bodies[0].mesh = make_block(spec);
  scene.bodies[0].supports = {fixed("bottom")};
  spec.size.x() = 2;
  spec.cells_x = 8;
  spec.name = "slab";
  scene.bodies[1].mesh = moved(make_block(spec), {1, 1});
  scene.bodies[1].loads.edges = {
      {"top", q, [s](const Eigen::Vector2d&) { return Eigen::Vector2d(s, 0); }}};
  for (Body& body : scene.bodies) body.material = {1000, 0.3, PlaneState::Strain, 1};
  scene.contacts = {{{"bottom", "slab"}, Side{"top", "ground"}}};
  scene.contacts[0].friction = law;
  return scene;
}

}  // namespace

// The means of several programs are met to 0.3 %, but for the last place, where they fall 2.7 % short. Code_Aster's
// own triangles on a penalty slide 0.4 to 1.1 % further: a penalty gives way before it slides. A mesh of 128 x 128
// of another program, at all five places, is met to 0.4 %.
TEST_CASE("a block pressed on a rough plane slides as far as published", "[friction][reference]") {
  for (const char* element : {"q4", "q4_incompatible"}) {
    const SolvedScene run = solved(rough_block(element, 1), "the block");
    const Index at[5] = {0, 1, 4, 6, 9};
    const double converged[5] = {2.8603e-5, 2.7226e-5, 2.2867e-5, 1.9807e-5, 1.5413e-5};
    for (int k = 0; k < 5; ++k) {
      CAPTURE(element, k);
      const double slip = run.solution.displacements[0](at[k], 0);
      const double off = std::abs(slip / reference::rough_block_slip[k] - 1);
      CHECK(off <= (k < 4 ? 0.003 : reference::rough_block_tolerance));
      CHECK(std::abs(slip / converged[k] - 1) <= 0.004);
      CHECK(slip < reference::rough_block_slip_aster[k]);
      CHECK(slip > 0.988 * reference::rough_block_slip_aster[k]);
    }
  }
}

TEST_CASE("a block pressed on a rough plane: its mesh's own displacements, forces and states",
          "[friction]") {
  struct Case {
    const char* element;
    double displacement[5];  // of the lower side at 0, 1.25, 5, 7.5, 11.25 mm, in 1e-5 m
    double normal;
    double tangential;
  };
  // Computed with another program on the same mesh and elements, all digits printed.
  for (const Case& expected :
       {Case{
            "q4", {2.8594382, 2.7216850, 2.2849985, 1.9796271, 1.5405644}, 1.947574e6, -1.405376e6},
        Case{"q4_incompatible",
             {2.8602823, 2.7225483, 2.2857099, 1.9800111, 1.5407947},
             1.947574e6,
             -1.404927e6}}) {
    const Scene scene = rough_block(expected.element, 1);
    const SolvedScene run = solved(scene, "the block");
    const ContactState& state = run.solution.contact;
    CHECK(run.solution.certificate.holds());
    CHECK(state.report.iterations <= 25);
    const Index at[5] = {0, 1, 4, 6, 9};
    for (int k = 0; k < 5; ++k)
      CHECK(run.solution.displacements[0](at[k], 0) ==
            Approx(1e-5 * expected.displacement[k]).epsilon(1e-7).margin(0));
    CHECK(state.force.sum() == Approx(expected.normal).epsilon(1e-6).margin(0));
    CHECK(state.friction.sum() == Approx(expected.tangential).epsilon(1e-6).margin(0));
    for (Index k = 0; k < 32; ++k) {
      const ContactStatus status = state.contact_status[static_cast<std::size_t>(k)];
      CHECK(status == (k < 3    ? ContactStatus::Open
                       : k < 24 ? ContactStatus::SlipForward
                                : ContactStatus::Stick));
    }
    const NodeArray forces = support_forces(run.model, run.solution);
    const NodeArray contact = contact_forces(run.model, run.solution);
    CHECK(forces.col(0).sum() + contact.col(0).sum() == Approx(-15e7 * 0.04).epsilon(1e-9));
    CHECK(forces.col(1).sum() + contact.col(1).sum() == Approx(5e7 * 0.04).epsilon(1e-9));
  }
}

TEST_CASE("a block pressed on a rough plane in five steps ends as in one", "[friction][steps]") {
  Scene scene = rough_block("q4", 1);
  const Solution whole = solve(scene);
  for (EdgeLoad& load : scene.bodies[0].loads.edges) load.history = "load";
  for (const int count : {1, 5}) {
    scene.path = Path{equal_steps(count), {proportional("load")}};
    const Step last = steps_of(scene).back();
    CHECK(last.solution.contact.contact_status == whole.contact.contact_status);
    CHECK(last.solution.contact.active() == whole.contact.active());
    CHECK((last.solution.displacements[0] - whole.displacements[0]).norm() <=
          1e-12 * whole.displacements[0].norm());
    CHECK((last.state.slip - whole.contact.slip).norm() <= 1e-12 * whole.contact.slip.norm());
  }
}

TEST_CASE("no coefficient and no cohesion is no friction", "[friction]") {
  const Scene rough = rough_block("q4", 0);
  Scene smooth = rough;
  smooth.contacts[0].friction.reset();
  const Solution a = solve(rough);
  const Solution b = solve(smooth);
  CHECK(a.contact.frictional_pairs.empty());
  CHECK(a.contact.force == b.contact.force);
  // A coefficient that cannot be felt takes the other road and comes to the same place.
  const Solution c = solve(rough_block("q4", 1e-14));
  REQUIRE(c.contact.friction.size() == c.contact.force.size());
  CHECK((c.contact.force - b.contact.force).norm() <= 1e-12 * b.contact.force.norm());
}

TEST_CASE("a slab that nothing but friction holds sticks, and slides off when dragged too hard",
          "[friction][floating]") {
  const SolvedScene held = solved(dragged_block(10, 2, {0.5, 0}), "the slab");
  const ContactState& state = held.solution.contact;
  CHECK(held.solution.certificate.holds());
  CHECK(state.force.sum() == Approx(20).epsilon(1e-12));
  CHECK(state.friction.sum() == Approx(-4).epsilon(1e-12));
  CHECK_THROWS_WITH(solved(dragged_block(10, 6, {0.5, 0}), "the slab"),
                    ContainsSubstring("slab") && ContainsSubstring("not solved"));
  // The same push is held by cohesion: 6 < 0.5 * 10 + 2 everywhere if the pressure were even.
  CHECK_NOTHROW(solved(dragged_block(10, 3, {0.1, 4}), "the slab"));
  CHECK_THROWS_WITH(
      plan(dragged_block(10, 2, {0, 0})),
      ContainsSubstring("can move freely in direction x") && ContainsSubstring("add a support"));
}

TEST_CASE("friction in other units is the same friction", "[friction][units]") {
  const Scene first = dragged_block(10, 2, {0.25, 0.1});
  const double length = 1e6;
  const double force = 1e-3 * length * length;
  const ContactState a = solved(first, "the slab").solution.contact;
  const ContactState b = solved(in_units(first, length, force), "the slab").solution.contact;
  CHECK((b.friction / force - a.friction).norm() <= 1e-10 * a.friction.norm());
  CHECK((b.slip / length - a.slip).norm() <= 1e-10 * a.slip.norm());
  CHECK(b.contact_status == a.contact_status);
}

TEST_CASE("a friction law that is none is refused", "[friction][input]") {
  CHECK_THROWS_WITH(plan(rough_block("q4", -0.3)),
                    ContainsSubstring("friction coefficient") &&
                        ContainsSubstring("must be a number >= 0, got -0.3"));
  Scene scene = rough_block("q4", 1);
  scene.solver = find_solver("quasi_active_set");
  CHECK_THROWS_WITH(plan(scene), ContainsSubstring("'quasi_active_set' takes no friction") &&
                                     ContainsSubstring("primal_dual_active_set"));
}

TEST_CASE("slender plates with friction are certified from K, p, A and g",
          "[friction][certificate]") {
  for (const double thickness : {0.05, 0.02, 0.01}) {
    CAPTURE(thickness);
    Scene scene;
    Body& plate = scene.bodies[0];
    plate.mesh = block("plate", {0, 0}, {1, thickness}, 60, 2);
    plate.material = {1000, 0.3, PlaneState::Strain, 1};
    plate.supports = {fixed("left")};
    plate.loads.edges = {{"top", 0.01, {}}};
    scene.contacts = {{{"bottom"}, half_plane({0, -0.001}, {0, 1})}};
    scene.contacts[0].friction = Friction{0.4, 0};
    const SolvedScene run = solved(scene, "the plate");
    CHECK(run.solution.certificate.holds());
    const NodeArray moved = run.solution.displacements[0];
    for (const Index pair : run.solution.contact.active())
      CHECK(std::abs(0.001 + moved(run.model.pairs.node[static_cast<std::size_t>(pair)], 1)) <=
            1e-14 * moved.cwiseAbs().maxCoeff() + 1e-18);
  }
}

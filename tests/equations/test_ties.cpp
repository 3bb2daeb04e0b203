// Two sides that hold together: forces in tension, beams of two bodies, gaps that are closed or kept, and what lies beside them.
#include <cmath>

#include "addons/equations/equations.hpp"
#include "catch_compat.hpp"
#include "support/tied_stack.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace signorini;
using namespace stacked_blocks;

// Pulled up by 2 on 6 x 1: the tie holds the upper body down by 12, with a tension of 2 everywhere, and a moment of -36
// about the origin.
TEST_CASE("a tie carries tension, and its forces balance the load", "[ties]") {
  for (const std::string& element : all_elements) {
    CAPTURE(element);
    Scene scene = stack(element);
    load_uniformly({0, 2, 0}, 0, scene);
    const SolvedScene run = solved(scene, "the stack");
    const std::vector<BondForces> sums = bond_forces(run.model, run.solution);
    REQUIRE(sums.size() == 1);
    CHECK(sums[0].name == "upper.bottom to lower.top");
    CHECK(sums[0].force.x() == Approx(0).margin(1e-10));
    CHECK(sums[0].force.y() == Approx(-12).epsilon(1e-11));
    CHECK(sums[0].moment == Approx(-36).epsilon(1e-11));
    CHECK(sums[0].least_pressure == Approx(-2).epsilon(1e-9));
    CHECK(sums[0].largest_pressure == Approx(-2).epsilon(1e-9));
    CHECK(sums[0].largest_shear == Approx(0).margin(1e-9));
    for (std::size_t b = 0; b < 2; ++b) {
      const NodeArray supports = support_forces(run.model, run.solution, b);
      CHECK(supports.cwiseAbs().maxCoeff() == Approx(0).margin(1e-10));
    }
  }
}

// A cantilever 12 long of two halves end to end, pulled down at its end: across the tie go the shear force 0.3 and the moment of
// that force at the arm 6. Its tip sinks as that of one body does, but for what the coarser mesh beside the tie makes of it.
TEST_CASE("a beam of two bodies bends as one", "[ties]") {
  for (const std::string element : {"q4_incompatible", "q8", "t6"}) {
    CAPTURE(element);
    const Material material{1000, 0.3, PlaneState::Stress};
    EdgeLoad pull;
    pull.boundary = "right";
    pull.traction = [](const Vector2d&) { return Vector2d(0, -0.3); };
    Scene one;
    one.bodies = {body_of(block_of(element, "beam", {0, 0}, {12, 1}, 48, 4), element, material)};
    one.bodies[0].supports = {fixed("left")};
    one.bodies[0].loads.edges = {pull};
    Scene two;
    two.bodies = {body_of(block_of(element, "root", {0, 0}, {6, 1}, 24, 4), element, material),
                  body_of(block_of(element, "tip", {6, 0}, {6, 1}, 24, 3), element, material)};
    two.bodies[0].supports = {fixed("left")};
    two.bodies[1].loads.edges = {pull};
    two.bonds = bonds_of({tie_of({"left", "tip"}, Side{"right", "root"})});
    const SolvedScene whole = solved(one, "the beam");
    const SolvedScene halves = solved(two, "the halves");
    const double sinks = whole.solution.displacements[0].col(1).minCoeff();
    CHECK(halves.solution.displacements[1].col(1).minCoeff() == Approx(sinks).epsilon(5e-3));
    const BondForces sum = bond_forces(halves.model, halves.solution).front();
    CHECK(sum.force.x() == Approx(0).margin(1e-9));
    CHECK(sum.force.y() == Approx(0.3).epsilon(1e-10));
    CHECK(sum.moment == Approx(0.3 * 12).epsilon(1e-9));  // of the load about the origin, turned round
    CHECK(-sum.least_pressure == Approx(sum.largest_pressure).epsilon(0.05));
  }
}

// Two bars of length 2 between two walls, 0.01 apart: closed, they are stretched by that over the length 4.
TEST_CASE("a gap of a tie is closed, or stays", "[ties]") {
  for (const std::string& element : all_elements) {
    CAPTURE(element);
    Scene scene = stack(element, {}, 0.01);
    for (Body& body : scene.bodies) body.material.poisson_ratio = 0;
    scene.bodies[0].supports = {fixed("bottom")};
    scene.bodies[1].supports = {fixed("top")};
    CHECK(largest_displacement(solved(scene, "the kept one").solution) == 0);
    Tie tie = scene.bonds->ties[0];
    tie.closes = true;
    scene.bonds = bonds_of({tie});
    const SolvedScene closed = solved(scene, "the closed one");
    const double tension = 1000 * 0.01 / 4;
    CHECK(stress_error(closed, {0, tension, 0}) <= 1e-10);
    CHECK(bond_forces(closed.model, closed.solution)[0].force.y() ==
          Approx(-6 * tension).epsilon(1e-10));
  }
}

// The bars of the case before, whose tie would come to stand 0.005 below the upper one: a floor 0.003 below that holds it. Then
// 0.003 stretch the upper bar and 0.007 the lower one, and the floor bears the difference of 1.5 and 3.5 on the width of 6.
TEST_CASE("nodes that a tie moves may touch something", "[ties]") {
  const bool upper_is_source = GENERATE(true, false);
  CAPTURE(upper_is_source);
  Scene scene = stack("q4", {}, 0.01);
  for (Body& body : scene.bodies) body.material.poisson_ratio = 0;
  scene.bodies[0].supports = {fixed("bottom")};
  scene.bodies[1].supports = {fixed("top")};
  Tie tie = scene.bonds->ties[0];
  if (!upper_is_source) tie = tie_of({"top", "lower"}, Side{"bottom", "upper"});
  tie.closes = true;
  scene.bonds = bonds_of({tie});
  ContactSpec floor;
  floor.source = {"bottom", "upper"};
  floor.target = half_plane({0, 2.007}, {0, 1});
  scene.contacts = {floor};
  const SolvedScene run = solved(scene, "the bars");
  CHECK(run.solution.contact.force.sum() == Approx(6 * (3.5 - 1.5)).epsilon(1e-10));
  for (const Index node : boundary_nodes(run.model.bodies[1].mesh, "bottom"))
    CHECK(run.solution.displacements[1](node, 1) == Approx(-0.003).epsilon(1e-10));
  for (const Index node : boundary_nodes(run.model.bodies[0].mesh, "top"))
    CHECK(run.solution.displacements[0](node, 1) == Approx(0.007).epsilon(1e-10));
}

// The upper block is longer than the lower one: the tie, which alone holds it, bears its load, with the moment of that.
TEST_CASE("the moment of a tie is that of what it holds, where the source hangs over", "[ties]") {
  for (const std::string& element : all_elements) {
    CAPTURE(element);
    Scene scene = stack(element);
    scene.bodies[0].supports = {fixed("bottom")};
    scene.bodies[1].mesh = block_of(element, "upper", {-1, 2}, {8.5, 2}, 7, 2);
    EdgeLoad pull;
    pull.boundary = "top";
    pull.traction = [](const Vector2d&) { return Vector2d(0.3, 2); };
    scene.bodies[1].loads.edges = {pull};
    const SolvedScene run = solved(scene, "the stack");
    const BondForces sum = bond_forces(run.model, run.solution).front();
    CHECK(sum.force.x() == Approx(-0.3 * 8.5).epsilon(1e-10));
    CHECK(sum.force.y() == Approx(-2 * 8.5).epsilon(1e-10));
    CHECK(sum.moment == Approx(-(2 * 8.5 * 3.25 - 0.3 * 8.5 * 4)).epsilon(1e-9));
  }
}

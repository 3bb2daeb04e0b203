// Layers of different material in one body, against closed forms.
#include <algorithm>
#include <limits>

#include "catch_compat.hpp"
#include "meshes/regions.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

const double far = std::numeric_limits<double>::infinity();

/// A beam 50 x 5 whose upper half has a name, held on the left.
Scene layered_beam(const std::string& element, Index cells_x, Index cells_y) {
  Scene scene = cantilever(element, cells_x, cells_y);
  Body& body = scene.bodies[0];
  body.material = {1000, 0, PlaneState::Stress, 1};
  body.mesh = with_region(body.mesh, "upper", {-far, 2.5}, {far, far});
  body.loads = {};
  scene.contacts.clear();
  return scene;
}

}  // namespace

// Pressed by 3 across the layers, E 1000 and 4000, each 2.5 high: 3 (2.5 / 1000 + 2.5 / 4000) at the top.
TEST_CASE("layers on each other give way one after the other", "[layers]") {
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    CAPTURE(element);
    Scene scene = layered_beam(element, 10, 4);
    Body& body = scene.bodies[0];
    body.supports = {symmetric("left"), symmetric("bottom")};
    body.layers = {{"upper", {4000, 0, PlaneState::Stress, 1}}};
    body.loads.edges = {{"top", 3, {}}};
    const auto [model, condensed, solution] = solved(scene, "the layers");
    const NodeArray& x = model.bodies[0].mesh.nodes;
    for (Index node = 0; node < x.rows(); ++node) {
      const double y = x(node, 1);
      const double down = 3 * (std::min(y, 2.5) / 1000 + std::max(y - 2.5, 0.0) / 4000);
      CHECK(solution.displacements[0](node, 1) == Approx(-down).epsilon(1e-11).margin(1e-14));
    }
    const BodyModel& own = model.bodies[0];
    const StressArray stress =
        cell_stress(own.mesh, own.element, own.material, solution.displacements[0]);
    CHECK((stress.col(1).array() + 3).abs().maxCoeff() <= 1e-11);
    CHECK(support_forces(model, solution).col(1).sum() == Approx(150).epsilon(1e-12));
  }
}

// Pulled along the layers by 0.1: each bears its own modulus times 0.1 / 50.
TEST_CASE("layers beside each other bear as they are stiff", "[layers]") {
  Scene scene = layered_beam("q4_incompatible", 10, 4);
  Body& body = scene.bodies[0];
  body.supports = {symmetric("left"), symmetric("bottom"), prescribed("right", Axis::X, 0.1)};
  body.layers = {{"upper", {4000, 0, PlaneState::Stress, 1}}};
  const auto [model, condensed, solution] = solved(scene, "the layers");
  const BodyModel& own = model.bodies[0];
  const StressArray stress =
      cell_stress(own.mesh, own.element, own.material, solution.displacements[0]);
  for (Index cell = 0; cell < 40; ++cell)
    CHECK(stress(cell, 0) == Approx(cell < 20 ? 2 : 8).epsilon(1e-11));
  CHECK(boundary_forces({model, condensed, solution}, {"right"}).force.col(0).sum() ==
        Approx(2 * 2.5 + 8 * 2.5).epsilon(1e-12));
}

// Timoshenko's strip of two metals, as high as each other: away from its ends it is an arc of curvature
// 24 (a2 - a1) dT / (h (14 + n + 1 / n)), n the ratio of the moduli.
TEST_CASE("a strip of two metals bends when it is warm", "[layers][heat]") {
  for (const char* element : {"q4_incompatible", "q8"})
    for (const double n : {1.0, 4.0}) {
      CAPTURE(element, n);
      Scene scene = layered_beam(element, 100, 4);
      Body& body = scene.bodies[0];
      body.material.expansion = 1e-5;
      body.layers = {{"upper", {n * 1000, 0, PlaneState::Stress, 1, 3e-5}}};
      body.supports = {prescribed_at("left", {0, 0}, Axis::X),
                       prescribed_at("left", {0, 0}, Axis::Y),
                       prescribed_at("right", {50, 0}, Axis::Y)};
      body.temperature = Temperature{100, {0, 0}};
      const SolvedScene run = solved(scene, "the strip");
      const auto height = [&](double x) {
        const EdgePlace at = place_on_edge(run.model.bodies[0].mesh, {x, 0});
        return run.solution.displacements[0](at.nodes.front(), 1);
      };
      const double curvature = (height(20) - 2 * height(25) + height(30)) / 25;
      const double expected = 24 * 2e-5 * 100 / (5 * (14 + n + 1 / n));
      CHECK(-curvature == Approx(expected).epsilon(1e-6));  // the upper half grows more: a hump
    }
}

TEST_CASE("a layer of the same material is none, and all of another one is that body", "[layers]") {
  const Scene none = cantilever("q4_incompatible", 20, 2);
  Scene same = none;
  Mesh& mesh = same.bodies[0].mesh;
  mesh = with_region(mesh, "all", {-far, -far}, {far, far});
  same.bodies[0].layers = {{"all", none.bodies[0].material}};
  CHECK(plan(same).on == plan(none).on);
  CHECK(plan(same).off == plan(none).off);
  Scene other = none;
  other.bodies[0].material.youngs_modulus *= 3;
  Scene covered = same;
  covered.bodies[0].layers = {{"all", other.bodies[0].material}};
  const Solution plain = solve(none);
  CHECK(solve(same).displacements[0] == plain.displacements[0]);
  const SolvedScene one = solved(other, "the beam");
  const SolvedScene two = solved(covered, "the layer");
  CHECK(two.solution.displacements[0] == one.solution.displacements[0]);
  CHECK(two.solution.contact.force == one.solution.contact.force);
  CHECK(support_forces(two.model, two.solution) == support_forces(one.model, one.solution));
  CHECK(two.solution.displacements[0] != plain.displacements[0]);
}

TEST_CASE("layers that cannot be are errors that name them", "[layers]") {
  const auto message = [](const std::vector<Layer>& layers) {
    Scene scene = layered_beam("q4", 10, 2);
    Mesh& mesh = scene.bodies[0].mesh;
    mesh = with_region(mesh, "right", {40, 0}, {50, 5});
    scene.bodies[0].layers = layers;
    return problem_message([&] { static_cast<void>(plan(scene)); });
  };
  const Material other{2000, 0, PlaneState::Stress, 1};
  Material thick = other;
  thick.thickness = 2;
  Material strained = other;
  strained.state = PlaneState::Strain;
  Material soft = other;
  soft.youngs_modulus = 0;
  CHECK(message({{"upper", other}}).empty());
  CHECK_THAT(message({{"uper", other}}),
             ContainsSubstring("has no region 'uper'; it has: right, upper"));
  CHECK_THAT(message({{"upper", other}, {"right", other}}),
             ContainsSubstring("layer 'right' of 'beam': cell 18 is in the layer 'upper' as well"));
  CHECK_THAT(
      message({{"upper", thick}}),
      ContainsSubstring("layer 'upper' of 'beam': its thickness must be that of the body, 1, "
                        "got 2"));
  CHECK_THAT(message({{"upper", strained}}), ContainsSubstring("its plane state"));
  CHECK_THAT(message({{"upper", soft}}),
             ContainsSubstring("layer 'upper' of 'beam': material: Young's modulus"));
}

TEST_CASE("stresses of a part of a layered body need the layers of the part", "[layers]") {
  Scene scene = layered_beam("q4", 10, 2);
  scene.bodies[0].layers = {{"upper", {2000, 0, PlaneState::Stress, 1}}};
  const BodyModel body = plan(scene).bodies[0];
  Mesh part = body.mesh;
  part.cells.conservativeResize(10, 4);
  CHECK_THAT(argument_message([&] {
               static_cast<void>(cell_stress(part, body.element, body.material,
                                             NodeArray::Zero(part.n_nodes(), 2)));
             }),
             ContainsSubstring("there are 10, but the materials are those of 20"));
}

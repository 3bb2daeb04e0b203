// Warm bodies in a scene: what supports feel, and a shrink fit that is a press fit.
#include <algorithm>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/lining.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// A bar 50 x 5, 1 thick, E 21000, held at its left end.
Scene bar(PlaneState state) {
  Scene scene = cantilever("q4_incompatible", 20, 2);
  Body& body = scene.bodies[0];
  body.material = {21000, 0.3, state, 1, 1e-5};
  body.loads = {};
  body.supports = {symmetric("left"), symmetric("bottom")};
  scene.contacts.clear();
  body.temperature = Temperature{100, {0, 0}};
  return scene;
}

/// Rings without load and gap, of which one sits on the other; made of the cells of a lining or of a tube.
Scene two_rings(const std::string& element, PlaneState state) {
  Lining lining;
  lining.radii[0] = 40, lining.radii[1] = lining.radii[2] = 68, lining.radii[3] = 90;
  lining.inside = 0;
  lining.element = element;
  Scene scene = scene_of(lining);
  if (state == PlaneState::Axial)
    for (std::size_t ring = 0; ring < 2; ++ring) {
      Body& body = scene.bodies[ring];
      body.mesh = block(ring == 0 ? "lining" : "rock", {lining.radii[2 * ring], 0},
                        {lining.radii[2 * ring + 1] - lining.radii[2 * ring], 10}, 6, 5,
                        element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear);
      body.supports = {symmetric("bottom")};
      scene.contacts[0].source.boundary = "right";
      std::get<Side>(scene.contacts[0].target).boundary = "left";
    }
  for (Body& body : scene.bodies) body.material = {210e3, 0.3, state, 1, 1.2e-5};
  return scene;
}

bool contains(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(words) != std::string::npos;
  });
}

}  // namespace

// Held at both ends in plane stress: -E alpha dT times 5 x 1; the temperature acts on nothing else.
TEST_CASE("what supports feel of a hindered expansion", "[heat]") {
  Scene scene = bar(PlaneState::Stress);
  scene.bodies[0].supports.push_back(prescribed("right", Axis::X, 0));
  const auto [model, condensed, solution] = solved(scene, "the bar");
  const BodyModel& body = model.bodies[0];
  const NodeArray support = support_forces(model, solution);
  const double pressed = 21000 * 1e-5 * 100 * 5;
  for (Index node = 0; node < support.rows(); ++node) {
    const double x = body.mesh.nodes(node, 0);
    if (x > 0 && x < 50) CHECK(std::abs(support(node, 0)) <= 1e-11 * pressed);
    CHECK(std::abs(support(node, 1)) <= 1e-11 * pressed);
  }
  CHECK(boundary_forces({model, condensed, solution}, {"left"}).force.col(0).sum() ==
        Approx(pressed).epsilon(1e-12));
  const StressArray stress =
      nodal_stress(body.mesh, body.element, body.material, solution.displacements[0]);
  CHECK((stress.col(0).array() + pressed / 5).abs().maxCoeff() <= 1e-11 * pressed);
  CHECK(stress.col(1).cwiseAbs().maxCoeff() <= 1e-11 * pressed);
}

TEST_CASE("a bar that is free to expand, or has room, bears nothing", "[heat]") {
  for (const PlaneState state : {PlaneState::Stress, PlaneState::Strain, PlaneState::Axial}) {
    Scene scene = bar(state);
    const double longer = 50 * 1e-3 * (state == PlaneState::Strain ? 1.3 : 1);
    scene.contacts = {{{"right"}, half_plane({50 + 1.001 * longer, 0}, {-1, 0})}};
    const auto [model, condensed, solution] = solved(scene, "the bar");
    const BodyModel& body = model.bodies[0];
    CHECK(solution.contact.force.isZero(0));
    CHECK(solution.contact.gap.maxCoeff() == Approx(0.001 * longer).epsilon(1e-9));
    const StressArray stress =
        nodal_stress(body.mesh, body.element, body.material, solution.displacements[0]);
    CHECK(stress.leftCols(3).cwiseAbs().maxCoeff() <= 1e-12 * 21);
    if (state == PlaneState::Axial) CHECK(stress.col(3).cwiseAbs().maxCoeff() <= 1e-12 * 21);
    CHECK(support_forces(model, solution).cwiseAbs().maxCoeff() <= 1e-11 * 21 * 400);
  }
}

// What the warm ring would expand by closes every gap alike; pressed in by that, it bears the same.
TEST_CASE("a shrink fit is a press fit", "[heat][fit]") {
  for (const char* element : {"q4_incompatible", "q8"})
    for (const PlaneState state : {PlaneState::Strain, PlaneState::Axial}) {
      CAPTURE(element, state == PlaneState::Axial);
      Scene warm = two_rings(element, state);
      warm.bodies[0].temperature = Temperature{100, {0, 0}};
      const SolvedScene shrunk = solved(warm, "the shrink fit");
      const double strain = 1.2e-3 * (state == PlaneState::Strain ? 1.3 : 1);
      NodeArray free = NodeArray::Zero(shrunk.model.pairs.opening.cols() / 2, 2);
      const Mesh& inner = shrunk.model.bodies[0].mesh;
      free.topRows(inner.n_nodes()) = strain * inner.nodes;
      const VectorXd closed =
          -(shrunk.model.pairs.opening * Eigen::Map<const VectorXd>(free.data(), free.size()));
      if (std::string(element) == "q4_incompatible" || state == PlaneState::Axial)
        CHECK(closed.maxCoeff() - closed.minCoeff() <= 1e-13 * closed.maxCoeff());
      else
        continue;  // curved sides: what closes is not the same everywhere

      Scene cold = two_rings(element, state);
      cold.contacts[0].interference = closed.mean();
      for (Body& body : cold.bodies) body.material.expansion = 0;
      const SolvedScene pressed = solved(cold, "the press fit");
      const VectorXd& force = pressed.solution.contact.force;
      CHECK(force.minCoeff() > 0);
      CHECK((shrunk.solution.contact.force - force).norm() <= 1e-10 * force.norm());
      const NodeArray moved = shrunk.solution.displacements[0] - pressed.solution.displacements[0];
      CHECK((moved - strain * inner.nodes).cwiseAbs().maxCoeff() <= 1e-10 * strain * 68);
      CHECK((shrunk.solution.displacements[1] - pressed.solution.displacements[1]).norm() <=
            1e-10 * pressed.solution.displacements[1].norm());
      for (std::size_t b = 0; b < 2; ++b) {
        const auto stress = [&](const SolvedScene& run) {
          const BodyModel& body = run.model.bodies[b];
          return cell_stress(body.mesh, body.element, body.material, run.solution.displacements[b]);
        };
        const StressArray there = stress(pressed);
        const Index kept =
            state == PlaneState::Axial ? 4 : 3;  // across plane strain it is hindered
        CHECK((stress(shrunk) - there).leftCols(kept).norm() <= 1e-10 * there.norm());
      }
    }
}

// Lame: pressed in by 0.1, on meshes as fine as they are.
TEST_CASE("a press fit by interference bears what Lame says", "[fit]") {
  Lining lining;
  lining.radii[0] = 40, lining.radii[1] = lining.radii[2] = 68, lining.radii[3] = 90;
  lining.inside = 0;
  lining.cells_angle = 48;
  lining.cells_radius = 16;
  Scene scene = scene_of(lining);
  scene.contacts[0].interference = 0.01;
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  lining.radii[1] += 0.01;
  const double pressure = nested_pressure(closed_form(lining)).inner.outside;
  CHECK(solution.pressure.mean() == Approx(pressure).epsilon(1e-3));
}

TEST_CASE("a temperature of zero is none to a scene", "[heat]") {
  Scene none = cantilever("q4_incompatible", 20, 2);
  Scene zero = none;
  zero.bodies[0].temperature = Temperature{0, {0, 0}};
  CHECK(plan(zero).on == plan(none).on);
  CHECK(plan(zero).off == plan(none).off);
  CHECK(plan(zero).notes.empty());
  const SolvedScene one = solved(none, "the beam");
  const SolvedScene two = solved(zero, "the beam");
  CHECK(one.solution.displacements[0] == two.solution.displacements[0]);
  CHECK(one.solution.contact.force == two.solution.contact.force);
  CHECK(support_forces(one.model, one.solution) == support_forces(two.model, two.solution));
}

TEST_CASE("temperatures that cannot be are errors, an idle expansion is a note", "[heat]") {
  Scene scene = bar(PlaneState::Stress);
  CHECK(contains(plan(scene).on, "temperature of 'beam': 100 more than without stress"));
  scene.bodies[0].temperature->gradient = {0, 2};
  CHECK(contains(plan(scene).on,
                 "100 more than without stress at the origin, with the gradient (0, 2)"));
  scene.bodies[0].temperature->uniform = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("temperature of 'beam': must be finite"));
  scene = bar(PlaneState::Stress);
  scene.bodies[0].material.expansion = 0;
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("temperature of 'beam': its material does not expand"));
  scene.bodies[0].material.expansion = std::numeric_limits<double>::infinity();
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("thermal expansion"));
}

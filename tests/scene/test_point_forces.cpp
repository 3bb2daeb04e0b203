// Forces at one place: reciprocity, balance, and what they are in place of.
#include <algorithm>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::cantilever;
using signorini_test::problem_message;

namespace {

Scene beam(const std::string& element, const std::vector<PointForce>& forces) {
  Scene scene = cantilever(element, 10, 1);
  scene.bodies[0].loads = {{}, {}, forces};
  scene.contacts.clear();
  return scene;
}

/// Displacement at a place, as the shape functions of its side say.
Vector2d displacement(const SolvedScene& run, const Vector2d& point) {
  const EdgePlace place = place_on_edge(run.model.bodies[0].mesh, point);
  Vector2d u(0, 0);
  for (std::size_t k = 0; k < place.nodes.size(); ++k)
    u += place.share(static_cast<Index>(k)) *
         run.solution.displacements[0].row(place.nodes[k]).transpose();
  return u;
}

}  // namespace

// Maxwell: what a force here moves there, the same force there moves here.
TEST_CASE("forces at two places move each other's place alike", "[point_forces]") {
  const Vector2d a(17.3, 5);
  const Vector2d b(50, 1.25);
  for (const char* element : {"q4", "q4_bbar", "q4_incompatible", "q8"}) {
    const SolvedScene one = solved(beam(element, {{a, {0, -1}}}), "the beam");
    const SolvedScene two = solved(beam(element, {{b, {1, 0}}}), "the beam");
    CHECK(displacement(one, b).x() == Approx(-displacement(two, a).y()).epsilon(1e-11));
  }
}

TEST_CASE("a force at a place is balanced by the support, with its moment", "[point_forces]") {
  for (const char* element : {"q4_incompatible", "q8"}) {
    const Vector2d point(33.3, 5);
    const Vector2d force(2, -3);
    const auto [model, condensed, solution] = solved(beam(element, {{point, force}}), "the beam");
    const NodeArray support = support_forces(model, solution);
    const NodeArray& x = model.bodies[0].mesh.nodes;
    CHECK(support.col(0).sum() == Approx(-2).epsilon(1e-11));
    CHECK(support.col(1).sum() == Approx(3).epsilon(1e-11));
    CHECK(x.col(0).dot(support.col(1)) - x.col(1).dot(support.col(0)) ==
          Approx(-(point.x() * force.y() - point.y() * force.x())).epsilon(1e-11));
  }
}

TEST_CASE("forces at one place add up, and a force in the middle of one side is a traction on it",
          "[point_forces]") {
  const Vector2d middle(50, 2.5);
  Scene drawn = beam("q4_incompatible", {});
  drawn.bodies[0].loads.edges = {
      {"right", 0, [](const Vector2d&) { return Vector2d(0, -6.0 / 5); }}};
  const Scene pulled = beam("q4_incompatible", {{middle, {0, -2}}, {middle, {0, -4}}});
  const Solution one = solve(drawn);
  const Solution two = solve(pulled);
  CHECK((one.displacements[0] - two.displacements[0]).norm() <=
        1e-12 * one.displacements[0].norm());
}

TEST_CASE("forces of zero are none, and a plan says where the others act", "[point_forces]") {
  const Scene none = cantilever("q4", 10, 1);
  Scene zero = none;
  zero.bodies[0].loads.points = {{{50, 5}, {0, 0}}, {{7, 7}, {0, 0}}};
  CHECK(plan(zero).on == plan(none).on);
  CHECK(plan(zero).off == plan(none).off);
  const SolvedScene one = solved(none, "the beam");
  const SolvedScene two = solved(zero, "the beam");
  CHECK(one.solution.displacements[0] == two.solution.displacements[0]);
  CHECK(support_forces(one.model, one.solution) == support_forces(two.model, two.solution));
  zero.bodies[0].loads.points = {{{50, 5}, {0, -1}}, {{50, 2}, {2, 0}}};
  const std::vector<std::string> on = plan(zero).on;
  CHECK(std::count(on.begin(), on.end(), "force (0, -1) on node 21 of 'beam'") == 1);
  CHECK(std::count(on.begin(), on.end(), "force (2, 0) on the side from node 10 to 21 of 'beam'") ==
        1);
}

TEST_CASE("a force at no place of the body is an error of the plan", "[point_forces]") {
  Scene scene = cantilever("q4", 10, 1);
  scene.bodies[0].loads.points = {{{25, 2}, {0, -1}}};
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("point (25, 2) of 'beam'") &&
                 ContainsSubstring("node 5, lies at (25, 0), 2 away"));
  scene.bodies[0].loads.points = {{{50, 5}, {0, std::numeric_limits<double>::quiet_NaN()}}};
  CHECK_THAT(problem_message([&] { static_cast<void>(plan(scene)); }),
             ContainsSubstring("point force on 'beam' at (50, 5): not finite"));
}

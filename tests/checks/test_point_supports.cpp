// Forces at points and on the axis, which no mesh resolves, are told.
#include "addons/checks/point_supports.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;

namespace {

/// A block 4 x 1 that is pressed down onto a floor.
Scene slab(const std::vector<Support>& supports, PlaneState state = PlaneState::Strain) {
  Scene scene;
  Body& body = scene.bodies.front();
  body.mesh = block("slab", {0, 0}, {4, 1}, 8, 2);
  body.material = {1000, 0.3, state, 1};
  body.supports = supports;
  body.loads.edges = {{"top", 1, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, -0.001}, {0, 1})}};
  return scene;
}

std::vector<std::string> told(const Scene& scene) {
  const SolvedScene run = solved(scene, "slab");
  return point_supports(run.model, run.solution);
}

}  // namespace

TEST_CASE("a support at a point that bears a force is told, one that only holds is not",
          "[point_supports]") {
  const std::vector<std::string> notes =
      told(slab({symmetric("left"), prescribed_at("bottom", {0, 0}, Axis::Y)}));
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], ContainsSubstring("supports of body 'slab' bear at the point (0, 0)") &&
                           ContainsSubstring("support a side"));
  // The floor bears all of the load, and nothing pushes sideways.
  CHECK(told(slab({prescribed_at("bottom", {0, 0}, Axis::X)})).empty());
  CHECK(told(slab({fixed("left")})).empty());
  // A node of a side that is held as a whole is not held at a point.
  CHECK(told(slab({fixed("left"), prescribed_at("left", {0, 1}, Axis::Y)})).empty());
}

TEST_CASE("a spring at a point that bears a force is told, one along a side is not",
          "[point_supports]") {
  Scene scene = slab({fixed("left")});
  scene.bodies[0].springs = {{"right", {0, 50}, {{4, 1}}}};
  const std::vector<std::string> notes = told(scene);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], ContainsSubstring("springs of body 'slab' bear at the point (4, 1)") &&
                           ContainsSubstring("put them on a side"));
  scene.bodies[0].springs = {{"right", {0, 50}}};
  CHECK(told(scene).empty());
}

TEST_CASE("supports on the axis of revolution bear nothing in the limit, and are told",
          "[point_supports]") {
  const Scene scene = slab({fixed("left")}, PlaneState::Axial);
  const std::vector<std::string> notes = told(scene);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], ContainsSubstring("bear on the axis a force of"));
  CHECK(told(slab({symmetric("left"), fixed("top")}, PlaneState::Axial)).empty());
  // So large a strain there is not that of units.
  Scene heavy = scene;
  heavy.bodies[0].loads.edges = {{"top", 1e5, {}}};
  std::string all;
  for (const std::string& note : solved(heavy, "slab").solution.notes) all += note;
  CHECK_THAT(all, ContainsSubstring("bears a force without an area") &&
                      !ContainsSubstring("comes of units"));
}

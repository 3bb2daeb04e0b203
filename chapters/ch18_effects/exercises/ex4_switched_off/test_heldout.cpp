#include <algorithm>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "meshes/block.hpp"
#include "meshes/regions.hpp"
#include "signorini/scene/effects.hpp"

using ex18_4::without;
using namespace signorini;
using Names = std::vector<std::string>;

namespace {

const char* const switches[] = {"body force",  "edge loads", "point forces",  "layers",
                                "temperature", "springs",    "adjusted gaps", "interference",
                                "friction",    "cohesion"};

/// Two blocks side by side, each on a rough floor and before a wall that it does not touch yet.
Scene all_effects() {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    Body& body = scene.bodies[k];
    const double x = 5 * static_cast<double>(k);
    const std::string name = k == 0 ? "left" : "right";
    body.mesh = block(name, {x, 1e-5}, {3, 1}, 6, 2);
    body.mesh = with_region(body.mesh, "skin", {x, 0.5}, {x + 3, 2});
    body.material = {1000, 0.3, PlaneState::Strain, 1, 1e-5};
    body.supports = {fixed("left")};
    body.layers = {{"skin", {2000, 0.2, PlaneState::Strain, 1, 1e-5}}};
    body.springs = {{"right", {3, 1}}};
    body.temperature = Temperature{30, {0, 0}};
    body.loads.edges = {{"top", 2, {}}};
    body.loads.points = {{{x + 3, 1.00001}, {0.5, 0}}};
    body.loads.body_force = [](const Eigen::Vector2d& /*x*/) { return Eigen::Vector2d(0, -1); };
    scene.contacts.push_back({{"bottom", name}, half_plane({0, 0}, {0, 1})});
    scene.contacts.back().adjust = 1e-3;
    scene.contacts.back().friction = Friction{0.3, 0.1};
    scene.contacts.push_back({{"right", name}, half_plane({x + 3.1, 0}, {-1, 0})});
    scene.contacts.back().interference = 0.05;
  }
  return scene;
}

Names on(const Scene& scene) {
  Names names;
  for (const Effect* effect : plan(scene).effects) names.emplace_back(effect->name);
  return names;
}

/// Lines of the plan that are about neither a name nor what it takes.
Names lines(const Scene& scene, const std::string& about) {
  Names kept;
  for (const std::string& line : plan(scene).on)
    if (line.find(about) == std::string::npos) kept.push_back(line);
  return kept;
}

}  // namespace

TEST_CASE("ex18.4 held out: ten effects in two bodies, each by itself", "[ex18.4]") {
  const Scene scene = all_effects();
  REQUIRE(on(scene).size() >= 11);
  for (const char* effect : switches) {
    CAPTURE(effect);
    Names expected = on(scene);
    REQUIRE(std::count(expected.begin(), expected.end(), effect) == 1);
    expected.erase(std::find(expected.begin(), expected.end(), effect));
    const Scene less = without(scene, effect);
    CHECK(on(less) == expected);
    const Names off = plan(less).off;
    CHECK(std::count(off.begin(), off.end(), effect) == 1);
  }
}

TEST_CASE("ex18.4 held out: all of them, in any order, leave bodies and contact", "[ex18.4]") {
  Scene forwards = all_effects(), backwards = forwards;
  for (int k = 0; k < 10; ++k) {
    forwards = without(forwards, switches[k]);
    backwards = without(backwards, switches[9 - k]);
  }
  CHECK(on(forwards) == Names{"contact"});
  CHECK(on(backwards) == on(forwards));
}

// The numbers of what stays are those that were there.
TEST_CASE("ex18.4 held out: the lines of the others stay as they are", "[ex18.4]") {
  const Scene scene = all_effects();
  CHECK(lines(without(scene, "temperature"), "temperature of") == lines(scene, "temperature of"));
  CHECK(lines(without(scene, "springs"), "spring") == lines(scene, "spring"));
  CHECK(lines(without(scene, "point forces"), "force (") == lines(scene, "force ("));
  const Scene smooth = without(scene, "friction");
  REQUIRE(smooth.contacts[2].friction);
  CHECK(smooth.contacts[2].friction->cohesion == 0.1);
  CHECK(without(scene, "cohesion").contacts[2].friction->coefficient == 0.3);
}

TEST_CASE("ex18.4 held out: a scene that never had it gives the same numbers", "[ex18.4]") {
  Scene scene = all_effects();
  for (Body& body : scene.bodies) body.temperature.reset();
  const Solution without_it = solve(without(all_effects(), "temperature"));
  const Solution never = solve(scene);
  REQUIRE(never.contact.report.status == SolveStatus::Solved);
  REQUIRE(without_it.contact.force.size() == never.contact.force.size());
  CHECK(without_it.contact.force == never.contact.force);
}

TEST_CASE("ex18.4 held out: what is no switch", "[ex18.4]") {
  const Scene scene = all_effects();
  for (const Effect& effect : effects()) {
    CAPTURE(effect.name);
    if (std::find(std::begin(switches), std::end(switches), std::string(effect.name)) ==
        std::end(switches))
      CHECK_THROWS_AS(without(scene, effect.name), std::invalid_argument);
  }
  CHECK_THROWS_AS(without(scene, ""), std::invalid_argument);
}

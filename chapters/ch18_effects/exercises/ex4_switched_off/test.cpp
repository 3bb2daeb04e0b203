#include <algorithm>
#include <stdexcept>

#include "../chapters/ch18_effects/scenes.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/scene/effects.hpp"

using ex18_4::without;
using namespace signorini;
using Names = std::vector<std::string>;

static Names on(const Scene& scene) {
  Names names;
  for (const Effect* effect : plan(scene).effects) names.emplace_back(effect->name);
  return names;
}

static void check_off(const Scene& scene, const std::string& effect) {
  CAPTURE(effect);
  Names expected = on(scene);
  expected.erase(std::remove(expected.begin(), expected.end(), effect), expected.end());
  CHECK(on(without(scene, effect)) == expected);
}

TEST_CASE("ex18.4 the last rung of the ladder, an effect at a time", "[ex18.4]") {
  Scene scene = heated(with_friction(floating(with_plate(on_rock(0)))));
  for (const char* effect : {"temperature", "friction", "edge loads"}) check_off(scene, effect);
}

// Both are warm, and friction has cohesion besides.
TEST_CASE("ex18.4 in every body and every contact, and nothing else", "[ex18.4]") {
  Scene scene = heated(with_friction(floating(with_plate(on_rock(0)))));
  scene.bodies[1].temperature = Temperature{20, {0, 1}};
  scene.contacts[0].friction->cohesion = 0.5;
  for (const char* effect : {"temperature", "friction", "cohesion"}) check_off(scene, effect);
}

TEST_CASE("ex18.4 what is not there cannot be missed, what is no switch is refused", "[ex18.4]") {
  const Scene scene = on_rock(0.1);
  check_off(scene, "springs");
  CHECK_THROWS_AS(without(scene, "contact"), std::invalid_argument);
  CHECK_THROWS_AS(without(scene, "weather"), std::invalid_argument);
}

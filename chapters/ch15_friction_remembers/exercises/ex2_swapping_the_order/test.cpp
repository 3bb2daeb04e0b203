#include <algorithm>
#include <stdexcept>

#include "../chapters/ch15_friction_remembers/slider.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex15_2::in_order;
using namespace signorini;

// The triangle of the chapter, pressed and pulled together, by `way` in the end [mm].
static Scene straight(double way) {
  Scene scene = ch15::triangle(equal_steps(4));
  scene.bodies[0].loads.points[0].history = "press";
  scene.path->histories = {{"press", {0, 1}, {0, 1}}, {"hand", {0, 1}, {0, way}}};
  return scene;
}

static double pull_in_the_end(const Scene& scene) {
  double pull = 0;
  ch15::remember(scene, [&pull](const Model&, const Step& step) {
    pull = -step.solution.contact.friction(0);
  });
  return pull;
}

TEST_CASE("ex15.2 pressed first, friction bears the pull; pulled first, it bears none",
          "[ex15.2]") {
  for (const double way : {0.2, 1.0, -0.1}) {
    CAPTURE(way);
    const double expected = std::clamp(ch15::k * way, -ch15::B, ch15::B);
    CHECK(pull_in_the_end(in_order(straight(way), "press")) == Approx(expected).epsilon(1e-12));
    CHECK(pull_in_the_end(in_order(straight(way), "hand")) == Approx(0).margin(1e-12));
  }
}

TEST_CASE("ex15.2 what comes first is there at half of the time, the other begins then",
          "[ex15.2]") {
  const Path path = in_order(straight(0.2), "hand").path.value();
  REQUIRE(path.histories.size() == 2);
  CHECK(path.histories[1].name == "hand");
  CHECK(path.histories[1].at(0.25) == Approx(0.1).epsilon(1e-14));
  CHECK(path.histories[1].at(0.5) == Approx(0.2).epsilon(1e-14));
  CHECK(path.histories[1].at(1) == Approx(0.2).epsilon(1e-14));
  CHECK(path.histories[0].at(0.5) == 0);
  CHECK(path.histories[0].at(0.75) == Approx(0.5).epsilon(1e-14));
  CHECK(path.histories[0].at(1) == 1);
  CHECK(path.times == equal_steps(4));
}

TEST_CASE("ex15.2 nobody comes first who is not there", "[ex15.2]") {
  CHECK_THROWS_AS(in_order(straight(0.2), "foot"), std::invalid_argument);
}

TEST_CASE("ex15.2 an odd number of steps gets one more", "[ex15.2]") {
  Scene scene = straight(0.2);
  scene.path->times = equal_steps(3);
  CHECK(in_order(scene, "hand").path->times == equal_steps(4));
}

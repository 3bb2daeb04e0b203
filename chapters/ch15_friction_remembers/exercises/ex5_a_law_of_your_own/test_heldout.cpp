#include <algorithm>

#include "../chapters/ch15_friction_remembers/slider.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex15_5::ceiling;
using ex15_5::coulomb;
using ex15_5::Law;
using ex15_5::Slider;
using ex15_5::tresca;

TEST_CASE("ex15.5 held out: an open tip follows its spring and loses nothing", "[ex15.5]") {
  for (const Law& law : {coulomb(0.5), tresca(4), ceiling(0.5, 3)}) {
    CAPTURE(law.name);
    Slider slider{20};
    CHECK(step(law, 0, 0.7, slider) == 0);
    CHECK(slider.place == Approx(0.7).epsilon(1e-14));
    CHECK(slider.lost == 0);
    CHECK(step(law, 1e-3, 0.7, slider) == Approx(0).margin(1e-14));
  }
}

TEST_CASE("ex15.5 held out: a force that falls lets a tip slide under a hand that rests",
          "[ex15.5]") {
  Slider slider{20};
  const Law law = coulomb(0.5);
  CHECK(step(law, 10, 0.2, slider) == Approx(4).epsilon(1e-14));
  CHECK(slider.lost == 0);
  CHECK(step(law, 2, 0.2, slider) == Approx(1).epsilon(1e-14));
  CHECK(slider.place == Approx(0.15).epsilon(1e-14));
  CHECK(slider.lost == Approx(0.15).epsilon(1e-13));
  CHECK(step(law, 10, 0.2, slider) == Approx(1).epsilon(1e-14));  // it does not go back
  CHECK(slider.lost == Approx(0.15).epsilon(1e-13));
}

TEST_CASE("ex15.5 held out: under a changing force Tresca's loop has its area, Coulomb's another",
          "[ex15.5]") {
  const auto loop = [](const Law& law, double on_the_way_back) {
    Slider slider{20};
    (void)step(law, 10, 1, slider);
    const double before = slider.lost;
    (void)step(law, on_the_way_back, -1, slider);
    (void)step(law, 10, 1, slider);
    return slider.lost - before;
  };
  CHECK(loop(tresca(5), 3) == Approx(loop(tresca(5), 10)).epsilon(1e-14));
  CHECK(loop(tresca(5), 3) == Approx(15).epsilon(1e-13));
  CHECK(loop(coulomb(0.5), 3) < 0.9 * loop(coulomb(0.5), 10));
  CHECK(loop(ceiling(0.5, 1), 3) == Approx(loop(tresca(1), 10)).epsilon(1e-14));
}

TEST_CASE("ex15.5 held out: a law from outside the family", "[ex15.5]") {
  const Law root{"root", [](double force) { return 2 * std::sqrt(force); }};
  Slider slider{1};
  CHECK(step(root, 4, 10, slider) == Approx(4).epsilon(1e-14));
  CHECK(slider.place == Approx(6).epsilon(1e-14));
}

TEST_CASE("ex15.5 held out: Coulomb's member step by step as the library", "[ex15.5]") {
  using namespace signorini;
  Scene scene = ch15::triangle(equal_steps(30, 5));
  scene.bodies[0].loads.points[0].history = "press";
  const History press{"press", {0, 2, 3, 5}, {1, 1.5, 0.2, 2}};
  scene.path->histories.push_back(press);
  Slider slider{ch15::k};
  ch15::remember(scene, [&](const Model&, const Step& now) {
    const double time = now.state.time;
    CAPTURE(time);
    const double pull =
        step(coulomb(0.5), ch15::pressed * press.at(time), ch15::to_and_fro().at(time), slider);
    CHECK(-now.solution.contact.friction(0) == Approx(pull).margin(1e-12));
    CHECK(now.state.slip(0) == Approx(slider.place).margin(1e-13));
    CHECK(now.state.dissipation(0) == Approx(slider.lost).margin(1e-12));
  });
}

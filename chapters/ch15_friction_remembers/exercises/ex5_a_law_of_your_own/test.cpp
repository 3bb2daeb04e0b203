#include "../chapters/ch15_friction_remembers/slider.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex15_5::ceiling;
using ex15_5::coulomb;
using ex15_5::Law;
using ex15_5::Slider;
using ex15_5::tresca;

TEST_CASE("ex15.5 three members and their bounds", "[ex15.5]") {
  CHECK(coulomb(0.5).bound(10) == 5);
  CHECK(tresca(5).name == "tresca");
  CHECK(tresca(5).bound(10) == 5);
  CHECK(tresca(5).bound(0.1) == 5);
  CHECK(ceiling(0.5, 3).name == "ceiling");
  CHECK(ceiling(0.5, 3).bound(4) == 2);
  CHECK(ceiling(0.5, 3).bound(10) == 3);
}

TEST_CASE("ex15.5 a round under a steady force: 4 B (U - B / k) for every member", "[ex15.5]") {
  const double force = 10;
  for (const Law& law : {coulomb(0.5), tresca(4), ceiling(0.5, 3)}) {
    CAPTURE(law.name);
    const double B = law.bound(force);
    Slider slider{20};
    (void)step(law, force, 1, slider);
    const double before = slider.lost;
    CHECK(step(law, force, -1, slider) == Approx(-B).epsilon(1e-14));
    CHECK(step(law, force, 1, slider) == Approx(B).epsilon(1e-14));
    CHECK(slider.lost - before == Approx(4 * B * (1 - B / 20)).epsilon(1e-13));
  }
}

// Of the library's pairs the cohesion is per area, and each has its share of the surface.
TEST_CASE("ex15.5 Tresca's law as the library has it: cohesion without a coefficient", "[ex15.5]") {
  using namespace signorini;
  Scene scene = ch15::triangle(equal_steps(23, 5));
  scene.contacts[0].friction = Friction{0, 1};
  Ledger ledger;
  const Model model = build(scene, ledger);
  REQUIRE(model.law.cohesion.size() == 1);
  const Law law = tresca(model.law.cohesion(0));
  Slider slider{ch15::k};
  ch15::remember(scene, [&](const Model&, const Step& now) {
    CAPTURE(now.state.time);
    const double pull = step(law, ch15::pressed, ch15::to_and_fro().at(now.state.time), slider);
    CHECK(-now.solution.contact.friction(0) == Approx(pull).margin(1e-12));
    CHECK(now.state.slip(0) == Approx(slider.place).margin(1e-13));
  });
}

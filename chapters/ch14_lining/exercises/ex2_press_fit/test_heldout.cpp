#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/rings.hpp"
#include "exercise.hpp"

using ex14_2::Fit;
using ex14_2::FitStress;
using ex14_2::press_fit;

// The library lets the radii differ by the interference, 1e-9 of them here, and so do the results.
TEST_CASE("ex14.2 held out: two materials, against the library", "[ex14.2]") {
  const Fit fit = GENERATE(Fit{10, 20, 30, 2e-8, 210e3, 0.3, 70e3, 0.34},
                           Fit{0, 20, 21, 2e-8, 3e3, 0.49, 210e3, 0.3},
                           Fit{0.5, 1, 50, 1e-9, 70e3, 0, 110e3, 0.2});
  CAPTURE(fit.bore);
  const signorini::NestedRings rings{
      {fit.bore, fit.radius + fit.interference, fit.shaft_modulus, fit.shaft_ratio},
      {fit.radius, fit.outside, fit.hub_modulus, fit.hub_ratio}};
  const signorini::NestedPressure p = nested_pressure(rings);
  const FitStress now = press_fit(fit);
  // 1e-6: the interference is the difference of two radii and has lost seven digits there.
  CHECK(now.pressure == Approx(p.inner.outside).epsilon(1e-6).margin(0));
  CHECK(now.hub_hoop ==
        Approx(ring_stress(rings.outer, p.outer, fit.radius).hoop).epsilon(1e-6).margin(0));
  CHECK(now.shaft_hoop ==
        Approx(ring_stress(rings.inner, p.inner, fit.bore).hoop).epsilon(1e-6).margin(0));
}

TEST_CASE("ex14.2 held out: the smallest bore doubles the stress in the middle", "[ex14.2]") {
  Fit fit{0, 20, 30, 0.01, 210e3, 0.3, 210e3, 0.3};
  const FitStress solid = press_fit(fit);
  fit.bore = 1e-4;
  const FitStress bored = press_fit(fit);
  CHECK(bored.pressure == Approx(solid.pressure).epsilon(1e-9));
  CHECK(bored.shaft_hoop == Approx(2 * solid.shaft_hoop).epsilon(1e-9));
}

TEST_CASE("ex14.2 held out: impossible fits", "[ex14.2]") {
  CHECK_THROWS_AS(press_fit({20, 20, 30, 0, 1, 0, 1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(press_fit({0, 20, 20, 0, 1, 0, 1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(press_fit({-1, 20, 30, 0, 1, 0, 1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(press_fit({0, 20, 30, 0, 1, 0, 0, 0}), std::invalid_argument);
}

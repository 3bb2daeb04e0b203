#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex14_2::Fit;
using ex14_2::FitStress;
using ex14_2::press_fit;

// Steel on steel, mm and MPa.
static Fit steel(double bore, double interference) {
  return {bore, 20, 30, interference, 210e3, 0.3, 210e3, 0.3};
}

TEST_CASE("ex14.2 a hub on a tube", "[ex14.2]") {
  const FitStress stress = press_fit(steel(10, 0.0025));
  CHECK(stress.pressure == Approx(6.15234375).epsilon(1e-9));
  CHECK(stress.hub_hoop == Approx(15.99609375).epsilon(1e-9));
  CHECK(stress.shaft_hoop == Approx(-16.40625).epsilon(1e-9));
}

TEST_CASE("ex14.2 a hub on a solid shaft", "[ex14.2]") {
  const FitStress stress = press_fit(steel(0, 0.0025));
  CHECK(stress.pressure == Approx(7.2916666667).epsilon(1e-9));
  CHECK(stress.shaft_hoop == Approx(-stress.pressure).epsilon(1e-12));
}

TEST_CASE("ex14.2 a clearance bears nothing", "[ex14.2]") {
  const FitStress stress = press_fit(steel(10, -0.0025));
  CHECK(stress.pressure == 0);
  CHECK(stress.hub_hoop == 0);
  CHECK(stress.shaft_hoop == 0);
}

TEST_CASE("ex14.2 fits that cannot be are refused", "[ex14.2]") {
  CHECK_THROWS_AS(press_fit(steel(25, 0.0025)), std::invalid_argument);
  CHECK_THROWS_AS(press_fit({10, 20, 30, 0.0025, -210e3, 0.3, 210e3, 0.3}), std::invalid_argument);
}

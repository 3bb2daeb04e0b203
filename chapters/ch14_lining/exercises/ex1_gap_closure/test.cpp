#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex14_1::Closure;
using ex14_1::press_lining;

// The rings of the chapter, in cm and MPa.
static const ex14_1::TwoRings lining{60, 68, 68.15, 76.15, 210e3, 0.3};

TEST_CASE("ex14.1 below the closing pressure the inner ring is alone", "[ex14.1]") {
  const Closure open = press_lining(lining, 72);
  CHECK(open.closing_pressure == Approx(72.39819).epsilon(1e-7));
  CHECK(open.contact_pressure == 0);
  CHECK(open.rim_displacement == Approx(0.1583679).epsilon(1e-6));
}

TEST_CASE("ex14.1 above it the rings share the load", "[ex14.1]") {
  const Closure closed = press_lining(lining, 180);
  CHECK(closed.closing_pressure == Approx(72.39819).epsilon(1e-7));
  CHECK(closed.contact_pressure == Approx(44.30189).epsilon(1e-6));
  CHECK(closed.rim_displacement == Approx(0.2918933).epsilon(1e-6));
}

TEST_CASE("ex14.1 contact begins with nothing", "[ex14.1]") {
  const double closing = press_lining(lining, 0).closing_pressure;
  CHECK(press_lining(lining, closing * (1 - 1e-9)).contact_pressure == 0);
  CHECK(press_lining(lining, closing * (1 + 1e-9)).contact_pressure > 0);
  CHECK(press_lining(lining, closing * (1 + 1e-9)).contact_pressure < 1e-6);
}

TEST_CASE("ex14.1 rings that cannot be are refused", "[ex14.1]") {
  CHECK_THROWS_AS(press_lining({68, 60, 68.15, 76.15, 210e3, 0.3}, 72), std::invalid_argument);
  CHECK_THROWS_AS(press_lining(lining, -72), std::invalid_argument);
}

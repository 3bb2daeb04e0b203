#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex7_4;

static const double degree = std::acos(-1.0) / 180;
static const Fit chapter{5, 0.2, 0.2};

TEST_CASE("ex7.4 the pin touches the pole, and is off by two clearances on the other side",
          "[ex7.4]") {
  CHECK(gap_at(chapter, 0).gap == Approx(0).margin(1e-15));
  CHECK(gap_at(chapter, 180 * degree).gap == Approx(0.4).epsilon(1e-14));
}

TEST_CASE("ex7.4 the point of the pin that is closest lies a gap away along the normal",
          "[ex7.4]") {
  for (const Fit& fit : {chapter, Fit{5, 0.2, 0.3}, Fit{5, 0, 1}, Fit{5, -0.1, -0.5}})
    for (const double theta : {10.0, 45.0, 90.0, 170.0, 250.0}) {
      CAPTURE(fit.clearance, fit.shift, theta);
      const Gap at = gap_at(fit, theta * degree);
      const double x = fit.hole_radius * std::cos(theta * degree) - at.gap * at.nx - fit.shift;
      const double y = fit.hole_radius * std::sin(theta * degree) - at.gap * at.ny;
      CHECK(std::hypot(at.nx, at.ny) == Approx(1).epsilon(1e-14));
      CHECK(std::hypot(x, y) == Approx(fit.hole_radius - fit.clearance).epsilon(1e-13));
      CHECK(x * at.ny - y * at.nx == Approx(0).margin(1e-13));
    }
}

// s^2 sin^2 theta / (2 R) is left between the two gaps: a quarter of it for half of the shift.
TEST_CASE("ex7.4 the linear gap is right to first order, and no further", "[ex7.4]") {
  const auto off = [](double size, double theta) {
    const double linear = size * (1 - std::cos(theta));
    return gap_at({5, size, size}, theta).gap - linear;
  };
  for (const double theta : {30 * degree, 90 * degree}) {
    CHECK(off(0.1, theta) / off(0.05, theta) == Approx(4).margin(0.2));
    CHECK(off(0.01, theta) == Approx(1e-5 * std::pow(std::sin(theta), 2)).epsilon(0.01));
  }
}

TEST_CASE("ex7.4 a tiny clearance keeps its digits", "[ex7.4]") {
  CHECK(gap_at({5, 5e-12, 5e-12}, 0.5).gap == Approx(5e-12 * (1 - std::cos(0.5))).epsilon(1e-9));
}

TEST_CASE("ex7.4 what is no fit is refused", "[ex7.4]") {
  CHECK_THROWS_AS(gap_at({5, 0.2, 5}, 1), std::invalid_argument);
  CHECK_THROWS_AS(gap_at({5, 0.2, -5}, 1), std::invalid_argument);
}

#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex7_2::half_contact_angle;

static const double pi = std::acos(-1.0);

// Hertz: wanted = 1 / (pi b^2), so the angle is 2 / sqrt(pi wanted).
TEST_CASE("ex7.2 held out: a pin that hardly touches is that of Hertz", "[ex7.2]") {
  for (const double wanted : {1e9, 1e12, 1e15, 1e20}) {
    CAPTURE(wanted);
    const ex7_2::ContactAngle found = half_contact_angle(wanted, 1);
    CHECK(found.angle == Approx(2 / std::sqrt(pi * wanted)).epsilon(1e-8).margin(0));
    CHECK(found.evaluations <= 200);
  }
}

// A thick pin: wanted tends to -2 r / pi, here -0.6366, as b grows.
TEST_CASE("ex7.2 held out: a pin thicker than the hole touches further", "[ex7.2]") {
  double before = half_contact_angle(0, 1).angle;
  for (const double wanted : {-0.01, -0.1, -0.3, -0.5, -0.6}) {
    CAPTURE(wanted);
    const ex7_2::ContactAngle found = half_contact_angle(wanted, 1);
    CHECK(found.angle > before);
    CHECK(found.angle < pi);
    const double b2 = std::pow(std::tan(found.angle / 2), 2);
    CHECK((1 - std::log1p(b2) - 2 * b2 * b2) / (pi * b2 * (1 + b2)) ==
          Approx(wanted).epsilon(1e-10).margin(0));
    before = found.angle;
  }
  CHECK(half_contact_angle(-0.637, 1).angle == Approx(pi).epsilon(1e-15));
  CHECK(half_contact_angle(-0.32, 0.5).angle == Approx(pi).epsilon(1e-15));
}

TEST_CASE("ex7.2 held out: a stiffer plate lets the pin bear further", "[ex7.2]") {
  double before = 0;
  for (const double ratio : {1.0, 0.7, 0.5, 0.1, 0.01}) {
    const double angle = half_contact_angle(0.3, ratio).angle;
    CHECK(angle > before);
    before = angle;
  }
}

TEST_CASE("ex7.2 held out: a relation without sense is refused", "[ex7.2]") {
  CHECK_THROWS_AS(half_contact_angle(1, 0), std::invalid_argument);
  CHECK_THROWS_AS(half_contact_angle(1, -1), std::invalid_argument);
  CHECK_THROWS_AS(half_contact_angle(std::numeric_limits<double>::quiet_NaN(), 1),
                  std::invalid_argument);
  CHECK_THROWS_AS(half_contact_angle(std::numeric_limits<double>::infinity(), 1),
                  std::invalid_argument);
}

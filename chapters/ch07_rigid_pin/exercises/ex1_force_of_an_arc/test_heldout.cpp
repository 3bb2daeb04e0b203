#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;
using Eigen::VectorXd;
using ex7_1::arc_force;

namespace {

const double pi = std::acos(-1.0);

}  // namespace

// p = cos t: the force along the pole is pi/2, across 0; linear pieces err with the square of their length.
TEST_CASE("ex7.1 held out: a cosine in ever finer pieces", "[ex7.1]") {
  double before = 1;
  for (const int n : {8, 16, 32, 64}) {
    const VectorXd angle = VectorXd::LinSpaced(n + 1, -pi / 2, pi / 2);
    const Vector2d force = arc_force(angle, angle.array().cos(), 1, 1);
    const double error = std::abs(force.x() - pi / 2);
    CHECK(error < before / 3.8);
    CHECK(std::abs(force.y()) < 1e-13);
    before = error;
  }
}

TEST_CASE("ex7.1 held out: where a straight pressure is cut does not matter", "[ex7.1]") {
  const VectorXd coarse = VectorXd::LinSpaced(2, -0.4, 1.3);
  const VectorXd fine = VectorXd::LinSpaced(1000, -0.4, 1.3);
  const Vector2d one = arc_force(coarse, 2 + 3 * coarse.array(), 5, 0.3);
  const Vector2d many = arc_force(fine, 2 + 3 * fine.array(), 5, 0.3);
  CHECK(equal_within(one, many, 1e-12 * one.norm()));
}

// A jump of the pressure within a billionth of a degree: the rest must not suffer.
TEST_CASE("ex7.1 held out: angles that nearly agree", "[ex7.1]") {
  for (const double sliver : {1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(sliver);
    VectorXd angle(4);
    angle << 0, 1, 1 + sliver, 1.5;
    VectorXd pressure(4);
    pressure << 2, 2, 5, 5;
    const Vector2d force = arc_force(angle, pressure, 1, 1);
    const Vector2d jump = 2 * Vector2d(std::sin(1), 1 - std::cos(1)) +
                          5 * Vector2d(std::sin(1.5) - std::sin(1), std::cos(1) - std::cos(1.5));
    CHECK(equal_within(force, jump, 3 * sliver + 1e-13));
  }
}

TEST_CASE("ex7.1 held out: a turned arc has a turned force", "[ex7.1]") {
  const VectorXd angle = VectorXd::LinSpaced(9, 0.1, 1.9);
  const VectorXd pressure = angle.array().square();
  const Vector2d here = arc_force(angle, pressure, 2, 3);
  const Vector2d there = arc_force(angle.array() + pi / 2, pressure, 2, 3);
  CHECK(equal_within(there, Vector2d(-here.y(), here.x()), 1e-12 * here.norm()));
}

TEST_CASE("ex7.1 held out: input that is no arc is refused", "[ex7.1]") {
  const VectorXd angle = VectorXd::LinSpaced(3, 0, 1);
  const VectorXd one = VectorXd::Ones(3);
  CHECK_THROWS_AS(arc_force(angle, one.head(2), 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(arc_force(angle.head(1), one.head(1), 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(arc_force(angle.reverse(), one, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(arc_force(angle, one, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(arc_force(angle, one, 1, -1), std::invalid_argument);
}

TEST_CASE("ex7.1 held out: a narrow arc is as exact as its pieces", "[ex7.1]") {
  const Vector2d whole = arc_force(Vector2d(0.3, 0.319), Vector2d(1, -1), 1, 1);
  const Vector2d pieces =
      arc_force(VectorXd::LinSpaced(20, 0.3, 0.319), VectorXd::LinSpaced(20, 1, -1), 1, 1);
  CHECK(equal_within(whole, pieces, 1e-15));
}

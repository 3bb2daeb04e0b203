#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::VectorXd;
using ex7_1::arc_force;

static const double pi = std::acos(-1.0);

static VectorXd list(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

// The force of a uniform pressure is that on the chord.
TEST_CASE("ex7.1 a uniform pressure pushes like on its chord", "[ex7.1]") {
  const Eigen::Vector2d half = arc_force(list({-pi / 2, 0, pi / 2}), list({1, 1, 1}), 1, 1);
  CHECK(half.x() == Approx(2).epsilon(1e-14));
  CHECK(half.y() == Approx(0).margin(1e-14));
  const Eigen::Vector2d quarter = arc_force(list({0, pi / 2}), list({3, 3}), 2, 0.5);
  CHECK(quarter.x() == Approx(3).epsilon(1e-14));
  CHECK(quarter.y() == Approx(3).epsilon(1e-14));
}

// Integrals by hand: t cos t and t sin t from 0 to pi/2 give pi/2 - 1 and 1.
TEST_CASE("ex7.1 a pressure that grows with the angle", "[ex7.1]") {
  const Eigen::Vector2d force = arc_force(list({0, pi / 2}), list({0, pi / 2}), 1, 1);
  CHECK(force.x() == Approx(pi / 2 - 1).epsilon(1e-14));
  CHECK(force.y() == Approx(1).epsilon(1e-14));
}

// Reading (C) on the 15 x 15 plate of the chapter; the load of the half plate is 250 kN.
TEST_CASE("ex7.1 the pin bears the load of the half plate", "[ex7.1]") {
  const VectorXd angle = VectorXd::LinSpaced(12, 0, pi / 2);
  const VectorXd pressure =
      list({63.60, 63.69, 63.61, 62.52, 59.67, 53.68, 44.31, 30.37, 3.56, 0, 0, 0});
  CHECK(arc_force(angle, pressure, 5, 1).x() == Approx(250).epsilon(0.01));
}

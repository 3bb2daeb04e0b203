#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Vector4d;
using Eigen::VectorXd;
using ex13_1::force_between;
using ex13_1::largest_deviation;

// arcsin(1/2) = pi/6: the middle half of the width carries a third of the load.
TEST_CASE("ex13.1 the middle half of the strip carries a third", "[ex13.1][LinEtAl-46]") {
  CHECK(force_between(1.5, 45, -0.75, 0.75) == Approx(15).epsilon(1e-14));
  CHECK(force_between(1.5, 45, 0.75, 1.5) == Approx(15).epsilon(1e-14));
}

TEST_CASE("ex13.1 all of the strip carries all of the load, and nothing more", "[ex13.1]") {
  CHECK(force_between(1.5, 45, -1.5, 1.5) == Approx(45).epsilon(1e-14));
  CHECK(force_between(1.5, 45, -7, 2) == Approx(45).epsilon(1e-14));
  CHECK(force_between(1.5, 45, 2, 3) == 0);
  CHECK(force_between(1.5, 45, 0.75, -0.75) == Approx(-15).epsilon(1e-14));
}

// Shares of nodes at 0, 1/2, sqrt(1/2), 1 by hand, in units of a and P / pi.
TEST_CASE("ex13.1 nodes get what lies around them", "[ex13.1]") {
  const Vector4d x(0, 0.5, std::sqrt(0.5), 1);
  const double cuts[] = {0, std::asin(0.25), std::asin((0.5 + std::sqrt(0.5)) / 2),
                         std::asin((std::sqrt(0.5) + 1) / 2), std::acos(0.0)};
  Vector4d force;
  for (int k = 0; k < 4; ++k) force(k) = cuts[k + 1] - cuts[k];
  const double load = std::acos(-1.0);
  CHECK(largest_deviation(x, force, 1, load, 1) < 1e-14);
  force(1) *= 0.97;
  CHECK(largest_deviation(x, force, 1, load, 1) == Approx(0.03).epsilon(1e-12));
  force(3) *= 1.16;
  CHECK(largest_deviation(x, force, 1, load, 1) == Approx(0.16).epsilon(1e-12));
  CHECK(largest_deviation(x, force, 1, load, 0.8) == Approx(0.03).epsilon(1e-12));
}

TEST_CASE("ex13.1 what is no strip and what are no nodes is refused", "[ex13.1]") {
  CHECK_THROWS_AS(force_between(-1.5, 45, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(largest_deviation(Vector4d(0, 1, 1, 1.5), Vector4d::Ones(), 1.5, 45, 1),
                  std::invalid_argument);
}

TEST_CASE("ex13.1 nodes near either edge are left out", "[ex13.1]") {
  VectorXd x(5), force(5);
  x << -1, -0.5, 0, 0.5, 1;
  force << 7, force_between(1, 1, -0.75, -0.25), force_between(1, 1, -0.25, 0.25),
      force_between(1, 1, 0.25, 0.75), 7;
  CHECK(largest_deviation(x, force, 1, 1, 0.8) < 1e-14);
}

#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using ex1_5::come_to_rest;
using ex1_5::Rest;

// Both stops are pushed back equally far, so that the stiffer one bears more.
TEST_CASE("ex1.5 held out: two stops in front of one cart share its force", "[ex1.5]") {
  const Rest rest = come_to_rest({Matrix2d::Ones(), Vector2d(-2, -2)}, Vector2d(1, 3));
  CHECK(rest.force(0) == Approx(3 * rest.force(1)).epsilon(1e-13));
  CHECK(rest.gap(0) == Approx(rest.gap(1)).epsilon(1e-13));
  CHECK(rest.force.sum() == Approx(2 / (1 + 0.75)).epsilon(1e-13));
}

TEST_CASE("ex1.5 held out: a rigid stop beside a soft one", "[ex1.5]") {
  const Rest rest = come_to_rest({Matrix2d::Identity(), Vector2d(-1, -1)}, Vector2d(0, 1));
  CHECK(equal_within(rest.force, Vector2d(1, 0.5), 1e-14));
  CHECK(equal_within(rest.gap, Vector2d(0, -0.5), 1e-14));
}

TEST_CASE("ex1.5 held out: the conditions hold for random bodies, in any unit", "[ex1.5]") {
  signorini::Random random(15);
  for (int sample = 0; sample < 100; ++sample) {
    const double unit = sample % 2 == 0 ? 1 : 1e-7;
    const Index n = random.whole(1, 8);
    MatrixXd B(n, n);
    VectorXd d(n), c(n);
    for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
    for (double& entry : d) entry = unit * random.uniform(-1, 0.5);
    for (double& entry : c) entry = unit * random.uniform(0, 2);
    const MatrixXd G = unit * (B * B.transpose() + 0.1 * MatrixXd::Identity(n, n));
    const Rest rest = come_to_rest({G, d}, c);
    CAPTURE(sample, n);
    CHECK((rest.gap - d - G * rest.force).norm() < 1e-12 * unit);
    CHECK(rest.force.minCoeff() >= 0);
    for (Index i = 0; i < n; ++i) {
      if (rest.force(i) > 0)
        CHECK(rest.gap(i) == Approx(-c(i) * rest.force(i)).epsilon(1e-9).margin(1e-12 * unit));
      else
        CHECK(rest.gap(i) >= -1e-12 * unit);
    }
  }
}

TEST_CASE("ex1.5 held out: what is no number is refused", "[ex1.5]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(come_to_rest({Matrix2d::Identity(), Vector2d(-1, -1)}, Vector2d(1, nan)),
                  std::invalid_argument);
}

#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"

using namespace ex7_5;
using Eigen::Vector2d;
using Eigen::VectorXd;

static HeldPlate one_pair(double d, double cosine, double load) {
  return {Eigen::MatrixXd::Ones(1, 1), VectorXd::Constant(1, d), VectorXd::Constant(1, cosine),
          load};
}

TEST_CASE("ex7.5 a support that pushed is a pair that bears", "[ex7.5]") {
  const Bearing bearing = pole_free(one_pair(-1, 0.8, 2));
  REQUIRE(bearing.force.size() == 1);
  CHECK(bearing.force(0) == Approx(1).epsilon(1e-12));
  CHECK(bearing.pole_force == Approx(1.2).epsilon(1e-12));
  CHECK(bearing.pole_gap == Approx(0).margin(1e-12));
}

TEST_CASE("ex7.5 a support that pulled is a pole that lifts off", "[ex7.5]") {
  const Bearing bearing = pole_free(one_pair(-10, 0.8, 2));
  REQUIRE(bearing.force.size() == 1);
  CHECK(bearing.force(0) == Approx(2.5).epsilon(1e-12));
  CHECK(bearing.pole_force == Approx(0).margin(1e-12));
  CHECK(bearing.pole_gap == Approx(9.375).epsilon(1e-12));
}

TEST_CASE("ex7.5 conditions at all pairs, and balance", "[ex7.5]") {
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 3).finished();
  for (const Vector2d& d :
       {Vector2d(-3, 0.5), Vector2d(-3, -8), Vector2d(1, 1), Vector2d(-30, 2)}) {
    const HeldPlate plate{G, d, Vector2d(0.9, 0.3), 5};
    CAPTURE(d.transpose());
    const Bearing at = pole_free(plate);
    REQUIRE(at.force.size() == 2);
    const VectorXd gap = d + G * at.force + plate.cosine * at.pole_gap;
    CHECK(at.pole_force + plate.cosine.dot(at.force) == Approx(5).epsilon(1e-12));
    CHECK(std::min({at.pole_force, at.pole_gap, at.force.minCoeff(), gap.minCoeff()}) > -1e-12);
    CHECK(std::abs(at.pole_force * at.pole_gap) + gap.cwiseProduct(at.force).cwiseAbs().sum() <
          1e-10);
  }
}

TEST_CASE("ex7.5 a load that pulls has no answer", "[ex7.5]") {
  CHECK_THROWS_AS(pole_free(one_pair(-1, 0.8, -2)), signorini::NotSolved);
}

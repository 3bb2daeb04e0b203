#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex19_2::nitsche_term;
using ex19_2::Point;
using ex19_2::Term;

namespace {

VectorXd random_row(signorini::Random& random) {
  VectorXd row(8);
  for (Index i = 0; i < 8; ++i) row(i) = random.uniform(-1, 1);
  return row;
}

Point random_point(signorini::Random& random) {
  return {random_row(random), random_row(random), random.uniform(-1, 1), random.uniform(0.1, 2)};
}

double energy(const Point& at, const VectorXd& u, double gamma) {
  const double q = at.pressure.dot(u);
  const double p = std::max(0.0, q - gamma * (at.free_gap + at.opening.dot(u)));
  return at.weight / (2 * gamma) * (p * p - q * q);
}

}  // namespace

TEST_CASE("ex19.2 held out: slopes are differences of forces, in all three variants", "[ex19.2]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 50; ++sample)
    for (const double theta : {1.0, 0.0, -1.0}) {
      const Point at = random_point(random);
      const VectorXd u = random_row(random);
      const Term term = nitsche_term(at, u, 1.7, theta);
      CAPTURE(sample, theta);
      for (Index i = 0; i < 8; ++i) {
        const VectorXd h = 1e-6 * VectorXd::Unit(8, i);
        const VectorXd slope = (nitsche_term(at, u + h, 1.7, theta).force -
                                nitsche_term(at, u - h, 1.7, theta).force) /
                               2e-6;
        CHECK(equal_within(slope, term.slope.col(i), 1e-7));
      }
    }
}

TEST_CASE("ex19.2 held out: the symmetric variant is the slope of an energy", "[ex19.2]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 50; ++sample) {
    const Point at = random_point(random);
    const VectorXd u = random_row(random);
    const Term term = nitsche_term(at, u, 0.6, 1);
    CAPTURE(sample);
    CHECK(equal_within(term.slope, term.slope.transpose(), 1e-13));
    for (Index i = 0; i < 8; ++i) {
      const VectorXd h = 1e-6 * VectorXd::Unit(8, i);
      CHECK((energy(at, u + h, 0.6) - energy(at, u - h, 0.6)) / 2e-6 ==
            Approx(term.force(i)).margin(1e-7));
    }
  }
}

TEST_CASE("ex19.2 held out: with theta = -1 no parameter makes the matrix lose energy",
          "[ex19.2]") {
  signorini::Random random(3);
  for (int sample = 0; sample < 50; ++sample)
    for (const double gamma : {1e-6, 1.0, 1e6}) {
      const Point at = random_point(random);
      const MatrixXd slope = nitsche_term(at, random_row(random), gamma, -1).slope;
      const MatrixXd both = (slope + slope.transpose()) / 2;
      const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(both).eigenvalues();
      // what cancels is rounded by its size
      const double terms = at.weight * (at.pressure.squaredNorm() / gamma + gamma);
      CAPTURE(sample, gamma);
      CHECK(values(0) > -1e-13 * terms);
    }
}

TEST_CASE("ex19.2 held out: what does not fit is refused", "[ex19.2]") {
  const VectorXd two = VectorXd::Ones(2);
  const Point right{two, two, 0, 1};
  CHECK_THROWS_AS(nitsche_term(right, two, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(nitsche_term(right, VectorXd::Ones(3), 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(nitsche_term({two, two, 0, 0}, two, 1, 1), std::invalid_argument);
}

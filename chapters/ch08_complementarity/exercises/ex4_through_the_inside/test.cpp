#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex8_4;
using Eigen::VectorXd;
using signorini::ContactProblem;

static const ContactProblem three{(Eigen::Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(),
                                  Eigen::Vector3d(3, -4, -1)};

static ContactProblem one_pair(double d, double G) {
  return {Eigen::MatrixXd::Constant(1, 1, G), VectorXd::Constant(1, d)};
}

// lambda (d + G lambda) = epsilon has one positive root.
TEST_CASE("ex8.4 one pair in closed form", "[ex8.4]") {
  CHECK(central(one_pair(-1, 1), 6).force(0) == Approx(3).epsilon(1e-12));
  CHECK(central(one_pair(-1, 1), 6).gap(0) == Approx(2).epsilon(1e-12));
  for (const double d : {-2.0, 0.0, 3.0})
    for (const double epsilon : {1e-8, 1e-2, 10.0}) {
      CAPTURE(d, epsilon);
      const double expected = 2 * epsilon / (d + std::sqrt(d * d + 20 * epsilon));
      const double stable = d < 0 ? (-d + std::sqrt(d * d + 20 * epsilon)) / 10 : expected;
      CHECK(central(one_pair(d, 5), epsilon).force(0) == Approx(stable).epsilon(1e-9));
    }
}

TEST_CASE("ex8.4 every product is epsilon, and the gaps are those of the forces", "[ex8.4]") {
  for (const double epsilon : {1e-10, 1e-5, 1.0, 1e4}) {
    CAPTURE(epsilon);
    const Inner inner = central(three, epsilon);
    REQUIRE(inner.force.size() == 3);
    REQUIRE(inner.gap.size() == 3);
    CHECK(inner.force.minCoeff() > 0);
    const VectorXd products = inner.force.cwiseProduct(inner.gap);
    CHECK((products / epsilon - VectorXd::Ones(3)).cwiseAbs().maxCoeff() < 1e-10);
    const VectorXd made = three.free_gap + three.compliance * inner.force;
    CHECK((made - inner.gap).cwiseAbs().maxCoeff() < 1e-11 * (4 + std::sqrt(epsilon)));
  }
}

TEST_CASE("ex8.4 no circle on three pairs", "[ex8.4][LinEtAl-11]") {
  const VectorXd force = through_the_inside(three);
  REQUIRE(force.size() == 3);
  CHECK(equal_within(force, Eigen::Vector3d(0, 0.4, 0), 1e-14));
}

TEST_CASE("ex8.4 a pair that touches, and pairs that are apart", "[ex8.4]") {
  const ContactProblem touching{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(),
                                Eigen::Vector2d(-2, -1)};
  CHECK(equal_within(through_the_inside(touching), Eigen::Vector2d(1, 0), 1e-12));
  CHECK(through_the_inside({Eigen::Matrix2d::Identity(), Eigen::Vector2d(1, 0)}).norm() == 0);
}

TEST_CASE("ex8.4 a product of zero is refused", "[ex8.4]") {
  CHECK_THROWS_AS(central(one_pair(-1, 1), 0), std::invalid_argument);
}

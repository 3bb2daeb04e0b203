#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Vector2d;
using Eigen::VectorXd;
using ex17_2::forces_of;
using ex17_2::stiffness_for;
using signorini::ContactProblem;

static ContactProblem one(double G, double d) {
  return {Eigen::MatrixXd::Constant(1, 1, G), VectorXd::Constant(1, d)};
}

// Closed form: G lambda + lambda / k = -d.
TEST_CASE("ex17.2 one pair", "[ex17.2]") {
  for (const double k : {1e-3, 1.0, 1e6})
    CHECK(forces_of(one(2, -1), k)(0) == Approx(1 / (2 + 1 / k)).epsilon(1e-12));
  CHECK(forces_of(one(2, 1), 5)(0) == 0);
  CHECK(stiffness_for(one(2, -1), 0.01) == Approx(49.5).epsilon(1e-8));
  CHECK(stiffness_for(one(2, 1), 0.01) == 0);
}

TEST_CASE("ex17.2 a pair that others push open has no force", "[ex17.2]") {
  const ContactProblem problem{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-4, -1)};
  const VectorXd force = forces_of(problem, 1e9);
  CHECK(force(0) == Approx(2).epsilon(1e-8));
  CHECK(force(1) == 0);
}

TEST_CASE("ex17.2 the share is one of the largest overlap", "[ex17.2]") {
  const ContactProblem two{Eigen::Matrix2d::Identity(), Vector2d(-1, -0.1)};  // 1 / (1 + k) is left
  CHECK(stiffness_for(two, 0.5) == Approx(1).epsilon(1e-8));
}

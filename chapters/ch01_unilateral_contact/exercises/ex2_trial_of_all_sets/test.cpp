#include <algorithm>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A spring k pulled by p towards a stop at g: u = min(p / k, g), the stop bears the rest of p.
TEST_CASE("ex1.2 one spring and one stop follow the closed form", "[ex1.2]") {
  const double k = 4;
  const double g = 0.5;
  const double p = GENERATE(-3.0, 1.0, 2.0, 10.0);  // away, open, just touching, closed
  CAPTURE(p);
  const ex1_2::Rest rest =
      ex1_2::solve_by_trial(MatrixXd::Constant(1, 1, k), VectorXd::Constant(1, p),
                            MatrixXd::Ones(1, 1), VectorXd::Constant(1, g));
  REQUIRE(rest.displacement.size() == 1);
  REQUIRE(rest.contact_force.size() == 1);
  CHECK(rest.displacement(0) == Approx(std::min(p / k, g)).epsilon(1e-14));
  CHECK(rest.contact_force(0) == Approx(std::max(0.0, p - k * g)).epsilon(1e-14).margin(1e-13));
}

// Without contact both rows are violated. Closing both takes the forces 4 and -2: the second pair
// would have to pull. Only the first one is closed.
TEST_CASE("ex1.2 a pair that would pull is open", "[ex1.2]") {
  const MatrixXd K = Vector2d(2, 4).asDiagonal();
  const Matrix2d A = (Matrix2d() << 1, 0, 1, 1).finished();
  const ex1_2::Rest rest = ex1_2::solve_by_trial(K, Vector2d(2, -2), A, Vector2d(0, 0));
  REQUIRE(rest.displacement.size() == 2);
  REQUIRE(rest.contact_force.size() == 2);
  CHECK(equal_within(rest.displacement, Vector2d(0, -0.5), 1e-14));
  CHECK(equal_within(rest.contact_force, Vector2d(2, 0), 1e-14));
}

// Between two stops at -1 and 0.5 a spring is pulled to the right. Closing the left one instead keeps
// both gaps in order, but it would have to pull with -4.
TEST_CASE("ex1.2 the stop on the wrong side is not held by tension", "[ex1.2]") {
  const Eigen::Index left = GENERATE(0, 1);
  CAPTURE(left);
  Vector2d towards(1, 1);
  towards(left) = -1;
  Vector2d g(0.5, 0.5);
  g(left) = 1;
  const ex1_2::Rest rest =
      ex1_2::solve_by_trial(MatrixXd::Constant(1, 1, 2.0), VectorXd::Constant(1, 2.0), towards, g);
  REQUIRE(rest.displacement.size() == 1);
  REQUIRE(rest.contact_force.size() == 2);
  CHECK(rest.displacement(0) == Approx(0.5).epsilon(1e-14));
  CHECK(rest.contact_force(left) == 0);
  CHECK(rest.contact_force(1 - left) == Approx(1).epsilon(1e-14));
}

// Three unknowns; two of three pairs close. Reference by hand: K u + A^T lambda = p, A u = (0, 1, -1).
TEST_CASE("ex1.2 two of three pairs are closed", "[ex1.2]") {
  MatrixXd K(3, 3);
  K << 4, 1, 0, 1, 3, 1, 0, 1, 2;
  MatrixXd A(3, 3);
  A << 1, 1, 0, 0, 1, 1, 1, 0, -1;
  const ex1_2::Rest rest = ex1_2::solve_by_trial(K, Vector3d(5, 5, 6), A, Vector3d(0, 1, 3));
  REQUIRE(rest.displacement.size() == 3);
  REQUIRE(rest.contact_force.size() == 3);
  CHECK(equal_within(rest.displacement, Vector3d(1, -1, 2), 1e-13));
  CHECK(equal_within(rest.contact_force, Vector3d(2, 3, 0), 1e-13));
}

TEST_CASE("ex1.2 a pair that just touches bears nothing", "[ex1.2]") {
  const ex1_2::Rest rest = ex1_2::solve_by_trial(Matrix2d::Identity(), Vector2d(1, 3),
                                                 Matrix2d::Identity(), Vector2d(1, 2));
  REQUIRE(rest.displacement.size() == 2);
  REQUIRE(rest.contact_force.size() == 2);
  CHECK(equal_within(rest.displacement, Vector2d(1, 2), 1e-14));
  CHECK(equal_within(rest.contact_force, Vector2d(0, 1), 1e-14));
}

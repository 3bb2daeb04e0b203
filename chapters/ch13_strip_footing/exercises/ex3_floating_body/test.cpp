#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"
#include "support/equal_within.hpp"

using namespace ex13_3;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Carts in a row, each joined to the next by a spring; walls before the first and behind the last.
static FloatingBody carts(const VectorXd& load, double spring, double left, double right) {
  const Index n = load.size();
  FloatingBody body{MatrixXd::Zero(n, n), VectorXd::Ones(n), load, MatrixXd::Zero(2, n),
                    Eigen::Vector2d(left, right)};
  for (Index i = 0; i + 1 < n; ++i)
    body.stiffness.block<2, 2>(i, i) += spring * (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  body.A(0, 0) = -1;
  body.A(1, n - 1) = 1;
  return body;
}

static void check_rest(const FloatingBody& body, const Rest& rest,
                       const std::vector<Index>& closed) {
  REQUIRE(rest.force.size() == 2);
  REQUIRE(rest.displacement.size() == body.load.size());
  const VectorXd missing =
      body.load - body.A.transpose() * rest.force - body.stiffness * rest.displacement;
  CHECK(missing.cwiseAbs().maxCoeff() < 1e-12);
  for (const Index pair : closed)
    CHECK(body.initial_gap(pair) - body.A.row(pair).dot(rest.displacement) ==
          Approx(0).margin(1e-13));
}

TEST_CASE("ex13.3 two carts against a wall: balance alone says the force", "[ex13.3]") {
  for (const double spring : {0.1, 2.0, 1e4}) {
    CAPTURE(spring);
    const FloatingBody body = carts(Eigen::Vector2d(3, 1), spring, 9, 0.5);
    const Rest rest = rest_of(body, 0, {1});
    check_rest(body, rest, {1});
    CHECK(rest.force(0) == 0);
    CHECK(rest.force(1) == Approx(4).epsilon(1e-12));
    CHECK(rest.amplitude == Approx(0.5 + 3 / spring).epsilon(1e-12));
  }
}

// Squeezed between both walls, who bears what depends on the springs.
TEST_CASE("ex13.3 three carts that are too long for their slot", "[ex13.3]") {
  const FloatingBody body = carts(Eigen::Vector3d(0, 6, 0), 10, -0.5, -0.5);
  const Rest rest = rest_of(body, 1, {0, 1});
  check_rest(body, rest, {0, 1});
  CHECK(rest.force(0) == Approx(2).epsilon(1e-12));
  CHECK(rest.force(1) == Approx(8).epsilon(1e-12));
  CHECK(rest.amplitude == Approx(0.3).epsilon(1e-12));
}

TEST_CASE("ex13.3 forces and displacements do not know which unknown was held", "[ex13.3]") {
  const FloatingBody body = carts(Eigen::Vector4d(1, -2, 5, 3), 2, 0.1, 0.4);
  const Rest first = rest_of(body, 0, {1});
  for (Index held = 1; held < 3; ++held) {
    CAPTURE(held);
    const Rest other = rest_of(body, held, {1});
    check_rest(body, other, {1});
    CHECK(equal_within(other.force, first.force, 1e-12));
    CHECK(equal_within(other.displacement, first.displacement, 1e-12));
    CHECK(other.amplitude == Approx(other.displacement(held)).epsilon(1e-12));
  }
}

TEST_CASE("ex13.3 what nothing stops, and what cannot be held, is refused", "[ex13.3]") {
  FloatingBody body = carts(Eigen::Vector3d(1, 0, 0), 1, 0, 0);
  body.A.row(0) << -1, 1, 0;  // between two carts: the motion does not change this gap
  CHECK_THROWS_AS(rest_of(body, 0, {0}), signorini::ProblemError);
  body.motion(1) = 0;
  CHECK_THROWS_AS(rest_of(body, 1, {1}), std::invalid_argument);
}

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;
using ex17_3::find_proof;
using ex17_3::proves;
using signorini::ContactProblem;

// A body in a slot: what opens one gap closes the other.
static ContactProblem slot(double play) {
  return {(Matrix2d() << 1, -1, -1, 1).finished(), Vector2d(-1, 1 + play)};
}

TEST_CASE("ex17.3 a slot that is too narrow", "[ex17.3]") {
  CHECK(proves(slot(-0.5), Vector2d(1, 1)));
  CHECK_FALSE(proves(slot(-0.5), Vector2d(1, 0)));  // moves the body
  CHECK_FALSE(proves(slot(-0.5), Vector2d(-1, -1)));
  CHECK_FALSE(proves(slot(0.5), Vector2d(1, 1)));    // there is room
  CHECK_FALSE(proves(slot(0), Vector2d(1, 1)));      // it just fits
  CHECK_FALSE(proves(slot(0.5), Vector2d(-1, -1)));  // d.y < 0, but weights must not be negative
}

TEST_CASE("ex17.3 the proof is found", "[ex17.3]") {
  const VectorXd y = find_proof(slot(-0.5));
  REQUIRE(y.size() == 2);
  CHECK(y(0) == y(1));
  CHECK(proves(slot(-0.5), y));
  CHECK(find_proof(slot(0.5)).size() == 0);
}

// Three rows a = 1, -1 and 1: the weights 2, 1 and -1 add up to nothing, and the gaps to less.
TEST_CASE("ex17.3 no weight of a proof is negative", "[ex17.3]") {
  const Eigen::Vector3d a(1, -1, 1), d(0.5, 0.5, 3);
  const Eigen::Matrix3d G = a * a.transpose();
  CHECK(proves({G, d}, Eigen::Vector3d(2, 1, -1)) == false);
}

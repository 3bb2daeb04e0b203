#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex20_1;

// The carts of chapter 1: G_ij = min(i, j), overlaps of 2, 1 and 3 mm.
static Eigen::MatrixXd carts() {
  return (Eigen::Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished();
}

TEST_CASE("ex20.1 the force with the largest column joins, and the second overlap ends first",
          "[ex20.1]") {
  const Tableau tableau = start(carts(), Eigen::Vector3d(-2, -1, -3));
  CHECK(joining(tableau) == 5);
  CHECK(leaving(tableau, 5) == 1);
}

TEST_CASE("ex20.1 the carts take three exchanges", "[ex20.1]") {
  const Run run = solve(carts(), Eigen::Vector3d(-2, -1, -3));
  CHECK(run.joined == std::vector<Index>{5, 1, 3});
  CHECK(run.left == Approx(0).margin(1e-14));
  CHECK(equal_within(run.force, Eigen::Vector3d(1.5, 0, 0.5), 1e-14));
}

TEST_CASE("ex20.1 nothing joins if no pair overlaps", "[ex20.1]") {
  CHECK(joining(start(carts(), Eigen::Vector3d(0, 1, 2))) == -1);
}

// All of these would lower the sum; the gap of a force in the basis may not.
TEST_CASE("ex20.1 a partner of what is in the basis does not join", "[ex20.1]") {
  Tableau tableau = start(carts(), Eigen::Vector3d(-2, -1, -3));
  exchange(tableau, 1, 4);  // lambda_2 for the second overlap
  tableau.rows(0, 1) = 9;   // as if w_2 lowered the first overlap nine times as fast
  CHECK(joining(tableau) != 1);
}

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex4_4;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using signorini::ContactProblem;

static ContactProblem three() {
  return {(Matrix3d() << 5, -4, 3, -4, 5, -2, 3, -2, 2).finished(), Vector3d(2, -3, 0)};
}

TEST_CASE("ex4.4 who overlaps joins, the largest overlap first", "[ex4.4]") {
  CHECK(group_of(three(), Vector3d(0, 0, 0)) == Rows{1});
  CHECK(group_of(three(), Vector3d(0, 0.6, 0)) == Rows{1, 2, 0});  // gaps -0.4, 0, -1.2
}

TEST_CASE("ex4.4 a group that presses joins at once", "[ex4.4]") {
  const Round round =
      group_step({(Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-7, -5)}, Vector2d(0, 0), {0, 1});
  CHECK(round.at_once);
  CHECK(equal_within(round.force, Vector2d(3, 1), 1e-14));
}

// Closing all three takes the forces -6, -1 and 8. Without 1 and 2 nothing is left of the energy 9/10.
TEST_CASE("ex4.4 what was too bold is done with care", "[ex4.4]") {
  const Round round = group_step(three(), Vector3d(0, 0.6, 0), {1, 2, 0});
  CHECK_FALSE(round.at_once);
  CHECK(equal_within(round.force, Vector3d(0, 1, 1), 1e-13));
}

TEST_CASE("ex4.4 two rounds from no force to the solution", "[ex4.4]") {
  const std::vector<Round> rounds = drive(three(), 10);
  REQUIRE(rounds.size() == 2);
  CHECK(equal_within(rounds[0].force, Vector3d(0, 0.6, 0), 1e-14));
  CHECK(equal_within(rounds[1].force, Vector3d(0, 1, 1), 1e-13));
}

// Two rows for one gap, written twice: only one of them can be closed.
TEST_CASE("ex4.4 a pair that depends on those before stays out", "[ex4.4]") {
  const ContactProblem twice{Matrix2d::Ones(), Vector2d(-2, -1)};
  CHECK(group_of(twice, Vector2d(0, 0)) == Rows{0});
}

// What chapter 4 keeps of the quasi-active set: who joins, and how.
#include "../chapters/ch04_quasi_active_set/group_step.hpp"
#include "catch_compat.hpp"

using namespace ch04;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// The second pair moves with the first: its pivot is zero, and its compliance is not what is left of it.
TEST_CASE("of a row written twice only the first joins", "[group_step][exact]") {
  const ContactProblem twice{Matrix2d::Ones(), Vector2d(-2, -1)};
  CHECK((propose(twice, Vector2d(0, 0), {0, 1}) == Rows{0}));
  CHECK_THROWS_AS(propose(twice, Vector2d(0.5, 0), {1}), signorini::NotSolved);
}

TEST_CASE("behind a pair that depends on others an independent one still joins",
          "[group_step][exact]") {
  const Matrix3d G = (Matrix3d() << 1, 1, 0, 1, 1, 0, 0, 0, 1).finished();
  CHECK((propose({G, Vector3d(-3, -2, -1)}, Vector3d(0, 0, 0), {0, 1, 2}) == Rows{0, 2}));
}

TEST_CASE("a group that was too bold joins with care", "[group_step][exact]") {
  const ContactProblem three{(Matrix3d() << 5, -4, 3, -4, 5, -2, 3, -2, 2).finished(),
                             Vector3d(2, -3, 0)};
  const VectorXd old = Vector3d(0, 0.6, 0);
  CHECK(dual_energy(three, at_once(three, {1, 2, 0})) < dual_energy(three, old));
  CHECK((group_step(three, old, {1, 2, 0}) - Vector3d(0, 1, 1)).norm() < 1e-13);
}

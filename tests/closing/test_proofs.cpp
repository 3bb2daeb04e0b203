// What counts as a proof that nothing solves a problem, and as equations that hold, by hand.
#include "catch_compat.hpp"
#include "signorini/closing/proofs.hpp"

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using namespace signorini;

TEST_CASE("overlaps that a rigid motion opens prove nothing", "[closing][floating]") {
  const Matrix2d G = (Matrix2d() << 1, -1, -1, 1).finished();  // pressing both pairs moves nothing
  const Vector2d both(1, 1);
  ContactProblem problem{G, Vector2d(-1, -1)};
  CHECK(refutes(problem, both));
  problem.resultant = Eigen::VectorXd::Constant(1, 2);
  problem.rigid = both;
  CHECK_FALSE(refutes(problem, both));  // a = 1 opens both pairs, and forces of 1 balance r
  problem.resultant.setZero();
  problem.rigid = Vector2d(1, -1);
  CHECK(refutes(problem, both));  // what opens one pair closes the other
}

TEST_CASE("closed pairs that cannot balance the load are no solution of their equations",
          "[closing][floating]") {
  // A load of 2 along the only mode presses both pairs alike.
  ContactProblem problem{Matrix2d::Identity(), Vector2d(1, 2)};
  problem.rigid = Vector2d(1, 1);
  problem.resultant = Eigen::VectorXd::Constant(1, 2);
  const ScaledProblem scaled = equilibrate(problem);
  CHECK_FALSE(close(scaled, KnownSet{}).solvable);
  const Closure one = close(scaled, KnownSet{{0}});
  CHECK(one.solvable);
  CHECK(one.force(0) == Approx(2));
  CHECK(one.movement(1) == Approx(-1));  // 2 + a with 1 + 2 + a = 0
  const Closure both = close(scaled, KnownSet{{0, 1}});
  CHECK(both.solvable);
  CHECK((both.force - Vector2d(1.5, 0.5)).norm() < 1e-14);
}

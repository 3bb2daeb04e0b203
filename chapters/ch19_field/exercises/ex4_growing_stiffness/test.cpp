#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector3d;
using signorini::ContactProblem;

static ContactProblem one() {
  return {Eigen::MatrixXd::Constant(1, 1, 1), Eigen::VectorXd::Constant(1, -1)};
}

static ContactProblem carts() {
  return {(Eigen::Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(), Vector3d(-2, -1, -3)};
}

TEST_CASE("ex19.4 one pair, from soft springs and from stiff ones", "[ex19.4]") {
  const ex19_4::Ending soft = ex19_4::augmented_lagrangian(one(), 1e-6, 1e-12, 1000);
  CHECK(soft.ended);
  CHECK(soft.passes <= 20);
  CHECK(soft.force(0) == Approx(1).epsilon(1e-11));
  CHECK(ex19_4::augmented_lagrangian(one(), 1e6, 1e-12, 1000).passes <= 3);
}

TEST_CASE("ex19.4 springs that are stiff enough stay as they are", "[ex19.4]") {
  const ex19_4::Ending two = ex19_4::augmented_lagrangian(one(), 99, 1e-12, 2);
  CHECK(two.force(0) == Approx(1 - 1e-4).epsilon(1e-12));  // each pass leaves a hundredth
}

TEST_CASE("ex19.4 three carts", "[ex19.4]") {
  const ex19_4::Ending end = ex19_4::augmented_lagrangian(carts(), 0.01, 1e-12, 1000);
  CHECK(end.ended);
  CHECK(end.passes < 20);
  CHECK(equal_within(end.force, Vector3d(1.5, 0, 0.5), 1e-9));
}

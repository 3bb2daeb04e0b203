#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector3d;

static Eigen::Matrix3d carts() {
  return (Eigen::Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished();
}

TEST_CASE("ex19.1 three carts", "[ex19.1]") {
  const ex19_1::Ending end = ex19_1::uzawa(carts(), Vector3d(-2, -1, -3), 1e-12, 100000);
  CHECK(end.ended);
  CHECK(equal_within(end.force, Vector3d(1.5, 0, 0.5), 1e-9));
}

TEST_CASE("ex19.1 the first two passes, by hand", "[ex19.1]") {
  const Vector3d d(-2, -1, -3);  // steps 1/3, 1/5, 1/6
  const Vector3d one(2.0 / 3, 1.0 / 5, 1.0 / 2);
  CHECK(equal_within(ex19_1::uzawa(carts(), d, 1e-12, 1).force, one, 1e-14));
  const Vector3d gap = d + carts() * one;
  const Vector3d two = (one - Vector3d(gap(0) / 3, gap(1) / 5, gap(2) / 6)).cwiseMax(0);
  CHECK(equal_within(ex19_1::uzawa(carts(), d, 1e-12, 2).force, two, 1e-14));
  CHECK(!ex19_1::uzawa(carts(), d, 1e-12, 2).ended);
  CHECK(ex19_1::uzawa(carts(), d, 1e-12, 2).passes == 2);
}

TEST_CASE("ex19.1 nothing overlaps", "[ex19.1]") {
  const ex19_1::Ending end = ex19_1::uzawa(carts(), Vector3d(2, 0, 3), 1e-12, 10);
  CHECK(end.ended);
  CHECK(end.passes == 1);
  CHECK(end.force.isZero());
}

// The first pass has the solution, and the second one sees it; the open pair is far away, and does not count.
TEST_CASE("ex19.1 the accuracy is a part of the largest overlap", "[ex19.1]") {
  const ex19_1::Ending end =
      ex19_1::uzawa(Eigen::Matrix2d::Identity(), Eigen::Vector2d(-1, 1000), 1e-3, 10);
  CHECK(end.ended);
  CHECK(end.passes == 2);
}

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex0_2::Part;
using ex0_2::System;

// A spring along x between two nodes; it leaves y alone.
static Part spring(Eigen::Index from, Eigen::Index to, double stiffness) {
  Eigen::Matrix4d K = Eigen::Matrix4d::Zero();
  K(0, 0) = K(2, 2) = stiffness;
  K(0, 2) = K(2, 0) = -stiffness;
  return {{from, to}, K};
}

TEST_CASE("ex0.2 two springs with both ends held", "[ex0.2]") {
  const System system = ex0_2::assemble(3, {spring(0, 1, 1), spring(1, 2, 1)},
                                        {{0, 0}, {1, 0}, {3, 0}, {4, 3}, {5, 0}});
  REQUIRE(system.stiffness.rows() == 1);
  CHECK(system.stiffness.coeff(0, 0) == 2);
  CHECK(system.load(0) == 3);
}

TEST_CASE("ex0.2 three carts have the matrix of chapter 1", "[ex0.2]") {
  const System system = ex0_2::assemble(4, {spring(0, 1, 1), spring(1, 2, 1), spring(2, 3, 1)},
                                        {{0, 0}, {1, 0}, {3, 0}, {5, 0}, {7, 0}});
  Eigen::Matrix3d K;
  K << 2, -1, 0, -1, 2, -1, 0, -1, 1;
  REQUIRE(system.stiffness.rows() == 3);
  CHECK(Eigen::Matrix3d(system.stiffness) == K);
  CHECK(system.load.isZero());
}

TEST_CASE("ex0.2 nothing held: every component is an unknown", "[ex0.2]") {
  const System system = ex0_2::assemble(2, {spring(1, 0, 5)}, {});
  REQUIRE(system.stiffness.rows() == 4);
  CHECK(system.stiffness.coeff(0, 0) == 5);
  CHECK(system.stiffness.coeff(0, 2) == -5);
  CHECK(system.stiffness.coeff(1, 1) == 0);
}

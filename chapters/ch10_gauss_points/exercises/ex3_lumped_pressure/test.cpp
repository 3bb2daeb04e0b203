#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST_CASE("ex10.3 a force at one of two points goes to both nodes", "[ex10.3][LinEtAl-35]") {
  const double xi = 1 / std::sqrt(3.0);
  const Vector2d points(0.5 - xi / 2, 0.5 + xi / 2), weight(0.5, 0.5);
  const VectorXd p = ex10_3::lumped_pressure(Vector2d(0, 1), points, weight, Vector2d(1, 0));
  CHECK(equal_within(p, Vector2d(1 + xi, 1 - xi), 1e-15));
}

TEST_CASE("ex10.3 forces that the nodes cannot tell apart are one pressure", "[ex10.3]") {
  const Vector3d points(0.25, 0.5, 0.75), weight(0.25, 0.5, 0.25);
  const VectorXd even = ex10_3::lumped_pressure(Vector2d(0, 1), points, weight, weight);
  const VectorXd bang = ex10_3::lumped_pressure(Vector2d(0, 1), points, weight, Vector3d(0, 1, 0));
  CHECK(equal_within(even, Vector2d(1, 1), 1e-15));
  CHECK(equal_within(bang, even, 1e-15));
}

TEST_CASE("ex10.3 a node without points has no pressure", "[ex10.3]") {
  VectorXd nodes(4), point(1), one(1);
  nodes << 0, 1, 2, 3;
  point << 0.5;
  one << 1;
  const VectorXd p = ex10_3::lumped_pressure(nodes, point, one, 2 * one);
  CHECK(equal_within(p, Eigen::Vector4d(2, 2, 0, 0), 1e-15));
}

TEST_CASE("ex10.3 edges need not begin at zero", "[ex10.3]") {
  VectorXd point(1), weight(1), force(1);
  point << 2.5;
  weight << 2;
  force << 4;
  const VectorXd p = ex10_3::lumped_pressure(Vector3d(1, 2, 4), point, weight, force);
  CHECK(equal_within(p, Vector3d(0, 2, 2), 1e-15));
  const VectorXd share = ex10_3::lumped_pressure(Vector3d(1, 2, 4), Vector2d(2.5, 3.5),
                                                 Vector2d(1, 1), Vector2d(1, 0));
  CHECK(equal_within(share, Vector3d(0, 0.75, 0.25), 1e-15));
}

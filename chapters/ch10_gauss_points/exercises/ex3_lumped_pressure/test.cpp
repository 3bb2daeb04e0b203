#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST_CASE("ex10.3 a force at one of two points goes to both nodes", "[ex10.3][LinEtAl-35]") {
  const double xi = 1 / std::sqrt(3.0);
  const Vector2d points(0.5 - xi / 2, 0.5 + xi / 2), weight(0.5, 0.5);
  const VectorXd p = ex10_3::lumped_pressure(Vector2d(0, 1), points, weight, Vector2d(1, 0));
  CHECK((p - Vector2d(1 + xi, 1 - xi)).norm() < 1e-15);
}

TEST_CASE("ex10.3 forces that the nodes cannot tell apart are one pressure", "[ex10.3]") {
  const Vector3d points(0.25, 0.5, 0.75), weight(0.25, 0.5, 0.25);
  const VectorXd even = ex10_3::lumped_pressure(Vector2d(0, 1), points, weight, weight);
  const VectorXd bang = ex10_3::lumped_pressure(Vector2d(0, 1), points, weight, Vector3d(0, 1, 0));
  CHECK((even - Vector2d(1, 1)).norm() < 1e-15);
  CHECK((bang - even).norm() < 1e-15);
}

TEST_CASE("ex10.3 a node without points has no pressure", "[ex10.3]") {
  VectorXd nodes(4), point(1), one(1);
  nodes << 0, 1, 2, 3;
  point << 0.5;
  one << 1;
  const VectorXd p = ex10_3::lumped_pressure(nodes, point, one, 2 * one);
  CHECK((p - Eigen::Vector4d(2, 2, 0, 0)).norm() < 1e-15);
}

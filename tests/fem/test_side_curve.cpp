#include <cmath>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/side_curve.hpp"
#include "support/random.hpp"

using Eigen::Vector2d;
using namespace signorini;
using signorini_test::Random;

namespace {

/// The bottom of one cell, from (0, 0) to `last`; with its middle at `middle` if it is quadratic.
SideCurve bottom_side(MeshOrder order, const Vector2d& middle = {1, 0},
                      const Vector2d& last = {2, 0}) {
  Mesh mesh = block("block", {0, 0}, {2, 1}, 1, 1, order);
  const CellSide side = boundary(mesh, "bottom").front();
  mesh.nodes.row(mesh.side_nodes(side).back()) = last.transpose();
  if (order == MeshOrder::Quadratic) mesh.nodes.row(mesh.side_nodes(side)[1]) = middle.transpose();
  return {mesh, side};
}

double smallest_distance(const SideCurve& curve, const Vector2d& x) {
  double smallest = (curve.point(-1) - x).norm();
  for (int k = 0; k <= 4000; ++k)
    smallest = std::min(smallest, (curve.point(-1 + k / 2000.0) - x).norm());
  return smallest;
}

}  // namespace

TEST_CASE("a side passes through its nodes, and its normal points out of the body", "[side]") {
  const SideCurve straight = bottom_side(MeshOrder::Linear);
  CHECK(straight.point(-1).position() == Vector2d(0, 0));
  CHECK(straight.point(1).position() == Vector2d(2, 0));
  CHECK(straight.normal(0.3) == Vector2d(0, -1));
  const SideCurve bent = bottom_side(MeshOrder::Quadratic, {1.1, -0.4});
  CHECK(bent.point(-1).position() == Vector2d(0, 0));
  CHECK(bent.point(0).position() == Vector2d(1.1, -0.4));
  CHECK(bent.point(1).position() == Vector2d(2, 0));
  for (const double xi : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
    const Vector2d difference = (bent.point(xi + 1e-6) - bent.point(xi - 1e-6)) / 2e-6;
    CHECK((bent.tangent(xi) - difference).norm() < 1e-9);
    CHECK(std::abs(bent.normal(xi).dot(bent.tangent(xi))) < 1e-15);
    CHECK(bent.normal(xi).y() < 0);
    const SideShape shape = bent.shape(xi);
    CHECK(shape.value.sum() == Approx(1).epsilon(1e-15));
    CHECK(std::abs(shape.slope.sum()) < 1e-15);
    const Vector2d x = shape.value(1) * Vector2d(1.1, -0.4) + shape.value(2) * Vector2d(2, 0);
    CHECK((bent.point(xi) - x).norm() < 1e-15);
  }
}

TEST_CASE("the ends of a side are its nodes, bit for bit", "[side]") {
  Random random(11);
  for (int sample = 0; sample < 100; ++sample) {
    const Vector2d last(random.uniform(1.5, 2.5), random.uniform(-0.5, 0.5));
    const Vector2d middle(random.uniform(0.8, 1.2), random.uniform(-0.5, 0.5));
    for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
      const SideCurve side = bottom_side(order, middle, last);
      CHECK(side.point(-1).position() == Vector2d(0, 0));
      CHECK(side.point(1).position() == last);
    }
  }
}

TEST_CASE("the closest place of a parabola is the closest of all, however it is bent", "[side]") {
  Random random(3);
  for (int k = 0; k < 300; ++k) {
    const Vector2d middle(random.uniform(0.55, 1.45), random.uniform(-0.9, 0.9));
    const SideCurve curve = bottom_side(MeshOrder::Quadratic, middle);
    const Vector2d x(random.uniform(-1, 3), random.uniform(-2, 2));
    const double xi = curve.closest(x);
    CAPTURE(middle.transpose(), x.transpose(), xi);
    const Vector2d arm = x - curve.point(xi);
    CHECK(arm.norm() <= smallest_distance(curve, x) + 1e-15);
    if (std::abs(xi) < 1) CHECK(std::abs(arm.dot(curve.tangent(xi))) < 1e-14);
  }
}

TEST_CASE("from the axis of a parabola both flanks are as near, and the first is taken", "[side]") {
  const SideCurve curve = bottom_side(MeshOrder::Quadratic, {1, -1});
  // y = (x - 1)^2 - 1: from a height h over the bottom the feet lie at (x - 1)^2 = h - 1/2.
  const double xi = curve.closest({1, -0.25});
  CHECK(xi == Approx(-0.5).epsilon(1e-14));
  CHECK(curve.closest({1, -0.6}) == 0);
}

TEST_CASE("beyond its ends a side is continued as the same curve", "[side]") {
  const SideCurve straight = bottom_side(MeshOrder::Linear);
  CHECK(straight.continued({2.1, -5}, 1) == Approx(1.1).epsilon(1e-15));
  CHECK(straight.continued({-0.1, 5}, -1) == Approx(-1.1).epsilon(1e-15));
  const SideCurve bent = bottom_side(MeshOrder::Quadratic, {1, -0.2});
  const AnchoredPoint beyond = bent.point(1.001).moved(0.05, {bent.normal(1.001), {0, 0}});
  CHECK(bent.continued(beyond, 1) == Approx(1.001).epsilon(1e-12));
}

TEST_CASE("a line meets a parabola in up to two places", "[side]") {
  const SideCurve curve = bottom_side(MeshOrder::Quadratic, {1, -1});
  const std::vector<double> two = curve.crossings({5, -0.75}, {1, 0}, 0);
  REQUIRE(two.size() == 2);
  CHECK(two[0] == Approx(-0.5).epsilon(1e-15));
  CHECK(two[1] == Approx(0.5).epsilon(1e-15));
  CHECK(curve.crossings({5, -1.25}, {1, 0}, 0).empty());
  const std::vector<double> one = curve.crossings({1.5, 7}, {0, -1}, 0);
  REQUIRE(one.size() == 1);
  CHECK(one[0] == Approx(0.5).epsilon(1e-15));
  CHECK(curve.crossings({2.1, 7}, {0, -1}, 0).empty());
  CHECK(curve.crossings({2.1, 7}, {0, -1}, 0.2).size() == 1);
}

TEST_CASE("the box of a side holds all of it", "[side]") {
  Random random(8);
  for (int k = 0; k < 50; ++k) {
    const Vector2d middle(random.uniform(0.55, 1.45), random.uniform(-0.9, 0.9));
    const Vector2d last(2, random.uniform(-1, 1));
    const SideCurve curve = bottom_side(MeshOrder::Quadratic, middle, last);
    const Eigen::Matrix2d box = curve.box();
    for (int i = 0; i <= 20; ++i) {
      const Vector2d x = curve.point(-1 + i / 10.0).position();
      CHECK(((x - box.col(0)).minCoeff() >= -1e-15 && (box.col(1) - x).minCoeff() >= -1e-15));
    }
  }
}

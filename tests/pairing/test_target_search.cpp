#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "signorini/pairing/target_search.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::Random;

namespace {

Mesh ring(Index cells, MeshOrder order, Sector sector = Sector::Full) {
  AnnulusSpec spec;
  spec.inner_radius = 1;
  spec.outer_radius = 1.2;
  spec.cells_angle = cells;
  spec.cells_radius = 1;
  spec.sector = sector;
  spec.order = order;
  return make_annulus(spec);
}

Mesh plate(Index cells) { return block("block", {0, -1}, {4, 1}, cells, 1); }

/// A body of two cells whose top has a vertex at (1, height).
Mesh roof(double height) {
  Mesh mesh = plate(2);
  for (Index k = 0; k < mesh.n_nodes(); ++k)
    if (mesh.nodes(k, 0) == 2 && mesh.nodes(k, 1) == 0) mesh.nodes(k, 1) = height;
  return mesh;
}

Vector2d radial(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

TEST_CASE("a point over a plate faces the place below it", "[target_search]") {
  const Mesh mesh = plate(4);
  const TargetSearch search(mesh, "top");
  const Projection place = search.closest({1.25, 0.5}, {0, -1});
  REQUIRE(place.found);
  CHECK(place.side == 2);  // the top runs to the left
  CHECK(place.xi == 0.5);
  CHECK(place.point.position() == Vector2d(1.25, 0));
  CHECK(place.normal == Vector2d(0, 1));
  CHECK(place.gap == 0.5);
  CHECK(search.closest({1.25, -0.5}, {0, -1}).gap == -0.5);
}

// Closed form: from nothing at its first node to 3 / sqrt(10) of 2^-52 at its last one. Ways along the sides are rounded by as much.
TEST_CASE("gaps between sides that nearly coincide have digits of their own", "[target_search][closed-form]") {
  Mesh below = plate(1);
  Mesh above = block("block", {0, 0}, {1, 1}, 1, 1, GENERATE(MeshOrder::Linear, MeshOrder::Quadratic));
  const auto put = [](Mesh& mesh, Vector2d from, Vector2d to) {
    for (Index k = 0; k < mesh.n_nodes(); ++k)
      if (mesh.nodes.row(k).transpose() == from) mesh.nodes.row(k) = to.transpose();
  };
  put(below, {4, 0}, {3, 1});
  put(above, {0, 0}, {1.5, 0.5});
  put(above, {0.5, 0}, {1.875, 0.625 + 0x1p-53});
  put(above, {1, 0}, {2.25, 0.75 + 0x1p-52});
  const TargetSearch search(below, "top");
  const SideCurve side = side_curves(above, "bottom").front();
  for (const double xi : {-0.9, -0.57, 0.1, 0.3, 0.77, 1.0}) {
    CAPTURE(xi, side.nodes().size());
    const Projection place = search.closest(side.point(xi), side.normal(xi));
    REQUIRE(place.found);
    CHECK(place.gap == Approx((1 + xi) / 2 * 3 / std::sqrt(10) * 0x1p-52).epsilon(1e-12).margin(0));
  }
}

TEST_CASE("what lies beside a boundary faces nothing, but for the last digit of its position",
          "[target_search]") {
  const Mesh mesh = plate(4);
  const TargetSearch search(mesh, "top");
  for (const double height : {0.5, 0.0, -0.5}) {
    CHECK_FALSE(search.closest({4.001, height}, {0, -1}).found);
    CHECK_FALSE(search.closest({-0.001, height}, {0, -1}).found);
    const Projection place = search.closest({4 + 5e-7, height}, {0, -1});
    REQUIRE(place.found);
    CHECK(place.normal == Vector2d(0, 1));
    CHECK(place.gap == height);
    CHECK(place.point.position().x() == 4 + 5e-7);
  }
}

TEST_CASE("an edge behind which the boundary turns away from the source is an end",
          "[target_search]") {
  Mesh mesh = plate(4);
  std::vector<CellSide>& all = mesh.boundaries["all"];
  for (const char* name : {"bottom", "right", "top", "left"})
    for (const CellSide& side : boundary(mesh, name)) all.push_back(side);
  const TargetSearch search(mesh, "all");
  CHECK(search.closest({3.9, 0.5}, {0, -1}).found);
  CHECK_FALSE(search.closest({4.1, 0.5}, {0, -1}).found);
  // Seen from a body around the edge the edge itself is the nearest place.
  const Projection edge = search.closest({4.3, 0.4}, radial(1.25 * pi));
  REQUIRE(edge.found);
  CHECK((edge.normal - Vector2d(0.6, 0.8)).norm() < 1e-15);
  CHECK(edge.gap == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("a boundary that has turned an edge does not turn another at its end",
          "[target_search]") {
  Mesh mesh = plate(1);
  mesh.boundaries["hook"] = {boundary(mesh, "right").front(), boundary(mesh, "top").front()};
  const TargetSearch search(mesh, "hook");
  CHECK(search.closest({4.1, 0.3}, {-1, -1}).found);
  CHECK_FALSE(search.closest({-0.1, 0.3}, {-1, -1}).found);
}

TEST_CASE("a closed target is met on the side that faces the source, even from inside its wall",
          "[target_search]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    CAPTURE(static_cast<int>(order));
    Mesh mesh = ring(24, order);
    std::vector<CellSide>& both = mesh.boundaries["both"];
    for (const char* name : {"outer", "inner"})
      for (const CellSide& side : boundary(mesh, name)) both.push_back(side);
    const TargetSearch search(mesh, "both");
    const Projection below = search.closest({0.05, -1.3}, {0, 1});
    REQUIRE(below.found);
    CHECK(below.point.position().y() < -1.1);
    const Projection outside = search.closest({1.3, 0.01}, {-1, 0});
    REQUIRE(outside.found);
    CHECK(outside.point.position().x() == Approx(1.2).margin(0.02));
    for (const double x : {0.5, 0.95, 1.05, 1.15}) {  // at 1.15 the outside is nearer
      const Projection inside = search.closest({x, 0.01}, {1, 0});
      REQUIRE(inside.found);
      CHECK(inside.gap == Approx(1 - x).margin(0.02));
    }
    CHECK_FALSE(search.closest({-0.5, 0.01}, {1, 0}).point.position().x() < 0);
  }
}

TEST_CASE("the force at a convex vertex acts through the point and the vertex", "[target_search]") {
  const Mesh mesh = roof(1);
  const TargetSearch search(mesh, "top");
  const Projection place = search.closest({2.05, 1.5}, {0, -1});
  REQUIRE(place.found);
  CHECK(place.point.position() == Vector2d(2, 1));
  CHECK((place.normal - Vector2d(0.05, 0.5).normalized()).norm() < 1e-15);
  CHECK(place.gap == Approx(std::hypot(0.05, 0.5)).epsilon(1e-15));
  CHECK((place.side == 0 && place.xi == 1));
  // In the vertex itself, midway between the two normals; far aside, on the flank.
  const Projection touching = search.closest({2, 1}, {0, -1});
  CHECK((touching.normal - Vector2d(0, 1)).norm() < 1e-15);
  CHECK(touching.gap == 0);
  CHECK((search.closest({2.5, 1.5}, {0, -1}).normal - Vector2d(1, 2).normalized()).norm() < 1e-15);
}

TEST_CASE("midway over a concave vertex the vertex is taken, not one of the flanks",
          "[target_search]") {
  const Mesh mesh = roof(-0.5);
  const TargetSearch search(mesh, "top");
  const Projection place = search.closest({2, -0.1}, {0, -1});
  REQUIRE(place.found);
  CHECK(place.point.position() == Vector2d(2, -0.5));
  CHECK((place.normal - Vector2d(0, 1)).norm() < 1e-15);
  CHECK(place.gap == Approx(0.4).epsilon(1e-15));
  CHECK(search.closest({2.01, -0.1}, {0, -1}).normal.x() < -0.2);
}

TEST_CASE("points over vertices, or in them, but for rounding look along the bisector",
          "[target_search]") {
  for (Index cells = 8; cells <= 32; cells += 4) {
    const Mesh mesh = ring(cells, MeshOrder::Linear);
    for (const char* name : {"outer", "inner"}) {
      const TargetSearch search(mesh, name);
      const double out = std::string(name) == "outer" ? 1 : -1;
      for (const Index node : boundary_nodes(mesh, name)) {
        const Vector2d x = mesh.nodes.row(node).transpose();
        for (const double ulps : {-4, -1, 0, 1, 4}) {
          const double bit = ulps * std::numeric_limits<double>::epsilon();
          const Vector2d near = x + bit * Vector2d(x.x() - x.y(), x.y());
          const Projection place = search.closest(near, -out * x);
          CAPTURE(cells, name, node, ulps);
          REQUIRE(place.found);
          CHECK((place.normal - out * x.normalized()).norm() < 1e-14);
        }
        // The nearer the point, the more of its direction from the vertex is rounding.
        for (const double off : {1e-9, 1e-6, 1e-3}) {
          const Projection place = search.closest((1 + off * out) * x, -out * x);
          CAPTURE(cells, name, node, off);
          REQUIRE(place.found);
          CHECK((place.normal - out * x.normalized()).norm() < 1e-15);
        }
      }
      // Over the vertex between the last side and the first, the first is named.
      const Vector2d start = search.side(0).point(-1).position();
      const Projection place = search.closest((1 + 0.05 * out) * start, -out * start);
      CHECK((place.side == 0 && place.xi == -1));
    }
  }
}

TEST_CASE("on a line of symmetry the end of a round boundary is not lost", "[target_search]") {
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const Mesh mesh = ring(5, order, Sector::Quarter);
    const TargetSearch outer(mesh, "outer");
    const TargetSearch inner(mesh, "inner");
    for (const double angle : {0.0, pi / 2})
      for (const double gap : {0.05, 0.0, -0.02}) {
        CAPTURE(static_cast<int>(order), angle, gap);
        const Projection out = outer.closest((1.2 + gap) * radial(angle), -radial(angle));
        REQUIRE(out.found);
        const Projection in = inner.closest((1 - gap) * radial(angle), radial(angle));
        REQUIRE(in.found);
        if (order == MeshOrder::Quadratic && gap != 0) continue;  // feet lie inside the last side
        CHECK((out.normal - radial(angle)).norm() < 1e-14);
        CHECK(out.gap == Approx(gap).margin(1e-15));
        CHECK((in.normal + radial(angle)).norm() < 1e-14);
        CHECK(in.gap == Approx(gap).margin(1e-15));
      }
  }
}

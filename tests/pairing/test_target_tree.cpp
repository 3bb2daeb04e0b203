// The tree of the target search: it finds what a look at all sides finds, and looks at few.
#include <cmath>

#include "catch_compat.hpp"
#include "meshes/ring.hpp"
#include "meshes/split.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "signorini/pairing/target_search.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::Random;

namespace {

Mesh waves(Index cells, MeshOrder order) {
  BlockSpec spec;
  spec.corner = {0, -2};
  spec.size = {6, 2};
  spec.cells_x = cells;
  spec.order = order;
  return mapped(make_block(spec), [](const Vector2d& x) {
    return Vector2d(x.x(), x.y() + 0.3 * std::sin(2 * x.x()));
  });
}

Mesh ring(Index cells) {
  AnnulusSpec spec;
  spec.cells_angle = cells;
  return make_annulus(spec);
}

/// Most boxes and sides looked at from any of `n` points on a line.
Index most_visits(const TargetSearch& search, const Vector2d& from, const Vector2d& to,
                  const Vector2d& normal, int n) {
  Index most = 0;
  for (int k = 0; k <= n; ++k)
    most = std::max(most, search.closest(from + (to - from) * k / n, normal).visits);
  return most;
}

}  // namespace

TEST_CASE("the tree finds the nearest facing place of all", "[target_search]") {
  Random random(4);
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    const Mesh mesh = waves(37, order);
    const TargetSearch search(mesh, "top");
    for (int k = 0; k < 200; ++k) {
      const Vector2d x(random.uniform(0.5, 5.5), random.uniform(-0.2, 1.5));
      const Projection place = search.closest(x, {0, -1});
      CAPTURE(x.transpose());
      REQUIRE(place.found);
      double nearest = 10;
      for (Index s = 0; s < search.n_sides(); ++s)
        nearest = std::min(nearest, (search.side(s).point(search.side(s).closest(x)) - x).norm());
      CHECK((x - place.point).norm() == Approx(nearest).epsilon(1e-14).margin(1e-15));
      CHECK(std::abs(place.gap) == Approx(nearest).epsilon(1e-12).margin(1e-15));
    }
  }
}

TEST_CASE("a query looks at a number of boxes like the logarithm of the number of sides",
          "[target_search]") {
  for (const Index cells : {64, 512, 4096}) {
    CAPTURE(cells);
    const Index levels = static_cast<Index>(std::lround(std::log2(cells)));
    const Mesh flat =
        mapped(make_block([&] {
                 BlockSpec spec;
                 spec.cells_x = cells;
                 return spec;
               }()),
               [](const Vector2d& x) { return Vector2d(x.x() - x.y(), x.x() + x.y()); });
    const TargetSearch top(flat, "top");
    // Half of these points lie beyond the ends: they are told from the plate at once.
    const Vector2d down = Vector2d(1, -1).normalized();
    CHECK(most_visits(top, {-3, -1}, {2, 4}, down, 1000) < 6 * levels);
    const Mesh round = ring(cells);
    const TargetSearch outer(round, "outer");
    CHECK(most_visits(outer, {-4, 2.1}, {4, 2.1}, {0, -1}, 1000) < 8 * levels);
    const Mesh curved = waves(cells, MeshOrder::Quadratic);
    const TargetSearch wavy(curved, "top");
    CHECK(most_visits(wavy, {0, 0.35}, {6, 0.35}, {0, -1}, 1000) < 12 * levels);
  }
}

TEST_CASE("along the normal of the source the first facing side is met", "[target_search]") {
  const Mesh mesh = ring(12);
  const TargetSearch search(mesh, "outer");
  for (int k = 0; k < 100; ++k) {
    const double angle = 2 * pi * k / 100;
    const Vector2d out(std::cos(angle), std::sin(angle));
    const Projection place = search.along(2.5 * out, -out);
    REQUIRE(place.found);
    const Vector2d at = place.point.position();
    CHECK(std::abs(at.x() * out.y() - at.y() * out.x()) < 1e-14);
    CHECK(at.dot(out) > 1.9);
    CHECK(place.gap == Approx((2.5 * out - at).dot(place.normal)).epsilon(1e-14));
    CHECK_FALSE(search.along(2.5 * out, Vector2d(-out.y(), out.x())).found);
    CHECK_FALSE(search.along(2.5 * out, out).found);
  }
}

TEST_CASE("a point deep in the body is told from one beside it", "[target_search]") {
  const Mesh mesh = waves(9, MeshOrder::Linear);
  const TargetSearch search(mesh, "top");
  CHECK(search.depth(0) > 1.5);
  BlockSpec spec;
  spec.cells_y = 10;
  const Mesh block = make_block(spec);
  const TargetSearch top(block, "top");
  CHECK(top.depth(0) == Approx(0.1).epsilon(1e-14));
  CHECK(top.closest({0.5, 0.95}, {0, -1}).found);
  CHECK(top.closest({0.5, 0.85}, {0, -1}).inside);
  const Projection beyond = top.closest({0.5, -0.2}, {0, -1});
  CHECK_FALSE(beyond.found);
  CHECK_FALSE(beyond.inside);
  CHECK(top.along({0.5, 0.85}, {0, -1}).inside);
}

TEST_CASE("triangles are as deep as their third corner", "[target_search]") {
  BlockSpec spec;
  spec.cells_y = 10;
  for (const MeshOrder order : {MeshOrder::Linear, MeshOrder::Quadratic}) {
    spec.order = order;
    const Mesh whole = make_block(spec);
    for (const Mesh& mesh : {split(whole), split(whole, {3, 9})}) {
      const TargetSearch top(mesh, "top");
      CHECK(top.depth(0) == Approx(0.1).epsilon(1e-14));
      CHECK(top.closest({0.5, 0.95}, {0, -1}).found);
      for (const double y : {0.85, 0.37, 0.33}) CHECK(top.closest({0.5, y}, {0, -1}).inside);
      CHECK_FALSE(top.closest({0.5, -0.2}, {0, -1}).inside);
    }
  }
}

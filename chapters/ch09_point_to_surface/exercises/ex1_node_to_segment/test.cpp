#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;
using ex9_1::Nodes;
using ex9_1::Place;

namespace {

const Nodes inclined = (Nodes() << 4, 0, 0, 3, 3, 1.5).finished();

}  // namespace

// The edge has length 5 and direction (-0.8, 0.6); from node 1 to node 3 it is (-1, 1.5).
TEST_CASE("ex9.1 a node over an inclined edge", "[ex9.1][LinEtAl-20][LinEtAl-22]") {
  const auto place = ex9_1::facing(inclined);
  REQUIRE(place.has_value());
  CHECK(std::abs(place->N1 - 0.66) < 1e-14);
  CHECK(std::abs(place->N2 - 0.34) < 1e-14);
  CHECK(equal_within(place->n, Vector2d(0.6, 0.8), 1e-14));
  CHECK(equal_within(place->t, Vector2d(0.8, -0.6), 1e-14));
  CHECK(std::abs(place->gap - 0.6) < 1e-14);
}

TEST_CASE("ex9.1 below the edge is overlap, beside it is nothing", "[ex9.1][LinEtAl-22]") {
  const auto below = ex9_1::facing((Nodes() << 1, 0, 0, 0, 0.25, -0.1).finished());
  REQUIRE(below.has_value());
  CHECK(std::abs(below->gap + 0.1) < 1e-15);
  CHECK_FALSE(ex9_1::facing((Nodes() << 1, 0, 0, 0, 1.01, 0.1).finished()).has_value());
  CHECK_FALSE(ex9_1::facing((Nodes() << 1, 0, 0, 0, 3, 1.5).finished()).has_value());
}

TEST_CASE("ex9.1 pressure pushes the source out and the target in",
          "[ex9.1][LinEtAl-23][LinEtAl-25][LinEtAl-27]") {
  const Place place{0.75, 0.25, {0, 1}, {1, 0}, 0};
  const Nodes forces = ex9_1::shared_out(place, 8, 0);
  CHECK(equal_within(forces, (Nodes() << 0, -6, 0, -2, 0, 8).finished(), 1e-15));
}

TEST_CASE("ex9.1 friction drags both along the edge",
          "[ex9.1][LinEtAl-24][LinEtAl-26][LinEtAl-27]") {
  const Place place{0.75, 0.25, {0, 1}, {1, 0}, 0};
  const Nodes forces = ex9_1::shared_out(place, 0, 4);
  CHECK(equal_within(forces, (Nodes() << -3, 0, -1, 0, 4, 0).finished(), 1e-15));
}

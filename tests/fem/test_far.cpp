// How far a mesh lies from the origin, and what that does to its directions.
#include "catch_compat.hpp"
#include "meshes/split.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/far.hpp"

using namespace signorini;

TEST_CASE("the distance from the origin is that of the box, and none from inside", "[mesh][far]") {
  const auto away = [](double x, double y) {
    return distance_from_origin(block("block", {x, y}, {2, 1}, 2, 1).nodes);
  };
  CHECK(away(-1, -0.5) == 0);
  CHECK(away(0, -1) == 0);
  CHECK(away(3, -0.5) == 3);
  CHECK(away(-5, -0.5) == 3);
  CHECK(away(-1, 4) == 4);
  CHECK(away(-1, -5) == 4);
  CHECK(away(3, 4) == 5);
  CHECK(away(-5, -5) == 5);
}

TEST_CASE("the shortest side turns the most by rounding", "[mesh][far]") {
  for (const double size : {1e-6, 1.0, 1e6}) {
    CAPTURE(size);
    const auto rounding = [&](double away) {  // of cells of size / 4 and size / 2
      return direction_rounding(block("block", {away * size, 0}, {size, size}, 4, 2)) / epsilon;
    };
    CHECK(rounding(-0.5) == Approx(5).epsilon(1e-14));  // the height
    CHECK(rounding(-2) == Approx(9).epsilon(1e-14));
    CHECK(rounding(2) == Approx(13).epsilon(1e-14));
    CHECK(rounding(1e6) == Approx(4e6 + 5).epsilon(1e-9));
  }
  Mesh uneven = block("block", {0, 0}, {4, 1}, 4, 1);
  for (double& x : uneven.nodes.col(0))
    if (x == 4) x = 3.125;  // the last cell is an eighth wide
  CHECK(direction_rounding(uneven) / epsilon == Approx(1 + 3.125 * 8).epsilon(1e-14));
  // Cut along their diagonals, cells keep their shortest side.
  const Mesh cells = block("block", {7, 0}, {1, 1}, 4, 2);
  CHECK(direction_rounding(split(cells)) == Approx(direction_rounding(cells)).epsilon(1e-14));
}

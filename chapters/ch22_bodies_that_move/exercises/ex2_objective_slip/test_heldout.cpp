#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_2;

TEST_CASE("ex22.2 held out: sides that lie askew before", "[ex22.2]") {
  const Scene before{{3, 4}, {0, 0}, {6, 8}};  // at its middle
  CHECK(slip(before, {{6, 8}, {0, 0}, {6, 8}}) == Approx(5));
  CHECK(slip(before, {{0.8, 0}, {0, 0}, {1, 0}}) == Approx(3));  // shrunk to a tenth, at 0.8
}

TEST_CASE("ex22.2 held out: what is above the side does not count", "[ex22.2]") {
  CHECK(slip({{1, 0.3}, {0, 0}, {4, 0}}, {{1, 0}, {0, 0}, {4, 0}}) == Approx(0).margin(1e-15));
  CHECK(slip({{1, 0.3}, {0, 0}, {4, 0}}, {{0, 2}, {0, 0}, {0, 4}}) == Approx(1));
}

TEST_CASE("ex22.2 held out: the target moves and the node stays", "[ex22.2]") {
  CHECK(slip({{1, 0}, {0, 0}, {4, 0}}, {{1, 0}, {0.5, 0}, {4.5, 0}}) == Approx(-0.5));
}

TEST_CASE("ex22.2 held out: lengths are those of before", "[ex22.2]") {
  CHECK(slip({{0, 0}, {0, 0}, {2, 0}}, {{4, 0}, {0, 0}, {4, 0}}) == Approx(2));
}

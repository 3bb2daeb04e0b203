#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex9_3;

// Normal (0.6, -0.8), shares 0.25 and 0.75.
static const Row leaning = {{9, false, -0.45, 0.6}, {4, true, 0.6, -0.8}, {2, false, -0.15, 0.2}};

TEST_CASE("ex9.3 held out: a leaning normal, and shares in the order of the nodes", "[ex9.3]") {
  const Reading reading = reading_of(leaning);
  CHECK(reading.source == 4);
  CHECK(reading.nx == 0.6);
  CHECK(reading.ny == -0.8);
  REQUIRE(reading.shares.size() == 2);
  CHECK(reading.shares[0].node == 2);
  CHECK(reading.shares[0].N == Approx(0.25).epsilon(1e-14));
  CHECK(reading.shares[1].node == 9);
  CHECK(reading.shares[1].N == Approx(0.75).epsilon(1e-14));
}

// Both entries are unit vectors: only the flag tells who is the source.
TEST_CASE("ex9.3 held out: a node on a node", "[ex9.3]") {
  const Reading reading = reading_of({{7, false, 0, 1}, {8, false, 0, 0}, {5, true, 0, -1}});
  CHECK(reading.source == 5);
  CHECK(reading.ny == -1);
  REQUIRE(reading.shares.size() == 1);
  CHECK(reading.shares[0].node == 7);
  CHECK(reading.shares[0].N == 1);
}

TEST_CASE("ex9.3 held out: normals that differ do not cancel what a node gets", "[ex9.3]") {
  const Row from_the_left = {{1, true, -1, 0}, {2, false, 1, 0}};
  const Row from_the_right = {{3, true, 1, 0}, {2, false, -0.5, 0}, {9, false, -0.5, 0}};
  const std::vector<double> got =
      reached({from_the_left, from_the_right, leaning}, {1, 2, 4}, {9, 2, 6});
  REQUIRE(got.size() == 3);
  CHECK(got[0] == Approx(1 + 3).epsilon(1e-14));
  CHECK(got[1] == Approx(1 + 1 + 1).epsilon(1e-14));
  CHECK(got[2] == 0);
}

TEST_CASE("ex9.3 held out: what is untouched does not depend on forces, and keeps its order",
          "[ex9.3]") {
  CHECK(untouched({leaning}, {6, 9, 3, 2}) == std::vector<int>{6, 3});
  CHECK(untouched({}, {6, 9}) == std::vector<int>{6, 9});
  CHECK(untouched({{{7, false, 0, 1}, {8, false, 0, 0}, {5, true, 0, -1}}}, {7, 8}) ==
        std::vector<int>{8});
}

// Nodes of source and target may have the same number: each body counts its own.
TEST_CASE("ex9.3 held out: two bodies, one number", "[ex9.3]") {
  const Row row = {{1, false, 0, -0.5}, {1, true, 0, 1}, {2, false, 0, -0.5}};
  CHECK(reading_of(row).source == 1);
  CHECK(reading_of(row).shares.size() == 2);
  CHECK(untouched({row}, {1, 2, 3}) == std::vector<int>{3});
}

TEST_CASE("ex9.3 held out: what is no such row is refused", "[ex9.3]") {
  CHECK_THROWS_AS(reading_of({}), std::invalid_argument);
  CHECK_THROWS_AS(reading_of({{1, false, 0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(reading_of({{1, true, 0, 1}, {2, true, 0, -1}}), std::invalid_argument);
  CHECK_THROWS_AS(reached({leaning}, {}, {2}), std::invalid_argument);
  CHECK_THROWS_AS(reached({{}}, {1}, {2}), std::invalid_argument);
  CHECK_THROWS_AS(untouched({{}}, {2}), std::invalid_argument);
}

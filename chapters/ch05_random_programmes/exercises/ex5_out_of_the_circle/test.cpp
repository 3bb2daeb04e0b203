#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"

using namespace ex5_5;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("ex5.5 three carts as before", "[ex5.5]") {
  const std::vector<Rows> sets = closed_pairs(
      {(Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(), Vector3d(-2, -1, -3)}, 100);
  CHECK(sets == std::vector<Rows>{{0, 1, 2}, {0, 2}});
}

TEST_CASE("ex5.5 three pairs that went in circles come to an end", "[ex5.5]") {
  const std::vector<Rows> sets = closed_pairs(
      {(Matrix3d() << 4, -6, -4, -6, 10, 8, -4, 8, 9).finished(), Vector3d(3, -4, -1)}, 100);
  REQUIRE(sets.size() < 12);
  CHECK(sets.back() == Rows{1});
  CHECK(sets[1] == Rows{0, 1});  // until a set comes back, all wrong pairs change
  CHECK(sets[2] == Rows{});
  CHECK(sets[3] == Rows{1, 2});
}

TEST_CASE("ex5.5 nothing overlaps, nothing closes", "[ex5.5]") {
  const std::vector<Rows> sets = closed_pairs({Matrix3d::Identity(), Vector3d(1, 0, 2)}, 100);
  REQUIRE(sets.size() == 1);
  CHECK(sets.back() == Rows{});
}

TEST_CASE("ex5.5 a punch takes few sets", "[ex5.5]") {
  const signorini::Indentation punch = signorini::half_plane_indentation(40);
  const std::vector<Rows> sets = closed_pairs(punch.problem, 100);
  CHECK(sets.size() < 10);
  CHECK(sets.back().size() == 24);
}

#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex20_2;

// The carts: the third force for the second overlap, the second gap for the third, the first force for the first.
TEST_CASE("ex20.2 the three exchanges of the carts", "[ex20.2]") {
  const std::vector<Exchange> carts = {{5, 7}, {1, 8}, {3, 6}};
  const Reading end = read({true, true, true}, carts);
  CHECK(end.closed == std::vector<int>{0, 2});
  CHECK(end.ended == 3);
  CHECK(end.in_vain == 0);
  CHECK(end.solved);
  CHECK_FALSE(read({true, true, true}, {carts[0], carts[1]}).solved);
}

TEST_CASE("ex20.2 a force that joins, leaves and joins again has left once", "[ex20.2]") {
  const Reading end = read({true, true}, {{2, 5}, {3, 2}, {2, 4}});
  CHECK(end.closed == std::vector<int>{0, 1});
  CHECK(end.in_vain == 1);
  CHECK(end.ended == 2);
}

TEST_CASE("ex20.2 without an overlap nothing is to be done", "[ex20.2]") {
  const Reading end = read({false, false}, {});
  CHECK(end.solved);
  CHECK(end.closed == decltype(end.closed){});
}

TEST_CASE("ex20.2 a force beside the gap of its pair breaks the rule", "[ex20.2]") {
  CHECK_THROWS_AS(read({false, true}, {{2, 5}}), std::invalid_argument);
  CHECK_THROWS_AS(read({true, false}, {{3, 4}}), std::invalid_argument);
}

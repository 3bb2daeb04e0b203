#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex20_2;

// Two pairs: 0 and 1 are gaps, 2 and 3 forces, 4 and 5 overlaps.
TEST_CASE("ex20.2 held out: what cannot be is refused", "[ex20.2]") {
  const std::vector<bool> both = {true, true};
  CHECK_THROWS_AS(read(both, {{4, 5}}), std::invalid_argument);          // an overlap joins
  CHECK_THROWS_AS(read(both, {{-1, 5}}), std::invalid_argument);         // no such variable
  CHECK_THROWS_AS(read(both, {{2, 6}}), std::invalid_argument);          // nor this
  CHECK_THROWS_AS(read(both, {{2, 3}}), std::invalid_argument);          // it is not there
  CHECK_THROWS_AS(read(both, {{2, 4}, {2, 5}}), std::invalid_argument);  // it is there
  CHECK_THROWS_AS(read(both, {{2, 4}, {0, 5}}), std::invalid_argument);  // the gap of a force
}

TEST_CASE("ex20.2 held out: a gap may take the place of its force", "[ex20.2]") {
  const Reading end = read({true, true}, {{2, 4}, {0, 2}});
  CHECK(end.closed == decltype(end.closed){});
  CHECK(end.in_vain == 1);
  CHECK(end.ended == 1);
  CHECK_FALSE(end.solved);  // the overlap of the second pair is still there
}

TEST_CASE("ex20.2 held out: pairs that do not overlap start with their gaps", "[ex20.2]") {
  const Reading end = read({false, true, false}, {{4, 7}, {5, 2}});
  CHECK(end.closed == std::vector<int>{1, 2});
  CHECK(end.ended == 1);
  CHECK(end.in_vain == 0);
  CHECK(end.solved);
}

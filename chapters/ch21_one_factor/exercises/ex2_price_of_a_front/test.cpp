#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex21_2;

// 4 + 10 for the first unknown and 3 + 6 for the second; the row takes 5 and 4, and its square 2.
TEST_CASE("ex21.2 a front by hand", "[ex21.2]") {
  CHECK(price({2, 3, 1}).factor == 23);
  CHECK(price({2, 3, 1}).compliance == 11);
}

TEST_CASE("ex21.2 without rows contact is free, without unknowns all is", "[ex21.2]") {
  CHECK(price({5, 4, 0}).compliance == 0);
  CHECK(price({5, 4, 0}).factor > 0);
  CHECK(price({0, 4, 3}).factor == 0);
  CHECK(price({0, 4, 3}).compliance == 0);
}

TEST_CASE("ex21.2 a slender body pays more for contact than for the factor", "[ex21.2]") {
  const std::vector<Front> square = {{40, 0, 5}, {20, 60, 3}}, slender = {{6, 0, 200}, {6, 12, 100}};
  CHECK(share_of_contact(square) < 1);
  CHECK(share_of_contact(slender) > 1);
}

TEST_CASE("ex21.2 negative counts are refused", "[ex21.2]") {
  CHECK_THROWS_AS(price({-1, 2, 3}), std::invalid_argument);
}

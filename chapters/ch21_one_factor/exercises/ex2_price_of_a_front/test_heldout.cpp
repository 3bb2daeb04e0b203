#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex21_2;

// The loops themselves, one operation at a time.
static Price counted(int own, int rim, int rows) {
  Price sum;
  for (int k = 0; k < own; ++k)
    for (int i = k + 1; i < own + rim; ++i) {
      ++sum.factor;
      for (int j = k + 1; j <= i; ++j) ++sum.factor;
    }
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < own; ++k) {
      ++sum.compliance;
      for (int i = k + 1; i < own + rim; ++i) ++sum.compliance;
    }
  for (int row = 0; row < rows; ++row)
    for (int other = 0; other <= row; ++other)
      for (int k = 0; k < own; ++k) ++sum.compliance;
  return sum;
}

TEST_CASE("ex21.2 held out: as the loops count", "[ex21.2]") {
  for (const int own : {1, 2, 7})
    for (const int rim : {0, 1, 9})
      for (const int rows : {0, 1, 6}) {
        CHECK(price({own, rim, rows}).factor == counted(own, rim, rows).factor);
        CHECK(price({own, rim, rows}).compliance == counted(own, rim, rows).compliance);
      }
}

TEST_CASE("ex21.2 held out: the leading terms are those of the chapter", "[ex21.2]") {
  const double n = 2e4, rim = 3e4, rows = 1e4;
  const Price one = price({20000, 30000, 10000});
  CHECK(one.factor == Approx(n * n * n / 6 + n * n * rim / 2 + n * rim * rim / 2).epsilon(1e-3));
  CHECK(one.compliance == Approx(rows * (n * n / 2 + n * rim) + n * rows * rows / 2).epsilon(1e-3));
}

TEST_CASE("ex21.2 held out: no fronts, no factor, a bad rim", "[ex21.2]") {
  CHECK(share_of_contact({}) == 0);
  CHECK(share_of_contact({{0, 3, 2}}) == 0);
  CHECK(share_of_contact({{1, 0, 1}}) == 0);  // a single unknown takes a root and nothing else
  CHECK_THROWS_AS(price({1, -2, 3}), std::invalid_argument);
  CHECK_THROWS_AS(price({1, 2, -3}), std::invalid_argument);
}

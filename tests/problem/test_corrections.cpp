#include <limits>

#include "catch_compat.hpp"
#include "signorini/problem/corrections.hpp"

using namespace signorini;

TEST_CASE("the next correction is foreseen from the rate of the last two", "[corrections]") {
  Corrections corrections;
  CHECK(corrections.next(1e-3));
  CHECK(corrections.foreseen == Approx(1e-6).epsilon(1e-12));  // the one before counts as 1
  CHECK(corrections.next(1e-8));
  CHECK(corrections.foreseen == Approx(1e-13).epsilon(1e-12));
  CHECK(corrections.next(1e-7));  // no rate is above 1
  CHECK(corrections.foreseen == Approx(1e-7).epsilon(1e-12));
}

TEST_CASE("a correction larger than what it corrects makes no rate look small", "[corrections]") {
  Corrections corrections;
  CHECK(corrections.next(20504));
  CHECK(corrections.next(1e-6));
  CHECK(corrections.foreseen == Approx(1e-12).epsilon(1e-12));
}

TEST_CASE("three corrections in a row that are not half of the best one end a refinement",
          "[corrections]") {
  Corrections corrections;
  CHECK(corrections.next(1e-2));
  for (int k = 0; k < 2; ++k) CHECK(corrections.next(0.6e-2));
  CHECK(corrections.next(0.2e-2));  // shrinks: the count begins anew
  for (int k = 0; k < 2; ++k) CHECK(corrections.next(0.11e-2));
  CHECK_FALSE(corrections.next(0.11e-2));
  CHECK_FALSE(Corrections().next(std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("a refinement has settled where the next correction is rounding", "[corrections]") {
  Corrections corrections;
  CHECK(corrections.next(1e-3));
  CHECK_FALSE(corrections.settled(0));  // 1e-6 is to come
  CHECK(corrections.next(1e-9));
  CHECK_FALSE(corrections.settled(0));  // 1e-15
  CHECK(corrections.next(1e-15));
  CHECK(corrections.settled(0));  // 1e-21
}

// Of ten closed rows eleven roundings count, 2.4e-15. The foreseen 0.9e-15 alone is more than a quarter of one.
TEST_CASE("corrections that shrink no more have settled if they are rounding of as many rows",
          "[corrections]") {
  for (const double size : {1e-15, 1e-14}) {
    Corrections corrections;
    CHECK(corrections.next(size));
    for (int k = 0; k < 2; ++k) CHECK(corrections.next(size));
    CHECK_FALSE(corrections.settled(10));  // two in a row: the third may shrink
    CHECK_FALSE(corrections.next(size));
    CHECK(corrections.settled(10) == (size < 11 * epsilon));
    CHECK_FALSE(corrections.settled(3));
  }
}

TEST_CASE("a correction is measured by what it corrected", "[corrections]") {
  const Eigen::Vector2d u(4, -8);
  const Eigen::Vector2d f(0, 0);
  CHECK(Corrections::size(Eigen::Vector2d(1, -2), u, f, f) == 0.25);
  CHECK(Corrections::size(Eigen::Vector2d(1, -2), u, Eigen::Vector2d(1, 0), Eigen::Vector2d(-2, 1)) ==
        0.5);
  CHECK(relative(Eigen::Vector2d(0, 3), f) == 1);  // all of it was taken back
}

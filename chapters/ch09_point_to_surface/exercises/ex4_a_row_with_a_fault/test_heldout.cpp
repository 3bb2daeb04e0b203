#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex9_4;

// The gap itself, by the area of a triangle.
static double gap(const Nodes& at) {
  const double ex = at.x2 - at.x1, ey = at.y2 - at.y1;
  return ((at.x3 - at.x1) * ey - (at.y3 - at.y1) * ex) / std::hypot(ex, ey);
}

// Where 3' is and how long the normal is do not change the gap to first order, however large it is.
TEST_CASE("ex9.4 held out: the row is the slope of the gap", "[ex9.4][LinEtAl-22]") {
  for (const double turn : {0.0, 1.0, 2.5, 4.0, 5.5})
    for (const double place : {0.05, 0.3, 0.5, 0.9})
      for (const double height : {-0.2, 0.0, 0.7}) {
        const double length = 1.7, c = std::cos(turn), s = std::sin(turn);
        const double along = place * length;
        const Nodes at{1,
                       2,
                       1 + length * c,
                       2 + length * s,
                       1 + along * c + height * s,
                       2 + along * s - height * c};
        CAPTURE(turn, place, height);
        const auto row = gap_row(at);
        REQUIRE(row);
        const double h = 1e-6;
        double Nodes::*const entries[] = {&Nodes::x1, &Nodes::y1, &Nodes::x2,
                                          &Nodes::y2, &Nodes::x3, &Nodes::y3};
        for (std::size_t i = 0; i < 6; ++i) {
          Nodes more = at, less = at;
          more.*entries[i] += h;
          less.*entries[i] -= h;
          CHECK((*row)[i] == Approx((gap(more) - gap(less)) / (2 * h)).margin(1e-8));
        }
      }
}

TEST_CASE("ex9.4 held out: the ends of the edge are places of it", "[ex9.4]") {
  const auto one = gap_row({4, 0, 0, 0, 4, 1}), two = gap_row({4, 0, 0, 0, 0, 1});
  REQUIRE(one);
  REQUIRE(two);
  CHECK((*one)[1] == -1);
  CHECK((*one)[3] == 0);
  CHECK((*two)[1] == 0);
  CHECK((*two)[3] == -1);
}

TEST_CASE("ex9.4 held out: a node inside the target faces it as well", "[ex9.4]") {
  const auto row = gap_row({4, 0, 0, 0, 3, -0.5});
  REQUIRE(row);
  CHECK((*row)[5] == Approx(1).epsilon(1e-14));  // out of the target, not towards the node
  CHECK((*row)[1] == Approx(-0.75).epsilon(1e-14));
}

TEST_CASE("ex9.4 held out: very long and very short edges", "[ex9.4]") {
  for (const double size : {1e-9, 1e9}) {
    const auto row = gap_row({4 * size, 0, 0, 3 * size, 3 * size, 1.5 * size});
    REQUIRE(row);
    const double expected[] = {-0.396, -0.528, -0.204, -0.272, 0.6, 0.8};
    for (std::size_t i = 0; i < 6; ++i) CHECK((*row)[i] == Approx(expected[i]).epsilon(1e-12));
  }
}

TEST_CASE("ex9.4 held out: what is no edge is still refused", "[ex9.4]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(gap_row({1, 1, 1, 1, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(gap_row({1, 0, 0, 0, none, 0}), std::invalid_argument);
  CHECK_THROWS_AS(gap_row({1, 0, 0, std::numeric_limits<double>::infinity(), 0, 0}),
                  std::invalid_argument);
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using ex12_2::middle_tension;
using ex12_2::widest_arc;

static const double pi = std::acos(-1.0);
static const double degree = pi / 180;

TEST_CASE("ex12.2 a line load loses nothing, strips lose a little", "[ex12.2]") {
  CHECK(middle_tension(0) == 1);
  CHECK(middle_tension(5 * degree) == Approx(0.9911).margin(5e-5));
  CHECK(middle_tension(10 * degree) == Approx(0.9645).margin(5e-5));
  CHECK(middle_tension(15 * degree) == Approx(0.9203).margin(5e-5));
}

// The whole rim: pressure p = P / (2 R) everywhere, so -p = -(pi/2) P / (pi R).
TEST_CASE("ex12.2 pressure all around is pressure in the middle", "[ex12.2]") {
  CHECK(middle_tension(pi / 2) == Approx(-pi / 2).epsilon(1e-14));
}

TEST_CASE("ex12.2 the width that costs one percent, and the one that costs all", "[ex12.2]") {
  CHECK(2 * widest_arc(0.01) / degree == Approx(10.61).margin(0.005));
  CHECK(2 * widest_arc(1) / degree == Approx(108.6).margin(0.05));
  CHECK(std::sin(2 * widest_arc(1)) == Approx(widest_arc(1)).epsilon(1e-9));
}

TEST_CASE("ex12.2 there and back", "[ex12.2]") {
  for (const double loss : {0.001, 0.1, 0.5, 1.5, 2.5})
    CHECK(middle_tension(widest_arc(loss)) == Approx(1 - loss).margin(1e-9));
}

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_1;

TEST_CASE("ex22.1 a millimetre along a disc of ten", "[ex22.1]") {
  CHECK(error_of_linear_gap(1, 10) == Approx(0.0498756211208902).epsilon(1e-13));
  CHECK(error_of_linear_gap(-1, 10) == Approx(0.0498756211208902).epsilon(1e-13));
  CHECK(error_of_linear_gap(0, 10) == 0);
}

// A triangle of sides 3, 4 and 5: it is not s^2/2R.
TEST_CASE("ex22.1 a way that is not small", "[ex22.1]") {
  CHECK(error_of_linear_gap(4, 3) == Approx(2).epsilon(1e-14));
  CHECK(longest_way(2, 3) == Approx(4).epsilon(1e-14));
}

TEST_CASE("ex22.1 thirty-six stretches", "[ex22.1]") {
  CHECK(longest_way(0.001, 10) == Approx(0.141424892).epsilon(1e-8));
  CHECK(stretches(5, 0.001, 10) == 36);
  CHECK(stretches(0.1, 0.001, 10) == 1);
}

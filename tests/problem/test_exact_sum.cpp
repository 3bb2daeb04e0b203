#include <cmath>

#include "catch_compat.hpp"
#include "signorini/core/exact_sum.hpp"
#include "support/random.hpp"

using signorini::ExactSum;
using signorini_test::Random;

TEST_CASE("an exact sum keeps what plain addition loses to a large term", "[exact_sum]") {
  ExactSum sum;
  for (const double term : {1e16, 1.0, -1e16}) sum.add(term);
  CHECK(sum.value() == 1);
  CHECK((1e16 + 1.0) - 1e16 == 0);  // what the same numbers give without it
}

TEST_CASE("an exact sum keeps a small term that comes before the large ones", "[exact_sum]") {
  ExactSum sum(1.0);  // the larger number is the second one here
  sum.add(1e100);
  sum.add(-1e100);
  CHECK(sum.value() == 1);
}

TEST_CASE("the rounding error of a product is kept", "[exact_sum]") {
  const double a = 1 + std::ldexp(1.0, -30);
  ExactSum sum;
  sum.add_product(a, a);  // 1 + 2^-29 + 2^-60, of which a double keeps only the first two terms
  sum.add(-1 - std::ldexp(1.0, -29));
  CHECK(sum.value() == std::ldexp(1.0, -60));
}

TEST_CASE("products of opposite sign cancel exactly", "[exact_sum]") {
  Random random(1);
  ExactSum sum;
  for (int k = 0; k < 100; ++k) {
    const double a = random.uniform(-1e8, 1e8);
    const double b = random.uniform(-1e-3, 1e3);
    sum.add_product(a, b);
    sum.add_product(-b, a);
  }
  CHECK(sum.value() == 0);
}

TEST_CASE("a residual of a long row is exact to one rounding", "[exact_sum]") {
  // Whole numbers below 2^26 and their products are exact in a 64-bit integer: an independent answer.
  Random random(2);
  ExactSum sum;
  long long exact = 0;
  for (int k = 0; k < 200; ++k) {
    const int a = random.whole(-40000000, 40000000);
    const int b = random.whole(-40000000, 40000000);
    sum.add_product(a, b);
    exact += static_cast<long long>(a) * b;
  }
  sum.add(-std::ldexp(1.0, 70));
  sum.add(std::ldexp(1.0, 70));
  CHECK(sum.value() == static_cast<double>(exact));
}

TEST_CASE("an exact sum starts at the value it is given", "[exact_sum]") {
  CHECK(ExactSum().value() == 0);
  CHECK(ExactSum(-2.5).value() == -2.5);
}

#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex10_4;

TEST_CASE("ex10.4 held out: uneven edges, some nodes on nodes", "[ex10.4]") {
  const Interface nodes{{-1, 0, 0.5, 4}, {-1, 0.5, 2, 3, 4}};  // corners -1, 0, 0.5, 2, 3, 4
  CHECK(most_felt(nodes) == 6);
  CHECK(felt(nodes, {-0.9, -0.5, -0.1}) == 2);       // one stretch: two numbers
  CHECK(felt(nodes, {-0.5, 0.1, 0.2, 0.3}) == 3);    // two stretches: three
  CHECK(felt(nodes, {0.7, 1, 2.1, 2.2, 3.5}) == 4);  // three: four
  CHECK(felt(nodes, {0.7, 1, 2.1, 2.2, 2.3, 3.5}) == 4);
  CHECK(felt(nodes, {3.1, 3.2, 3.3, 3.4}) == 2);
  CHECK(felt(nodes, {}) == 0);
}

TEST_CASE("ex10.4 held out: a point at a corner knows this corner only", "[ex10.4]") {
  const Interface nodes{{0, 1, 2}, {0, 2}};
  CHECK(felt(nodes, {1, 1}) == 1);
  CHECK(felt(nodes, {0.5, 0.6, 1}) == 2);
  CHECK(felt(nodes, {0, 1, 2}) == 3);
  CHECK(felt(nodes, {0, 0.5, 1}) == 2);
  CHECK(felt(nodes, {0.5, 1, 1.5, 2}) == 3);
  CHECK(felt(nodes, {2, 2}) == 1);
}

TEST_CASE("ex10.4 held out: rounding makes no new places, in any unit", "[ex10.4]") {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    std::vector<double> thirds, sum = {0};
    for (int k = 0; k <= 9; ++k) thirds.push_back(unit * k / 9);
    for (int k = 1; k <= 9; ++k) sum.push_back(sum.back() + unit / 9);
    CHECK(most_felt({thirds, sum}) == 10);
    CHECK(felt({thirds, sum}, thirds) == 10);
    CHECK(most_felt({{0, unit / 2, unit}, {0, unit * 0.5000001, unit}}) == 4);
  }
}

// 2 / (w N) is largest where weight and share are small together.
TEST_CASE("ex10.4 held out: any rule, in any order", "[ex10.4]") {
  CHECK(highest_alone({{1, 1}, {-1, 1}}) == Approx(2).epsilon(1e-14));  // the trapezoidal rule
  CHECK(highest_alone({{1, 1. / 3}, {0, 4. / 3}, {-1, 1. / 3}}) == Approx(6).epsilon(1e-14));
  CHECK(highest_alone({{-0.5, 1.5}, {0.5, 0.5}}) == Approx(16. / 3).epsilon(1e-14));
}

TEST_CASE("ex10.4 held out: what is no interface and no rule is refused", "[ex10.4]") {
  CHECK_THROWS_AS(most_felt({{0}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(most_felt({{0, 1}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(most_felt({{0, 1}, {0, 1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(most_felt({{0, 1}, {0, 2}}), std::invalid_argument);
  CHECK_THROWS_AS(most_felt({{0.5, 1}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(felt({{0, 1}, {0, 0.5}}, {0.2}), std::invalid_argument);
  CHECK_THROWS_AS(felt({{0, 1}, {0, 1}}, {0.2, 1.2}), std::invalid_argument);
  CHECK_THROWS_AS(felt({{0, 1}, {0, 1}}, {-0.2, 0.2}), std::invalid_argument);
  CHECK_THROWS_AS(highest_alone({}), std::invalid_argument);
  CHECK_THROWS_AS(highest_alone({{0, 2}}), std::invalid_argument);
  CHECK_THROWS_AS(highest_alone({{0, 1}, {1.1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(highest_alone({{0, 1}, {0.5, 0}}), std::invalid_argument);
}

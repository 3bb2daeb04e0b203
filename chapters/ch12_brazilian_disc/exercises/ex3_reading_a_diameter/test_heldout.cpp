#include <limits>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex12_3;
using Line = std::vector<Point>;

TEST_CASE("ex12.3 held out: the deepest change counts, and only one into tension", "[ex12.3]") {
  CHECK(tension_begins({{0, -1}, {1, 1}, {2, -1}, {3, 3}, {4, 2}}) == Approx(2.25));
  CHECK(tension_begins({{0, -1}, {1, 1}, {2, -1}}) == Approx(0.5));
  CHECK(tension_begins({{0, -1}, {1, 0}, {2, 1}}) == Approx(1));
  CHECK(tension_begins({{0, 0}, {1, 1}}) == Approx(0).margin(1e-300));
  CHECK_FALSE(tension_begins({{0, 1}, {1, 2}}));
  CHECK_FALSE(tension_begins({{0, 1}, {1, -2}}));
  CHECK_FALSE(tension_begins({{0, 0}, {1, 0}}));
  CHECK_FALSE(tension_begins({{0, -1}, {1, 0}}));
}

TEST_CASE("ex12.3 held out: push and pull of a line that crosses often", "[ex12.3]") {
  const Line line = {{-1, 2}, {1, -2}, {2, -2}, {4, 6}, {5, 0}, {7, 0}, {9, -1}};
  CHECK(pull(line) == Approx(1 + 0.5 * 1.5 * 6 + 3).epsilon(1e-14));
  CHECK(push(line) == Approx(1 + 2 + 0.5 * 0.5 * 2 + 1).epsilon(1e-14));
  CHECK(pull({{0, -1}, {1, -2}}) == 0);
  CHECK(push({{0, 1}, {1, 2}}) == 0);
}

TEST_CASE("ex12.3 held out: even to the end, of any sign", "[ex12.3]") {
  const Line line = {{0, -2}, {1, -1}, {2, -3}, {3, -2.2}, {4, -1.9}};
  CHECK(even_from(line, -2, 0.2) == 3.0);  // the first point is within, too
  CHECK(even_from(line, -2, 0.5) == 0.0);
  CHECK_FALSE(even_from(line, -2, 0.01));
  CHECK(even_from(line, -1.9, 0) == 4.0);
}

TEST_CASE("ex12.3 held out: units do not matter", "[ex12.3][units]") {
  const Line line = {{0, -2}, {1, -1}, {2, 3}, {3, 2.5}};
  for (const double length : {1e-9, 1e9})
    for (const double stress : {1e-9, 1e9}) {
      Line other = line;
      for (Point& point : other) point = {point.depth * length, point.stress * stress};
      const auto begins = tension_begins(other);
      REQUIRE(begins);
      CHECK(*begins / length == Approx(1.25).epsilon(1e-12));
      CHECK(pull(other) == Approx(pull(line) * length * stress).epsilon(1e-12));
      CHECK(push(other) == Approx(push(line) * length * stress).epsilon(1e-12));
      CHECK(even_from(other, 2.5 * stress, 0.3) == 2 * length);
    }
}

TEST_CASE("ex12.3 held out: what is no line is refused", "[ex12.3]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double much = std::numeric_limits<double>::infinity();
  for (const Line& bad : {Line{}, Line{{0, 1}}, Line{{0, 1}, {0, 2}}, Line{{1, 1}, {0, 2}},
                          Line{{0, none}, {1, 2}}, Line{{0, 1}, {much, 2}}}) {
    CHECK_THROWS_AS(tension_begins(bad), std::invalid_argument);
    CHECK_THROWS_AS(even_from(bad, 1, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(pull(bad), std::invalid_argument);
    CHECK_THROWS_AS(push(bad), std::invalid_argument);
  }
  CHECK_THROWS_AS(even_from({{0, 1}, {1, 1}}, 1, -0.1), std::invalid_argument);
  CHECK_THROWS_AS(even_from({{0, 1}, {1, 1}}, none, 0.1), std::invalid_argument);
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex12_3;

static const double pi = std::acos(-1.0);
static const double R = 50, P = 41.76, b = 1.08001, q0 = 24.6157, strength = P / (pi * R);

// (a) of the chapter.
static double across(double z) {
  return strength - q0 * ((b * b + 2 * z * z) / (b * std::hypot(b, z)) - 2 * z / b);
}

// Points of the diameter from the contact to the middle, close together at the contact.
static std::vector<Point> diameter(int n) {
  std::vector<Point> line;
  for (int k = 0; k <= n; ++k) {
    const double z = R * std::pow(static_cast<double>(k) / n, 3);
    line.push_back({z, across(z)});
  }
  return line;
}

TEST_CASE("ex12.3 three points by hand", "[ex12.3]") {
  const std::vector<Point> line = {{1, -3}, {2, 1}, {6, 1}};
  REQUIRE(tension_begins(line));
  CHECK(*tension_begins(line) == Approx(1.75).epsilon(1e-14));
  CHECK(push(line) == Approx(3 * 0.75 / 2).epsilon(1e-14));
  CHECK(pull(line) == Approx(0.25 / 2 + 4).epsilon(1e-14));
  REQUIRE(even_from(line, 1, 0));
  CHECK(*even_from(line, 1, 0) == 2);
}

TEST_CASE("ex12.3 an even compression", "[ex12.3]") {
  const auto from = even_from({{0, 3}, {1, -2.01}, {2, -2}}, -2, 0.01);
  REQUIRE(from);
  CHECK(*from == 1);
}

TEST_CASE("ex12.3 where tension begins", "[ex12.3]") {
  const auto begins = tension_begins(diameter(400));
  REQUIRE(begins);
  CHECK(*begins == Approx(2.951).margin(1e-3));
  CHECK(across(*begins - 0.01) < 0);
  CHECK(across(*begins + 0.01) > 0);
}

// The integral of (a) is q0 b / 2 of push and as much of pull, the first all near the contact.
TEST_CASE("ex12.3 what the plates push together pulls the disc apart", "[ex12.3]") {
  const std::vector<Point> line = diameter(400);
  const double zeta = R / b;
  const double left = strength * R - q0 * b * (zeta * std::sqrt(1 + zeta * zeta) - zeta * zeta);
  CHECK(pull(line) - push(line) == Approx(left).margin(2e-3 * q0 * b));
  CHECK(pull(line) == Approx(push(line)).epsilon(0.01));
  CHECK(push(line) > 0.4 * q0 * b);
}

TEST_CASE("ex12.3 from where on (44) holds to a part", "[ex12.3]") {
  const std::vector<Point> line = diameter(400);
  for (const double share : {0.5, 0.1, 0.01}) {
    const auto from = even_from(line, strength, share);
    CAPTURE(share);
    REQUIRE(from);
    CHECK(std::abs(across(*from) / strength - 1) <= share * (1 + 1e-12));
    CHECK(std::abs(across(0.97 * *from) / strength - 1) > share);
  }
}

TEST_CASE("ex12.3 one point is no line", "[ex12.3]") {
  CHECK_THROWS_AS(tension_begins({{0, 1}}), std::invalid_argument);
}

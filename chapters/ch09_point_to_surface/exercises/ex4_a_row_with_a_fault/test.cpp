#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex9_4;

// What the gap does if every node moves by what `motion` says of its position.
template <class Motion>
static double change(const Nodes& at, const Row& row, Motion motion) {
  const auto [x1, y1] = motion(at.x1, at.y1);
  const auto [x2, y2] = motion(at.x2, at.y2);
  const auto [x3, y3] = motion(at.x3, at.y3);
  return row[0] * x1 + row[1] * y1 + row[2] * x2 + row[3] * y2 + row[4] * x3 + row[5] * y3;
}

struct Vector {
  double x, y;
};

static const Nodes figure{4, 0, 0, 3, 3, 1.5};        // figure 9.1
static const Nodes level{1, 0, 0, 0, 0.25, 0.125};    // an edge of length 1, a node near one end
static const Nodes off_middle{2, 0, 0, 0, 1, 0.125};  // above the middle of a longer edge

TEST_CASE("ex9.4 above the middle of an edge of length 1", "[ex9.4]") {
  const auto row = gap_row({1, 0, 0, 0, 0.5, 0.25});
  REQUIRE(row);
  CHECK(*row == Row{0, -0.5, 0, -0.5, 0, 1});
}

TEST_CASE("ex9.4 no gap changes if all nodes move together", "[ex9.4][LinEtAl-21]") {
  for (const Nodes& at : {figure, level, off_middle}) {
    const auto row = gap_row(at);
    REQUIRE(row);
    CHECK(std::abs(change(at, *row, [](double, double) { return Vector{3, -7}; })) < 1e-12);
  }
}

TEST_CASE("ex9.4 no gap changes if all nodes turn together", "[ex9.4][LinEtAl-20]") {
  for (const Nodes& at : {figure, level, off_middle}) {
    const auto row = gap_row(at);
    REQUIRE(row);
    CHECK(std::abs(change(at, *row, [](double x, double y) { return Vector{-y, x}; })) < 1e-12);
  }
}

TEST_CASE("ex9.4 a drawing twice as large has the same row", "[ex9.4][LinEtAl-22]") {
  for (const Nodes& at : {figure, level, off_middle}) {
    const auto row = gap_row(at);
    const auto twice = gap_row({2 * at.x1, 2 * at.y1, 2 * at.x2, 2 * at.y2, 2 * at.x3, 2 * at.y3});
    REQUIRE(row);
    REQUIRE(twice);
    for (std::size_t i = 0; i < 6; ++i) CHECK((*twice)[i] == Approx((*row)[i]).margin(1e-12));
  }
}

TEST_CASE("ex9.4 a node that faces no place of the edge has no row", "[ex9.4]") {
  CHECK_FALSE(gap_row({1, 0, 0, 0, 1.5, 0.25}));
  CHECK_FALSE(gap_row({1, 0, 0, 0, -0.5, 0.25}));
  CHECK_FALSE(gap_row({4, 0, 0, 3, 6, 0}));
}

TEST_CASE("ex9.4 an edge without length is refused", "[ex9.4]") {
  CHECK_THROWS_AS(gap_row({1, 1, 1, 1, 0, 0}), std::invalid_argument);
}

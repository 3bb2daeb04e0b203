#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex10_4;

static std::vector<double> even(int edges) {
  std::vector<double> nodes;
  for (int k = 0; k <= edges; ++k) nodes.push_back(static_cast<double>(k) / edges);
  return nodes;
}

static std::vector<Point> gauss(int n) {
  if (n == 1) return {{0, 2}};
  if (n == 2) return {{-1 / std::sqrt(3.0), 1}, {1 / std::sqrt(3.0), 1}};
  return {{-std::sqrt(0.6), 5.0 / 9}, {0, 8.0 / 9}, {std::sqrt(0.6), 5.0 / 9}};
}

static std::vector<double> points_on(const std::vector<double>& nodes, int n) {
  std::vector<double> points;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    for (const Point& point : gauss(n))
      points.push_back(nodes[k] + (nodes[k + 1] - nodes[k]) * (1 + point.xi) / 2);
  return points;
}

// results/rank.md, up to three points an edge: what the singular values of the forces on all nodes say.
struct Column {
  int above, below;
  int rank[3];
  int stops;
};

static const Column table[] = {{8, 8, {8, 9, 9}, 9},
                               {8, 11, {8, 16, 19}, 19},
                               {11, 8, {11, 19, 19}, 19},
                               {7, 15, {7, 14, 21}, 22}};

TEST_CASE("ex10.4 the entries of the table of ranks", "[ex10.4]") {
  for (const Column& column : table)
    for (const int n : {1, 2, 3}) {
      const Interface nodes{even(column.above), even(column.below)};
      CAPTURE(column.above, column.below, n);
      CHECK(felt(nodes, points_on(nodes.source, n)) == column.rank[n - 1]);
    }
}

// Twelve points in every stretch: more than can be told apart.
TEST_CASE("ex10.4 where the columns stop growing", "[ex10.4]") {
  for (const Column& column : table) {
    const Interface nodes{even(column.above), even(column.below)};
    const int n = 12 * column.above * column.below;
    std::vector<double> points;
    for (int k = 0; k < n; ++k) points.push_back((k + 0.5) / n);
    CAPTURE(column.above, column.below);
    CHECK(most_felt(nodes) == column.stops);
    CHECK(felt(nodes, points) == column.stops);
  }
}

TEST_CASE("ex10.4 one point alone", "[ex10.4][LinEtAl-35]") {
  CHECK(highest_alone(gauss(2)) == Approx(2.536).margin(5e-4));
  CHECK(highest_alone(gauss(3)) == Approx(4.5).margin(5e-4));
}

TEST_CASE("ex10.4 sides of different ends are refused", "[ex10.4]") {
  CHECK_THROWS_AS(most_felt({{0, 1}, {0, 2}}), std::invalid_argument);
}

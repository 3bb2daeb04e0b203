#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

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

// Counted the other way: what unit pressures put on all nodes of both sides, and the rank of that.
static int counted(const Interface& nodes, const std::vector<double>& points) {
  const auto n = static_cast<Eigen::Index>(nodes.source.size() + nodes.target.size());
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(points.size()));
  for (std::size_t p = 0; p < points.size(); ++p) {
    Eigen::Index row = 0;
    for (const std::vector<double>* side : {&nodes.source, &nodes.target})
      for (std::size_t k = 0; k < side->size(); ++k, ++row) {
        const double x = points[p], here = (*side)[k];
        const bool left = x < here;
        if (left ? k == 0 : k + 1 == side->size()) {
          forces(row, static_cast<Eigen::Index>(p)) = x == here ? 1 : 0;
          continue;
        }
        const double h = left ? here - (*side)[k - 1] : (*side)[k + 1] - here;
        forces(row, static_cast<Eigen::Index>(p)) = std::max(0.0, 1 - std::abs(x - here) / h);
      }
  }
  Eigen::FullPivLU<Eigen::MatrixXd> lu(forces);
  lu.setThreshold(1e-9);
  return static_cast<int>(lu.rank());
}

TEST_CASE("ex10.4 the entries of the table of ranks", "[ex10.4]") {
  for (const auto& [above, below] :
       {std::pair(8, 8), std::pair(8, 11), std::pair(11, 8), std::pair(7, 15)})
    for (const int n : {1, 2, 3}) {
      const Interface nodes{even(above), even(below)};
      const std::vector<double> points = points_on(nodes.source, n);
      CAPTURE(above, below, n);
      CHECK(felt(nodes, points) == counted(nodes, points));
      CHECK(felt(nodes, points) <= most_felt(nodes));
    }
}

// Twelve points in every stretch: more than can be told apart.
TEST_CASE("ex10.4 where the columns stop growing", "[ex10.4]") {
  CHECK(most_felt({even(8), even(11)}) == 19);
  CHECK(most_felt({even(7), even(15)}) == 22);
  for (const auto& [above, below] :
       {std::pair(8, 8), std::pair(11, 8), std::pair(1, 1), std::pair(4, 6)}) {
    const Interface nodes{even(above), even(below)};
    std::vector<double> points;
    for (int k = 0; k < 12 * above * below; ++k) points.push_back((k + 0.5) / (12 * above * below));
    CAPTURE(above, below);
    CHECK(most_felt(nodes) == counted(nodes, points));
    CHECK(felt(nodes, points) == most_felt(nodes));
  }
}

TEST_CASE("ex10.4 one point alone", "[ex10.4][LinEtAl-35]") {
  CHECK(highest_alone(gauss(2)) == Approx(2.536).margin(5e-4));
  CHECK(highest_alone(gauss(3)) == Approx(4.5).margin(5e-4));
}

TEST_CASE("ex10.4 sides of different ends are refused", "[ex10.4]") {
  CHECK_THROWS_AS(most_felt({{0, 1}, {0, 2}}), std::invalid_argument);
}

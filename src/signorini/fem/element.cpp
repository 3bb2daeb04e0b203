#include "signorini/fem/element.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

/// The points are the zeros of the Legendre polynomial of degree n, found by Newton's method from
/// an estimate that is within a few per cent; a pair and its mirror image are exactly symmetric.
std::vector<GaussPoint> legendre_rule(int n) {
  std::vector<GaussPoint> rule(static_cast<std::size_t>(n), GaussPoint{0, 0, 0});
  for (int k = 0; k < (n + 1) / 2; ++k) {
    double x = 2 * k + 1 == n ? 0 : std::cos(pi * (k + 0.75) / (n + 0.5));
    double slope = 0;
    for (int step = 0; step < 6; ++step) {
      double last = 1;
      double value = x;
      for (int degree = 2; degree <= n; ++degree) {
        const double next = ((2 * degree - 1) * x * value - (degree - 1) * last) / degree;
        last = value;
        value = next;
      }
      slope = n * (x * value - last) / (x * x - 1);
      x -= value / slope;
    }
    const double weight = 2 / ((1 - x * x) * slope * slope);
    rule[static_cast<std::size_t>(k)] = {-x, 0, weight};
    rule[static_cast<std::size_t>(n - 1 - k)] = {x, 0, weight};
  }
  return rule;
}

}  // namespace

Jacobian jacobian(const Shape& shape, const CellNodes& nodes) {
  Jacobian map;
  map.matrix.noalias() = shape.slope.transpose() * nodes;
  map.determinant = map.matrix.determinant();
  map.gradient.noalias() = shape.slope * map.matrix.inverse().transpose();
  return map;
}

void write_strain_matrix(const CellNodes& gradient, const CellScalars& hoop, StrainMatrix& B) {
  B.setZero(hoop.size() == 0 ? 3 : 4, 2 * gradient.rows());
  for (Eigen::Index k = 0; k < gradient.rows(); ++k) {
    B(0, 2 * k) = B(2, 2 * k + 1) = gradient(k, 0);
    B(1, 2 * k + 1) = B(2, 2 * k) = gradient(k, 1);
  }
  for (Eigen::Index k = 0; k < hoop.size(); ++k) B(3, 2 * k) = hoop(k);
}

void sample_strain(Shape (*shape)(double xi, double eta), const std::vector<GaussPoint>& rule,
                   const CellBody& cell, StrainPoints& points) {
  points.size = 0;
  for (const GaussPoint& gauss : rule) {
    const Shape at = shape(gauss.xi, gauss.eta);
    const Jacobian map = jacobian(at, cell.arms);
    StrainPoint& point = points.point[static_cast<std::size_t>(points.size++)];
    point.local << gauss.xi, gauss.eta;
    point.volume = gauss.weight * map.determinant * cell.depth_at(at.value);
    write_strain_matrix(map.gradient, cell.hoop(at.value, at.value), point.B);
  }
}

const std::vector<GaussPoint>& gauss_line(int n) {
  static const std::array<std::vector<GaussPoint>, 16> rules = [] {
    const double two = std::sqrt(1.0 / 3.0);
    const double three = std::sqrt(0.6);
    std::array<std::vector<GaussPoint>, 16> made;
    made[0] = {{0, 0, 2}};
    made[1] = {{-two, 0, 1}, {two, 0, 1}};
    made[2] = {{-three, 0, 5.0 / 9.0}, {0, 0, 8.0 / 9.0}, {three, 0, 5.0 / 9.0}};
    for (int m = 4; m <= 16; ++m) made[static_cast<std::size_t>(m - 1)] = legendre_rule(m);
    return made;
  }();
  require_argument(n >= 1 && n <= 16, "gauss_line: rules have 1 to 16 points, got ", n);
  return rules[static_cast<std::size_t>(n - 1)];
}

const std::vector<GaussPoint>& gauss_square(int n) {
  const auto product = [](int points) {
    std::vector<GaussPoint> rule;
    for (const GaussPoint& b : gauss_line(points))
      for (const GaussPoint& a : gauss_line(points))
        rule.push_back({a.xi, b.xi, a.weight * b.weight});
    return rule;
  };
  static const std::vector<GaussPoint> rules[] = {product(2), product(3)};
  require_argument(n == 2 || n == 3, "gauss_square: rules have 2 x 2 or 3 x 3 points, got n = ", n);
  return rules[n - 2];
}

const std::vector<GaussPoint>& gauss_triangle(int n) {
  // The three places (a, a), (1 - 2 a, a), (a, 1 - 2 a), each of the same weight.
  const auto three = [](double a, double weight, std::vector<GaussPoint>& rule) {
    for (const auto& [xi, eta] : {std::pair(a, a), {1 - 2 * a, a}, {a, 1 - 2 * a}})
      rule.push_back({xi, eta, weight});
  };
  static const std::array<std::vector<GaussPoint>, 2> rules = [&three] {
    std::array<std::vector<GaussPoint>, 2> made;
    three(1.0 / 6, 1.0 / 6, made[0]);
    const double root = std::sqrt(10.0);
    const double place = std::sqrt(38 - 44 * std::sqrt(0.4));
    const double share = std::sqrt(213125 - 53320 * root);
    three((8 - root + place) / 18, (620 + share) / 7440, made[1]);
    three((8 - root - place) / 18, (620 - share) / 7440, made[1]);
    return made;
  }();
  require_argument(n == 3 || n == 6, "gauss_triangle: rules have 3 or 6 points, got ", n);
  return rules[n == 3 ? 0 : 1];
}

const std::vector<GaussPoint>& gauss_cell(const Element& element) {
  return element.corners() == 3 ? gauss_triangle(6) : gauss_square(3);
}

CellNodes reference_nodes(const Element& element) {
  const int n = element.corners();
  CellNodes nodes(element.n_nodes, 2);
  if (n == 3)
    nodes.topRows(3) << 0, 0, 1, 0, 0, 1;
  else
    nodes.topRows(4) << -1, -1, 1, -1, 1, 1, -1, 1;
  for (Eigen::Index k = n; k < element.n_nodes; ++k)
    nodes.row(k) = 0.5 * (nodes.row(k - n) + nodes.row((k - n + 1) % n));
  return nodes;
}

}  // namespace signorini

#include "signorini/elasticity/element.hpp"

#include <Eigen/LU>
#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {

Jacobian jacobian(const Shape& shape, const CellNodes& nodes) {
  Jacobian map;
  map.matrix.noalias() = shape.slope.transpose() * nodes;
  map.determinant = map.matrix.determinant();
  map.gradient.noalias() = shape.slope * map.matrix.inverse().transpose();
  return map;
}

StrainMatrix strain_matrix(const CellNodes& gradient) {
  StrainMatrix B = StrainMatrix::Zero(3, 2 * gradient.rows());
  for (Eigen::Index k = 0; k < gradient.rows(); ++k) {
    B(0, 2 * k) = B(2, 2 * k + 1) = gradient(k, 0);
    B(1, 2 * k + 1) = B(2, 2 * k) = gradient(k, 1);
  }
  return B;
}

void sample_strain(Shape (*shape)(double xi, double eta), const std::vector<GaussPoint>& rule,
                   const CellNodes& nodes, StrainPoints& points) {
  points.size = 0;
  for (const GaussPoint& gauss : rule) {
    const Jacobian map = jacobian(shape(gauss.xi, gauss.eta), nodes);
    StrainPoint& point = points.point[static_cast<std::size_t>(points.size++)];
    point.local << gauss.xi, gauss.eta;
    point.area = gauss.weight * map.determinant;
    point.B = strain_matrix(map.gradient);
  }
}

const std::vector<GaussPoint>& gauss_line(int n) {
  static const double two = std::sqrt(1.0 / 3.0);
  static const double three = std::sqrt(0.6);
  static const std::vector<GaussPoint> rules[] = {
      {{0, 0, 2}},
      {{-two, 0, 1}, {two, 0, 1}},
      {{-three, 0, 5.0 / 9.0}, {0, 0, 8.0 / 9.0}, {three, 0, 5.0 / 9.0}}};
  require(n >= 1 && n <= 3, "gauss_line: rules have 1, 2 or 3 points, got ", n);
  return rules[n - 1];
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
  require(n == 2 || n == 3, "gauss_square: rules have 2 x 2 or 3 x 3 points, got n = ", n);
  return rules[n - 2];
}

}  // namespace signorini

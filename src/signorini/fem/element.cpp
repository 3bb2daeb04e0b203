// # From the reference cell to a real one
//
// Every integral over a cell is one over a reference cell: the square \f$[-1,1]^2\f$, or the
// triangle with the corners (0, 0), (1, 0) and (0, 1). The shape functions that interpolate
// displacements also map the places, \f$x(\xi,\eta) = \sum_k N_k(\xi,\eta)\,x_k\f$, which makes
// the element *isoparametric*. With the Jacobian matrix \f$J\f$ of this map and the depth \f$t\f$
// across the plane,
//
// \f[ \int_{cell} f\,dV = \int f\,\det J\,t\;d\xi\,d\eta \approx \sum_i w_i\,f_i\,\det J_i\,t_i. \f]
//
// A Gauss rule of \f$n\f$ points on a line is exact for polynomials of degree \f$2n-1\f$. The rule
// of two points has \f$\xi = \pm 1/\sqrt3\f$ and weights 1. It gives
// \f$\int_{-1}^{1}\xi^2\,d\xi = 2/3\f$, which is right, and \f$\int_{-1}^{1}\xi^4\,d\xi = 2/9\f$
// where 2/5 is right. A displacement that is bilinear has strains of degree 1 in each coordinate,
// so that the energy of a parallelogram in the plane needs degree 2 in each, and 2 x 2 points are
// exact. On a curved or distorted cell the integrand is a fraction and no rule is exact. What has
// to hold there is the patch test: rigid motions give no strain, and linear displacements give the
// exact one.

#include "signorini/fem/element.hpp"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

/// The points are the zeros of the Legendre polynomial of degree n, found by Newton's method from
/// an estimate that is within a few per cent; a pair and its mirror image are exactly symmetric.
///
/// Rules of more than three points have no short formula. A table would be more than a hundred
/// numbers to mistype, so these rules are computed.
std::vector<GaussPoint> legendre_rule(int n) {
  std::vector<GaussPoint> rule(static_cast<std::size_t>(n), GaussPoint{0, 0, 0});
  for (int k = 0; k < (n + 1) / 2; ++k) {
    double x = 2 * k + 1 == n ? 0 : std::cos(pi * (k + 0.75) / (n + 0.5));
    // \f$P_n\f$ and its slope follow from \f$n P_n = (2n-1)\,x P_{n-1} - (n-1)\,P_{n-2}\f$.
    // Newton's method doubles the number of right digits in each step; six steps are more than
    // enough.
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
    // The weight that makes the rule exact is \f$2 / ((1-x^2)\,P_n'(x)^2)\f$.
    const double weight = 2 / ((1 - x * x) * slope * slope);
    rule[static_cast<std::size_t>(k)] = {-x, 0, weight};
    rule[static_cast<std::size_t>(n - 1 - k)] = {x, 0, weight};
  }
  return rule;
}

}  // namespace

/// The chain rule. The rows of \f$J\f$ are \f$\partial x/\partial\xi\f$ and
/// \f$\partial x/\partial\eta\f$, so that \f$\nabla_\xi N = J\,\nabla_x N\f$, and the slopes that
/// strains need are \f$\nabla_x N = J^{-1}\nabla_\xi N\f$.
Jacobian jacobian(const Shape& shape, const CellNodes& nodes) {
  Jacobian map;
  map.matrix.noalias() = shape.slope.transpose() * nodes;
  map.determinant = map.matrix.determinant();
  map.gradient.noalias() = shape.slope * map.matrix.inverse().transpose();
  return map;
}

/// In the plane \f$\varepsilon = (u_{x,x},\; u_{y,y},\; u_{x,y} + u_{y,x})\f$. The third component
/// is the angle by which a square is sheared, twice the component of the tensor: with it
/// \f$\sigma^T\varepsilon\f$ is the work. A body of revolution adds the hoop strain \f$u_x/x\f$.
void write_strain_matrix(const CellNodes& gradient, const CellScalars& hoop, StrainMatrix& B) {
  B.setZero(hoop.size() == 0 ? 3 : 4, 2 * gradient.rows());
  for (Eigen::Index k = 0; k < gradient.rows(); ++k) {
    B(0, 2 * k) = B(2, 2 * k + 1) = gradient(k, 0);
    B(1, 2 * k + 1) = B(2, 2 * k) = gradient(k, 1);
  }
  for (Eigen::Index k = 0; k < hoop.size(); ++k) B(3, 2 * k) = hoop(k);
}

/// Volume stands at each point as one number: weight, determinant and depth. Stiffness, mean stress
/// and body force then multiply by it once, and none of them can forget the depth.
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

/// The rules of one to three points are written as roots, not as decimals. The mirror image of a
/// point is then exactly a point, and a symmetric body gets a symmetric matrix to the last bit.
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

/// On the triangle a product of line rules would crowd the points into one corner. Points that the
/// three rotations of the triangle exchange prefer none of its corners. Three points are exact to
/// degree 2: \f$\int\xi\eta = 1/24\f$. For \f$\int\xi^3 = 1/20\f$ they give 0.0509; six points are
/// right.
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

// Integrals for tests of closed forms, by a rule that does not mind roots and logarithms at the ends.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "signorini/core/rounding.hpp"

namespace quadrature {

using signorini::pi;

using Function = std::function<double(double)>;

/// Integral over (from, to): the double exponential rule, to about 1e-14 of the integral of |f| if f
/// is smooth inside; values that are not finite, at the ends, count nothing.
inline double integral(const Function& f, double from, double to) {
  const double half = 0.5 * (to - from);
  const double step = 1.0 / 64;
  double sum = 0;
  for (int k = -4 * 64; k <= 4 * 64; ++k) {
    const double t = step * k;
    const double u = 0.5 * pi * std::sinh(t);
    // from the nearer end, so that the distance keeps its digits
    const double away = half * std::exp(-std::abs(u)) / std::cosh(u);
    const double x = u < 0 ? from + away : to - away;
    const double value = f(x);
    const double weight = 0.5 * pi * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    if (std::isfinite(value)) sum += weight * value;
  }
  return sum * step * half;
}

/// Integral over pieces that meet at the points, in rising order, where f is not smooth.
inline double integral(const Function& f, const std::vector<double>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += integral(f, points[i - 1], points[i]);
  return sum;
}

/// Principal value of the integral of p(s) / (x - s); x lies between two of the points, in rising
/// order, where p is not smooth.
inline double principal_value(const Function& p, double x, const std::vector<double>& points) {
  double sum = 0;
  const Function whole = [&](double s) { return p(s) / (x - s); };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double low = points[i - 1];
    const double high = points[i];
    if (x <= low || x >= high) {
      sum += integral(whole, low, high);
      continue;
    }
    const double d = 0.5 * std::min(x - low, high - x);
    sum += integral(whole, low, x - d) + integral(whole, x + d, high);
    const int n = 400;  // the rest is smooth: the midpoint rule with two steps extrapolated
    const auto middle = [&](int cells) {
      double rest = 0;
      for (int k = 0; k < cells; ++k) {
        const double t = (k + 0.5) * d / cells;
        rest += (p(x - t) - p(x + t)) / t * d / cells;
      }
      return rest;
    };
    sum += (4 * middle(2 * n) - middle(n)) / 3;
  }
  return sum;
}

/// Stress below tractions on the surface, one line load after the other: (xx, yy, xy) in tension,
/// y out of the body; the pressure presses, the shear pulls along x.
inline Eigen::Vector3d below(const Function& pressure, const Function& shear, double x,
                             double depth, const std::vector<double>& points) {
  Eigen::Vector3d stress;
  for (int k = 0; k < 3; ++k) {
    stress[k] = integral(
        [&](double s) {
          const double X = x - s;
          const double r2 = X * X + depth * depth;
          // radial tension of the line load, whose direction from the load is (X, -depth)
          const double radial = -2 / pi * (pressure(s) * depth + shear(s) * X) / (r2 * r2);
          return radial * (k == 0 ? X * X : k == 1 ? depth * depth : -X * depth);
        },
        points);
  }
  return stress;
}

/// Largest residual of equilibrium and of compatibility of a field of stress at a point, by central
/// differences with the step h.
inline double residual(const std::function<Eigen::Vector3d(double, double)>& stress, double x,
                       double y, double h) {
  const Eigen::Vector3d e = stress(x + h, y), w = stress(x - h, y), n = stress(x, y + h),
                        s = stress(x, y - h), o = stress(x, y);
  const double along_x = (e[0] - w[0] + n[2] - s[2]) / (2 * h);
  const double along_y = (e[2] - w[2] + n[1] - s[1]) / (2 * h);
  const auto trace = [](const Eigen::Vector3d& v) { return v[0] + v[1]; };
  const double harmonic = (trace(e) + trace(w) + trace(n) + trace(s) - 4 * trace(o)) / h;
  return std::max({std::abs(along_x), std::abs(along_y), std::abs(harmonic)});
}

}  // namespace quadrature

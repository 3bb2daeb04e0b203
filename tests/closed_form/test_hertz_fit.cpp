#include <cmath>
#include <functional>

#include "catch_compat.hpp"
#include "closed_form/hertz_fit.hpp"
#include "support/quadrature.hpp"

using namespace signorini;

namespace {

constexpr double b = 1.08;
constexpr double q0 = 24.6;

double pressure(double x) { return q0 * std::sqrt(std::max(0.0, 1 - x * x / (b * b))); }

/// Nodes from `first` on; each step is `growth` times the one before; the last lies beyond b.
std::vector<double> nodes(double first, double step, double growth) {
  std::vector<double> x{first};
  while (x.back() < 1.3 * b) {
    x.push_back(x.back() + step);
    step *= growth;
  }
  return x;
}

std::vector<double> at(const std::vector<double>& x) {
  std::vector<double> p;
  for (const double each : x) p.push_back(pressure(each));
  return p;
}

/// Nodal forces of the exact pressure on edges of two nodes.
std::vector<double> linear_forces(const std::vector<double>& x,
                                  const std::function<double(double)>& shape = pressure) {
  std::vector<double> f(x.size());
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double from = x[i - 1], h = x[i] - from;
    const double to = std::max(from, std::min(x[i], b));  // the pressure ends inside of an edge
    const double low = std::min(to, std::max(from, -b));
    f[i] += quadrature::integral([&](double s) { return shape(s) * (s - from) / h; }, low, to);
    f[i - 1] +=
        quadrature::integral([&](double s) { return shape(s) * (from + h - s) / h; }, low, to);
  }
  return f;
}

/// Nodal forces on edges of three nodes, the nodes 0 2 4 ... being the ends.
std::vector<double> quadratic_forces(const std::vector<double>& x,
                                     const std::function<double(double)>& shape = pressure) {
  std::vector<double> f(x.size());
  for (std::size_t i = 2; i < x.size(); i += 2)
    for (std::size_t k = 0; k < 3; ++k) {
      const double own = x[i - 2 + k], one = x[i - 2 + (k + 1) % 3], two = x[i - 2 + (k + 2) % 3];
      f[i - 2 + k] += quadrature::integral(
          [&](double s) { return shape(s) * (s - one) * (s - two) / ((own - one) * (own - two)); },
          x[i - 2], std::max(x[i - 2], std::min(x[i], b)));
    }
  return f;
}

double bare(const std::vector<double>& x, const std::vector<double>& f) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += f[i];
    moment += f[i] * x[i] * x[i];
  }
  return 2 * std::sqrt(moment / sum);
}

}  // namespace

TEST_CASE("Hertz fit: exact pressures give the exact ellipse on any nodes", "[hertz-fit]") {
  for (const auto& x : {nodes(0, b / 12, 1), nodes(0.3 * b, b / 40, 1.1), nodes(-1.3 * b, b / 9, 1),
                        nodes(0, b / 6, 1), nodes(-1.1 * b, b / 8, 0.97)}) {
    CAPTURE(x.size());
    const HertzFit fit = fit_hertz(x, at(x));
    CHECK(fit.peak_pressure == Approx(q0).epsilon(1e-12).margin(0));
    CHECK(fit.half_width == Approx(b).epsilon(1e-12).margin(0));
  }
}

TEST_CASE("Hertz fit: the outer tenth does not count", "[hertz-fit]") {
  const std::vector<double> x = nodes(0, b / 20, 1);
  std::vector<double> p = at(x);
  p[19] *= 1.3;  // at 0.95 b
  CHECK(fit_hertz(x, p).peak_pressure == Approx(q0).epsilon(1e-12).margin(0));
  CHECK(std::abs(fit_hertz(x, p, 1).peak_pressure / q0 - 1) > 1e-3);
}

TEST_CASE("Hertz fit: means around the nodes are too small by the curvature", "[hertz-fit]") {
  for (const double n : {12., 24., 48.}) {
    CAPTURE(n);
    const std::vector<double> x = nodes(0, b / n, 1);
    std::vector<double> p = linear_forces(x);
    for (std::size_t i = 0; i < p.size(); ++i) p[i] /= i == 0 ? b / n / 2 : b / n;
    // In the middle the mean is too small by h^2 / (12 b^2), so p^2 by twice that over 1 - s, s = x^2 / b^2. The line through all of
    // this, |x| < c b with c = 0.9, begins lower: mean - slope c^2 / 3 with mean = artanh(c) / c = 1.636 and
    // slope = (mean (1 - c^2 / 3) - 1) / (4 c^4 / 45) = 3.329, which is 0.737. With few edges the sum is not yet the integral: 12, 24,
    // 48 and 96 give 0.825, 0.763, 0.725 and 0.737.
    const double error = (fit_hertz(x, p).peak_pressure / q0 - 1) * 12 * n * n;
    CHECK(error == Approx(-1).margin(0.35));  // a mesh of 12 edges errs by 0.05 %, of 48 by 0.003 %
  }
}

TEST_CASE("half-width of forces: errs by less than 0.02 % on 10 edges, equal or not",
          "[hertz-fit]") {
  for (const auto& x : {nodes(0, b / 10, 1), nodes(0, b / 10.4, 1), nodes(-1.2 * b, b / 10.5, 1),
                        nodes(0, b / 20, 1.08), nodes(0, b / 12, 0.985)}) {
    CAPTURE(x.size());
    const std::vector<double> f = linear_forces(x);
    CHECK(half_width_of_forces(x, f) == Approx(b).epsilon(2e-4).margin(0));
    CHECK(bare(x, f) > b * 1.001);
  }
}

TEST_CASE(
    "half-width of forces: the bare sum is too large by h^2 / 3 b^2, the corrected one is not",
    "[hertz-fit]") {
  double before = 1;
  for (const double n : {10., 20., 40.}) {
    CAPTURE(n);
    const std::vector<double> x = nodes(0, b / n, 1);
    const std::vector<double> f = linear_forces(x);
    // What is left: the root of 1 + 2 h^2 / (3 b^2) has the next term -h^2 / (6 b^2), -0.0017 with 10 edges; and the mean of
    // (x - x_i)(x_{i+1} - x) under a pressure that ends as a root has one of order (h/b)^1.5, 0.03 with 10 edges times 0.05 as 10, 20
    // and 40 edges agree. Either is less than a tenth of the margin.
    CHECK((bare(x, f) / b - 1) * 3 * n * n == Approx(1).margin(0.0005));
    const double error = std::abs(half_width_of_forces(x, f) / b - 1);
    CHECK(error < before / 8);  // better than third order
    before = error;
  }
}

TEST_CASE("half-width of forces: exact on quadratic edges", "[hertz-fit]") {
  std::vector<double> x = nodes(0, b / 14.3, 1);
  if (x.size() % 2 == 0) x.pop_back();
  CHECK(half_width_of_forces(x, quadratic_forces(x), Trace::Quadratic) ==
        Approx(b).epsilon(1e-12).margin(0));
}

TEST_CASE("half-width of forces: a half-model gives what the whole model gives", "[hertz-fit]") {
  const std::vector<double> half = nodes(0, b / 11.3, 1);
  std::vector<double> whole;
  for (std::size_t i = half.size() - 1; i > 0; --i) whole.push_back(-half[i]);
  whole.insert(whole.end(), half.begin(), half.end());
  CHECK(half_width_of_forces(half, linear_forces(half)) ==
        Approx(half_width_of_forces(whole, linear_forces(whole))).epsilon(1e-13).margin(0));
}

TEST_CASE("Hertz fit: what is no ellipse is refused", "[hertz-fit]") {
  CHECK_THROWS_WITH(fit_hertz({0, 1}, {1}), ContainsSubstring("2 nodes and 1"));
  CHECK_THROWS_WITH(fit_hertz({0, 1, 2}, {1, 0, 0}), ContainsSubstring("no ellipse"));
  CHECK_THROWS_WITH(fit_hertz({0, 1, 2}, {1, 2, 3}), ContainsSubstring("no ellipse"));
  CHECK_THROWS_WITH(fit_hertz({}, {}), ContainsSubstring("no ellipse"));
  CHECK_THROWS_WITH(fit_hertz({-1, 1}, {2, 2}), ContainsSubstring("no ellipse"));
  CHECK_THROWS_WITH(fit_hertz({0, 1}, {2, 1}, 0), ContainsSubstring("(0, 1]"));
  CHECK_THROWS_WITH(half_width_of_forces({0, 1}, {0, 0}), ContainsSubstring("must be positive"));
  CHECK_THROWS_WITH(half_width_of_forces({1, 0}, {1, 1}), ContainsSubstring("rising order"));
  CHECK_THROWS_WITH(half_width_of_forces({0}, {1}), ContainsSubstring("more nodes"));
}

TEST_CASE("half-width of forces on a circle: exact on quadratic rings, nearly so on linear ones",
          "[hertz-fit][circle]") {
  std::vector<double> x = nodes(0, b / 14.3, 1);
  if (x.size() % 2 == 0) x.pop_back();
  const auto rings = [](double s) { return s * pressure(s); };
  CHECK(half_width_of_forces(x, quadratic_forces(x, rings), Trace::Quadratic, Footprint::Circle) ==
        Approx(b).epsilon(1e-9).margin(0));
  double before = 1;
  for (const double n : {10., 20., 40.}) {
    const std::vector<double> line = nodes(0, b / n, 1);
    const double width =
        half_width_of_forces(line, linear_forces(line, rings), Trace::Linear, Footprint::Circle);
    CHECK(std::abs(width / b - 1) < before / 8);
    before = std::abs(width / b - 1);
  }
}

TEST_CASE("Hertz fit of a circle: nodes count as their rings do, and that on the axis not",
          "[hertz-fit][circle]") {
  const std::vector<double> x = nodes(0, b / 12, 1);
  std::vector<double> p = at(x);
  p[0] *= 0.9;
  const auto peak = [&](Footprint footprint) {
    return fit_hertz(x, p, fitted_part, footprint).peak_pressure;
  };
  CHECK(peak(Footprint::Circle) == Approx(q0).epsilon(1e-12).margin(0));
  CHECK(peak(Footprint::Strip) < 0.99 * q0);
  // What is wrong at a place counts in proportion to its radius: two errors of one moment about the mean cancel.
  const auto lifted = [&](std::size_t node) {
    std::vector<double> wrong = at(x);
    wrong[node] = std::sqrt(wrong[node] * wrong[node] + 1e-6);
    return fit_hertz(x, wrong, fitted_part, Footprint::Circle).peak_pressure - q0;
  };
  const auto even = [&](std::size_t node) {
    std::vector<double> wrong = at(x);
    wrong[node] = std::sqrt(wrong[node] * wrong[node] + 1e-6);
    return fit_hertz(x, wrong).peak_pressure - q0;
  };
  CHECK(lifted(1) / even(1) < 0.5 * lifted(4) / even(4));
}

TEST_CASE("the derivatives of the fit and of the width are those of central differences",
          "[hertz_fit][derivative]") {
  const std::vector<double> x = nodes(0, 0.08, 1.1);
  const std::vector<double> force = linear_forces(x);
  const Trace trace = GENERATE(Trace::Linear, Trace::Quadratic);
  const Footprint footprint = GENERATE(Footprint::Strip, Footprint::Circle);
  const std::vector<double> of_peak = peak_pressure_gradient(x, at(x), fitted_part, footprint);
  const std::vector<double> of_width = half_width_gradient(x, force, trace, footprint);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const auto difference = [&](std::vector<double> numbers, double step, auto&& read) {
      numbers[i] += step;
      const double more = read(numbers);
      numbers[i] -= 2 * step;
      return (more - read(numbers)) / (2 * step);
    };
    if (at(x)[i] > 0)
      CHECK(of_peak[i] ==
            Approx(difference(at(x), 1e-5,
                              [&](const auto& p) {
                                return fit_hertz(x, p, fitted_part, footprint).peak_pressure;
                              }))
                .epsilon(1e-6)
                .margin(1e-9));
    CHECK(of_width[i] == Approx(difference(force, 1e-5,
                                           [&](const auto& f) {
                                             return half_width_of_forces(x, f, trace, footprint);
                                           }))
                             .epsilon(1e-6)
                             .margin(1e-9));
  }
}

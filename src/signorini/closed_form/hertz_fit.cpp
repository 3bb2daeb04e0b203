#include "signorini/closed_form/hertz_fit.hpp"

#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

/// The line p^2 = height - slope x^2 through some of the nodes, and how many there are.
struct Line {
  double height = 0;
  double slope = 0;
  int nodes = 0;
};

Line fit_line(const std::vector<double>& x, const std::vector<double>& pressure, double reach) {
  double x2 = 0, p2 = 0;
  Line line;
  const auto counts = [&](std::size_t i) { return pressure[i] > 0 && std::abs(x[i]) < reach; };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!counts(i)) continue;
    ++line.nodes;
    x2 += x[i] * x[i];
    p2 += pressure[i] * pressure[i];
  }
  x2 /= line.nodes;
  p2 /= line.nodes;
  double square = 0, product = 0;  // about the means
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!counts(i)) continue;
    square += (x[i] * x[i] - x2) * (x[i] * x[i] - x2);
    product += (x[i] * x[i] - x2) * (pressure[i] * pressure[i] - p2);
  }
  line.slope = -product / square;
  line.height = p2 + line.slope * x2;
  return line;
}

/// The line that fit_hertz() ends with.
struct Fit {
  Line line;
  double reach;  // of the nodes that it goes through
};

Fit fitted(const std::vector<double>& x, const std::vector<double>& pressure, double inner) {
  require(x.size() == pressure.size(), "Hertz fit: ", x.size(), " nodes and ", pressure.size(),
          " pressures");
  require(inner > 0 && inner <= 1, "Hertz fit: inner part must lie in (0, 1], got ", inner);
  Fit fit{{}, std::numeric_limits<double>::infinity()};
  for (std::size_t round = 0; round <= x.size(); ++round) {
    const int before = fit.line.nodes;
    if (round > 0) fit.reach = inner * std::sqrt(fit.line.height / fit.line.slope);
    fit.line = fit_line(x, pressure, fit.reach);
    const Line& line = fit.line;
    require(line.nodes >= 2 && line.slope > 0 && line.height > 0, "Hertz fit: the pressure of ",
            line.nodes,
            " nodes is no ellipse: this contact does not press as Hertz's does, for which ask for "
            "force or displacement, or has too few nodes");
    if (line.nodes == before) break;
  }
  return fit;
}

/// What each force adds to the second moment.
std::vector<double> moments(const std::vector<double>& x, Trace trace) {
  std::vector<double> moment;
  const auto step = [&](std::size_t i) { return i + 1 < x.size() ? x[i + 1] - x[i] : 0.0; };
  for (std::size_t i = 0; i < x.size(); ++i) {
    require(i == 0 || x[i] > x[i - 1], "half-width: nodes must come in rising order");
    moment.push_back(x[i] * x[i]);
    const double before = i > 0 ? step(i - 1) : 0.0;
    const double after = step(i);
    const double share = (before + after) / 2;
    if (trace == Trace::Linear && share > 0)
      moment[i] -= (before * before * before + after * after * after) / 12 / share;
  }
  return moment;
}

/// The sum of the forces and their second moment.
struct Moments {
  double sum = 0, second = 0;
};

Moments moments_of(const std::vector<double>& force, const std::vector<double>& moment) {
  require(moment.size() == force.size(), "half-width: ", moment.size(), " nodes and ", force.size(),
          " forces");
  Moments of;
  for (std::size_t i = 0; i < force.size(); ++i) {
    of.sum += force[i];
    of.second += force[i] * moment[i];
  }
  require(of.sum > 0, "half-width: the sum of the forces must be positive, got ", of.sum);
  require(of.second > 0, "half-width: more nodes in the contact are needed");
  return of;
}

}  // namespace

HertzFit fit_hertz(const std::vector<double>& x, const std::vector<double>& pressure,
                   double inner) {
  const Line line = fitted(x, pressure, inner).line;
  return {std::sqrt(line.height), std::sqrt(line.height / line.slope)};
}

std::vector<double> peak_pressure_gradient(const std::vector<double>& x,
                                           const std::vector<double>& pressure, double inner) {
  const Fit fit = fitted(x, pressure, inner);
  const auto counts = [&](std::size_t i) { return pressure[i] > 0 && std::abs(x[i]) < fit.reach; };
  double mean = 0, square = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (counts(i)) mean += x[i] * x[i] / fit.line.nodes;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (counts(i)) square += (x[i] * x[i] - mean) * (x[i] * x[i] - mean);
  std::vector<double> gradient(x.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (counts(i))
      gradient[i] = (1.0 / fit.line.nodes - mean * (x[i] * x[i] - mean) / square) * pressure[i] /
                    std::sqrt(fit.line.height);
  return gradient;
}

double half_width_of_forces(const std::vector<double>& x, const std::vector<double>& force,
                            Trace trace) {
  const Moments of = moments_of(force, moments(x, trace));
  return 2 * std::sqrt(of.second / of.sum);
}

std::vector<double> half_width_gradient(const std::vector<double>& x,
                                        const std::vector<double>& force, Trace trace) {
  std::vector<double> gradient = moments(x, trace);
  const Moments of = moments_of(force, gradient);
  const double half_width = 2 * std::sqrt(of.second / of.sum);
  for (double& one : gradient) one = half_width / 2 * (one / of.second - 1 / of.sum);
  return gradient;
}

}  // namespace signorini

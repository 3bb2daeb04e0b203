#include "closed_form/hertz_fit.hpp"

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
  double mean = 0;    // of x^2
  double square = 0;  // of x^2 about its mean, summed
  double all = 0;     // what the nodes count together
};

/// How much a node counts.
double counted(double x, Footprint footprint) {
  return footprint == Footprint::Strip ? 1 : std::abs(x);
}

/// Calls visit(i, what it counts) for the nodes that a fit goes through.
template <typename Visit>
void each_fitted(const std::vector<double>& x, const std::vector<double>& pressure, double reach,
                 Footprint footprint, Visit&& visit) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double counts = counted(x[i], footprint);
    if (counts > 0 && pressure[i] > 0 && std::abs(x[i]) < reach) visit(i, counts);
  }
}

Line fit_line(const std::vector<double>& x, const std::vector<double>& pressure, double reach,
              Footprint footprint) {
  double p2 = 0;
  Line line;
  each_fitted(x, pressure, reach, footprint, [&](std::size_t i, double counts) {
    ++line.nodes;
    line.all += counts;
    line.mean += counts * x[i] * x[i];
    p2 += counts * pressure[i] * pressure[i];
  });
  line.mean /= line.all;
  p2 /= line.all;
  double product = 0;  // about the means
  each_fitted(x, pressure, reach, footprint, [&](std::size_t i, double counts) {
    const double arm = x[i] * x[i] - line.mean;
    line.square += counts * arm * arm;
    product += counts * arm * (pressure[i] * pressure[i] - p2);
  });
  line.slope = -product / line.square;
  line.height = p2 + line.slope * line.mean;
  return line;
}

/// The line that fit_hertz() ends with.
struct Fit {
  Line line;
  double reach;  // of the nodes that it goes through
};

Fit fitted(const std::vector<double>& x, const std::vector<double>& pressure, double inner,
           Footprint footprint) {
  require_argument(x.size() == pressure.size(), "Hertz fit: ", x.size(), " nodes and ",
                   pressure.size(), " pressures");
  require_argument(inner > 0 && inner <= 1, "Hertz fit: inner part must lie in (0, 1], got ",
                   inner);
  Fit fit{{}, std::numeric_limits<double>::infinity()};
  for (std::size_t round = 0; round <= x.size(); ++round) {
    const int before = fit.line.nodes;
    if (round > 0) fit.reach = inner * std::sqrt(fit.line.height / fit.line.slope);
    fit.line = fit_line(x, pressure, fit.reach, footprint);
    const Line& line = fit.line;
    require_argument(
        line.nodes >= 2 && line.slope > 0 && line.height > 0, "Hertz fit: the pressure of ",
        line.nodes,
        " nodes is no ellipse: this contact does not press as Hertz's does, for which ask for "
        "force or displacement, or has too few nodes");
    if (line.nodes == before) break;
  }
  return fit;
}

/// What each force adds to the second moment.
std::vector<double> moments(const std::vector<double>& x, Trace trace, Footprint footprint) {
  std::vector<double> moment;
  for (std::size_t i = 0; i < x.size(); ++i) {
    require_argument(i == 0 || x[i] > x[i - 1], "half-width: nodes must come in rising order");
    double share = 0, beyond = 0;  // of the edges around the node
    const auto edge = [&](std::size_t other) {
      const double length = std::abs(x[other] - x[i]);
      const bool ring = footprint == Footprint::Circle;
      share += length / 2 * (ring ? (2 * x[i] + x[other]) / 3 : 1);
      beyond += length * length * length / 12 * (ring ? (x[i] + x[other]) / 2 : 1);
    };
    if (i > 0) edge(i - 1);
    if (i + 1 < x.size()) edge(i + 1);
    moment.push_back(x[i] * x[i] - (trace == Trace::Linear && share > 0 ? beyond / share : 0));
  }
  return moment;
}

/// The sum of the forces and their second moment.
struct Moments {
  double sum = 0, second = 0;
};

Moments moments_of(const std::vector<double>& force, const std::vector<double>& moment) {
  require_argument(moment.size() == force.size(), "half-width: ", moment.size(), " nodes and ",
                   force.size(), " forces");
  Moments of;
  for (std::size_t i = 0; i < force.size(); ++i) {
    of.sum += force[i];
    of.second += force[i] * moment[i];
  }
  require_argument(of.sum > 0, "half-width: the sum of the forces must be positive, got ", of.sum);
  require_argument(of.second > 0, "half-width: more nodes in the contact are needed");
  return of;
}

/// The square of the half-width of an ellipse by its second moment over its sum.
double square_by_moment(Footprint footprint) { return footprint == Footprint::Strip ? 4 : 2.5; }

}  // namespace

HertzFit fit_hertz(const std::vector<double>& x, const std::vector<double>& pressure, double inner,
                   Footprint footprint) {
  const Line line = fitted(x, pressure, inner, footprint).line;
  return {std::sqrt(line.height), std::sqrt(line.height / line.slope)};
}

std::vector<double> peak_pressure_gradient(const std::vector<double>& x,
                                           const std::vector<double>& pressure, double inner,
                                           Footprint footprint) {
  const auto [line, reach] = fitted(x, pressure, inner, footprint);
  std::vector<double> gradient(x.size(), 0);
  each_fitted(x, pressure, reach, footprint, [&, &line = line](std::size_t i, double counts) {
    gradient[i] = counts * (1 / line.all - line.mean * (x[i] * x[i] - line.mean) / line.square) *
                  pressure[i] / std::sqrt(line.height);
  });
  return gradient;
}

double half_width_of_forces(const std::vector<double>& x, const std::vector<double>& force,
                            Trace trace, Footprint footprint) {
  const Moments of = moments_of(force, moments(x, trace, footprint));
  return std::sqrt(square_by_moment(footprint) * of.second / of.sum);
}

std::vector<double> half_width_gradient(const std::vector<double>& x,
                                        const std::vector<double>& force, Trace trace,
                                        Footprint footprint) {
  std::vector<double> gradient = moments(x, trace, footprint);
  const Moments of = moments_of(force, gradient);
  const double half_width = std::sqrt(square_by_moment(footprint) * of.second / of.sum);
  for (double& one : gradient) one = half_width / 2 * (one / of.second - 1 / of.sum);
  return gradient;
}

}  // namespace signorini

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

}  // namespace

HertzFit fit_hertz(const std::vector<double>& x, const std::vector<double>& pressure,
                   double inner) {
  require(x.size() == pressure.size(), "Hertz fit: ", x.size(), " nodes and ", pressure.size(),
          " pressures");
  require(inner > 0 && inner <= 1, "Hertz fit: inner part must lie in (0, 1], got ", inner);
  double reach = std::numeric_limits<double>::infinity();
  int before = 0;
  HertzFit fit{};
  for (std::size_t round = 0; round <= x.size(); ++round) {
    const Line line = fit_line(x, pressure, reach);
    require(line.nodes >= 2 && line.slope > 0 && line.height > 0, "Hertz fit: the pressure of ",
            line.nodes, " nodes is no ellipse; more nodes in the contact are needed");
    fit = {std::sqrt(line.height), std::sqrt(line.height / line.slope)};
    if (line.nodes == before) break;
    before = line.nodes;
    reach = inner * fit.half_width;
  }
  return fit;
}

double half_width_of_forces(const std::vector<double>& x, const std::vector<double>& force,
                            Trace trace) {
  require(x.size() == force.size(), "half-width: ", x.size(), " nodes and ", force.size(),
          " forces");
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    require(i == 0 || x[i] > x[i - 1], "half-width: nodes must come in rising order");
    sum += force[i];
    moment += force[i] * x[i] * x[i];
  }
  require(sum > 0, "half-width: the sum of the forces must be positive, got ", sum);
  if (trace == Trace::Linear) {
    const auto step = [&](std::size_t i) { return i + 1 < x.size() ? x[i + 1] - x[i] : 0.0; };
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double before = i > 0 ? step(i - 1) : 0.0;
      const double after = step(i);
      const double share = (before + after) / 2;
      if (share > 0)
        moment -= force[i] / share * (before * before * before + after * after * after) / 12;
    }
  }
  require(moment > 0, "half-width: more nodes in the contact are needed");
  return 2 * std::sqrt(moment / sum);
}

}  // namespace signorini

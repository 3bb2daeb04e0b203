/// \file
/// The example solved, and how its contact is read off.
#pragma once
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "closed_form/hertz_fit.hpp"
#include "hertz_scene.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/shown.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {

/// A solved example and what it says of the contact.
struct HertzRun {
  HertzCase now;
  SolvedScene run;
  std::vector<double> x, force, pressure;  ///< at the nodes of the source [mm, N, MPa], x rising
  HertzFit fit;                            ///< q_0 and b of the middle part
  double half_width = 0;                   ///< b of the second moment [mm]
  double last_closed = 0;                  ///< x of the outermost closed pair [mm]
  double q_error = 0, b_error = 0;         ///< of `fit.peak_pressure` and `half_width` [%]
};

/// Lumps all forces of a solution to the nodes of the source, whatever the operator.
/// \param now  the case \param run  its solution \return what it says of the contact
// [reading]
inline HertzRun read_hertz(const HertzCase& now, SolvedScene run) {
  HertzRun out{now, std::move(run), {}, {}, {}, {}};
  const BoundaryForces side = boundary_forces(
      out.run, now.plate_is_source ? Side{"surface", "plate"} : Side{"rim", "disc"});
  std::vector<Eigen::Index> order(static_cast<std::size_t>(side.weight.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return side.position(a, 0) < side.position(b, 0);
  });
  for (const Eigen::Index k : order) {
    out.x.push_back(side.position(k, 0));
    out.force.push_back(now.plate_is_source ? -side.force(k, 1) : side.force(k, 1));
    out.pressure.push_back(out.force.back() / side.weight(k));
  }
  for (const Eigen::Index pair : out.run.solution.contact.active())
    out.last_closed = std::max(out.last_closed, out.run.model.pairs.position(pair, 0));
  out.fit = fit_hertz(out.x, out.pressure);
  out.half_width = half_width_of_forces(
      out.x, out.force, now.mesh.order == MeshOrder::Quadratic ? Trace::Quadratic : Trace::Linear);
  out.q_error = 100 * (out.fit.peak_pressure / hertz_peak_pressure(now.theory()) - 1);
  out.b_error = 100 * (out.half_width / hertz_half_width(now.theory()) - 1);
  return out;
}
// [reading]

/// \param now  the case \return solved and read
inline HertzRun solve_hertz(const HertzCase& now) {
  return read_hertz(now, shown(hertz_scene(now), "Hertz's contact"));
}

/// \param x  a number \return with its sign and three decimals, as in all tables of the chapter
inline std::string percent(double x) { return number(x, "%+.3f"); }

/// Data of a figure. \param out  solved \return x, pressure and its error in percent of q_0, to x = 1.3 mm
inline std::string nodal_pressures(const HertzRun& out) {
  const LineContact theory = out.now.theory();
  Table table({"x", "p", "error"});
  for (std::size_t k = 0; out.x[k] < 1.3; ++k) {
    const double error = out.pressure[k] - hertz_pressure(theory, out.x[k]);
    table.row({out.x[k], out.pressure[k], 100 * error / hertz_peak_pressure(theory)});
  }
  return table.csv("rel 1e-6 abs 1e-6");
}

/// Root mean square of the error of the pressure at the nodes with x < 0.7 b. \param out  solved
/// \return in percent of q_0
inline double pressure_error(const HertzRun& out) {
  const LineContact theory = out.now.theory();
  double sum = 0;
  std::size_t nodes = 0;
  for (; out.x[nodes] < 0.7 * hertz_half_width(theory); ++nodes)
    sum += std::pow(out.pressure[nodes] - hertz_pressure(theory, out.x[nodes]), 2);
  return 100 * std::sqrt(sum / static_cast<double>(nodes)) / hertz_peak_pressure(theory);
}

/// Downward displacement of the node of a body where both touch first. \param run  solved
/// \param body  0 the disc, 1 the plate \return [mm]
inline double sinking(const SolvedScene& run, std::size_t body) {
  const NodeArray& nodes = run.model.bodies[body].mesh.nodes;
  Eigen::Index touching = 0;
  nodes.rowwise().squaredNorm().minCoeff(&touching);
  return -run.solution.displacements[body](touching, 1);
}

}  // namespace signorini

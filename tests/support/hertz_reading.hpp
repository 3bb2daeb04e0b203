// What is read off a solved contact of Hertz, and how far it is from the theory.
#pragma once
#include <algorithm>
#include <vector>

#include "closed_form/hertz_fit.hpp"
#include "signorini/scene/readings.hpp"
#include "support/hertz.hpp"

namespace signorini_test {

/// The pairs from the axis outwards, and two figures of them against the theory.
struct HertzReading {
  std::vector<double> x, force, pressure;
  double peak_error;   ///< of the fitted largest pressure, as a share
  double width_error;  ///< of the half-width of the second moment, as a share
};

/// \param run     half of a contact whose axis is x = 0
/// \param theory  of the whole
/// \param trace   of the elements of the source
inline HertzReading read_hertz(const signorini::SolvedScene& run,
                               const signorini::LineContact& theory,
                               signorini::Trace trace = signorini::Trace::Linear) {
  using namespace signorini;
  HertzReading out;
  std::vector<Eigen::Index> order;
  for (Eigen::Index k = 0; k < run.model.pairs.weight.size(); ++k) order.push_back(k);
  const auto x = run.model.pairs.position.col(0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return x(a) < x(b); });
  for (const Eigen::Index k : order) {
    out.x.push_back(x(k));
    out.force.push_back(run.solution.contact.force(k));
    out.pressure.push_back(run.solution.pressure(k));
  }
  out.peak_error = fit_hertz(out.x, out.pressure).peak_pressure / hertz_peak_pressure(theory) - 1;
  out.width_error = half_width_of_forces(out.x, out.force, trace) / hertz_half_width(theory) - 1;
  return out;
}

/// The same of the example, in mm and N.
inline HertzReading read_hertz(const HertzProblem& problem, const signorini::SolvedScene& run) {
  using signorini::Trace;
  return read_hertz(
      run, problem.theory(),
      signorini::find_element(problem.element).n_nodes > 4 ? Trace::Quadratic : Trace::Linear);
}

/// \return place of the node of a mesh where both bodies touch first
inline Eigen::Index touching_node(const signorini::Mesh& mesh) {
  Eigen::Index node = 0;
  mesh.nodes.rowwise().squaredNorm().minCoeff(&node);
  return node;
}

}  // namespace signorini_test

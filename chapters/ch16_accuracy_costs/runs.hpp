/// \file
/// Hertz's contact solved and timed, and how far its pressures are from the closed form.
#pragma once
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "../../tests/support/hertz.hpp"
#include "signorini/scene/readings.hpp"
#include "support/processor_time.hpp"

namespace ch16 {

using namespace signorini;
using Eigen::Index;
using signorini_test::HertzProblem;
using signorini_test::processor_seconds;

/// \param values  at least one \param share  of them below the result \return the nearest of them
inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(
      std::lround(share * static_cast<double>(values.size() - 1)))];
}

/// Refined meshes of one family. \param cells  of the disc on 1.3 half-widths
/// \param on_plate  of the plate there; as many: the nodes meet \return meshes
inline HertzMeshSpec meshes(Index cells, Index on_plate) {
  HertzMeshSpec spec;
  spec.disc_cells = spec.disc_layers = spec.plate_layers = cells;
  spec.plate_cells = on_plate;
  spec.disc_rows = spec.plate_rows = cells * 3 / 4;
  return spec;
}

/// Pressures at the nodes of the disc.
struct Pressures {
  std::vector<double> x, pressure;  ///< x rising [mm, MPa]
};

/// \param run  solved, the disc its source \return what its nodes carry, whatever the operator
inline Pressures pressures(const SolvedScene& run) {
  const BoundaryForces side = boundary_forces(run, {"rim", "disc"});
  std::vector<Index> order(static_cast<std::size_t>(side.weight.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return side.position(a, 0) < side.position(b, 0); });
  Pressures out;
  for (const Index k : order) {
    out.x.push_back(side.position(k, 0));
    out.pressure.push_back(side.force(k, 1) / side.weight(k));
  }
  return out;
}

/// The error that most of this chapter pays for.
/// \param at  nodes \param theory  of the same load \return root mean square over x < 0.7 b, % of q0
inline double pressure_error(const Pressures& at, const LineContact& theory) {
  double sum = 0;
  std::size_t k = 0;
  for (; at.x[k] < 0.7 * hertz_half_width(theory); ++k)
    sum += std::pow(at.pressure[k] - hertz_pressure(theory, at.x[k]), 2);
  return 100 * std::sqrt(sum / static_cast<double>(k)) / hertz_peak_pressure(theory);
}

/// \param ledger  of a run \return all operations that it counted
inline double operations(const Ledger& ledger) {
  double sum = 0;
  for (const char* phase : {"factor/numeric", "condensation", "refinement"})
    sum += static_cast<double>(ledger.counted(phase, "operations"));
  return sum;
}

}  // namespace ch16

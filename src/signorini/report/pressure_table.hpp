/// \file
/// What contact did, pair by pair, and in sum.
#pragma once
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Sums over all pairs.
struct Resultants {
  Eigen::Vector2d force;  ///< of the obstacle on the body [force]
  double moment;          ///< of these forces about the origin [force length]
  double closed_weight;   ///< share of the boundary that belongs to closed pairs [length^2]
  double peak_pressure;   ///< [force/length^2]
};

/// Sums the contact forces of a solution.
[[nodiscard]] Resultants resultants(const Gaps& gaps, const Solution& solution);

/// The table as comma separated text: x, y, gap, pressure, force, status, one line per pair.
///
/// `status` is `closed` or `open`. Lines come in the order of the boundary; the first line names the
/// columns.
/// Comments in front of it give the resultants.
/// \param tolerance  if not empty, goes in front as the comment `# tolerance <tolerance>`
[[nodiscard]] std::string pressure_csv(const Gaps& gaps, const Solution& solution,
                                       const std::string& tolerance = "");

}  // namespace signorini

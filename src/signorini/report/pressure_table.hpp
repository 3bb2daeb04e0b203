/// \file
/// What contact did, pair by pair, and in sum.
#pragma once
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Sums over all pairs.
struct Resultants {
  Eigen::Vector2d force;  ///< of the targets on the sources [force]
  double moment;          ///< of these forces about the origin [force length], anticlockwise > 0
  double closed_weight;   ///< share of the boundary that belongs to closed pairs [length^2]
  double peak_pressure;   ///< largest of a pair [force/length^2], compression > 0
};

/// Sums the contact forces of a solution, friction included, applied where the pairs are before loading.
/// \param pairs     of the model, `n_c` pairs
/// \param solution  of the model
/// \return the sums, all 0 without contact
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] Resultants resultants(const Pairs& pairs, const Solution& solution);

/// The table as comma separated text: x, y, gap, pressure, force, status, one line per pair.
///
/// `status` is `closed` or `open`. Lines come in the order of the boundary, with 10 digits; the
/// first line names the columns. Comments in front of it give the notes of the solution and the resultants.
/// \param pairs      of the model, `n_c` pairs
/// \param solution   of the model
/// \param tolerance  if not empty, goes in front as the comment `# tolerance <tolerance>`
/// \return the text
/// \throws std::invalid_argument if the problem is not solved
[[nodiscard]] std::string pressure_csv(const Pairs& pairs, const Solution& solution,
                                       const std::string& tolerance = "");

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Stresses of elements where they are best.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "addons/estimate/fields.hpp"

namespace signorini {

/// Stresses inside cells, so many per cell, at the same places for all fields.
struct StressSamples {
  static constexpr Eigen::Index most = 4;  ///< of a cell
  std::vector<Eigen::Vector2d> place;      ///< `most` per cell [length]
  /// A row each: the components of the first field, then of the second, ... [force/length^2]
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> value;
  std::vector<int> count;  ///< per cell, up to `most`
};

/// Takes of cells of two nodes per side the mean of their strain points, as at the middle; of those of three nodes per side
/// the stresses of their displacements at the 2 x 2 points of the square, at the 3 of the triangle.
/// \param fields   any
/// \param strains  element_strains() of them
/// \return stresses
[[nodiscard]] StressSamples sampled(const PrimalAndDuals& fields, const ElementStrains& strains);

}  // namespace signorini

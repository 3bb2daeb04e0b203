/// \file
/// Rings and discs with a hole, graded along the radius.
#pragma once
#include <Eigen/Core>
#include <string>

#include "signorini/mesh/ring.hpp"

namespace signorini {

/// The body between two concentric circles and how it is divided.
struct AnnulusSpec {
  std::string name = "annulus";                      ///< what messages call it
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of both circles [length]
  double inner_radius = 1;                           ///< [length], positive
  double outer_radius = 2;                           ///< [length], above the inner radius
  Eigen::Index cells_angle = 1;                      ///< cells along the angle, at least 1
  Eigen::Index cells_radius = 1;                     ///< cells along the radius, at least 1
  double grading = 1;            ///< outermost / innermost cell along the radius, positive [-]
  Eigen::VectorXd rays = {};     ///< `cells_angle + 1` directions [rad]; even ones if empty
  Sector sector = Sector::Full;  ///< how much of it
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell; 8: midpoints lie on the circles
};

/// Divides a ring into cells, numbered along the rays first.
///
/// Boundaries: `inner` and `outer`; of a half or a quarter also `symmetry` on the x axis, of a
/// quarter also `symmetry_y` on the y axis. All keep the body on the left.
/// \param spec  the ring
/// \return a mesh that passes check_mesh() unless cells are thinner than rounding of the positions
/// \throws std::invalid_argument unless radii, counts, grading and rays are as described
[[nodiscard]] Mesh make_annulus(const AnnulusSpec& spec);

/// The grading with which all cells along the radius have the same shape: each cell is longer than
/// the last by the same factor as the radius.
/// \param outer_over_inner  ratio of the radii, above 1 [-]
/// \param cells_radius      cells along the radius, at least 1
/// \return outermost / innermost cell [-]
/// \throws std::invalid_argument if a number is out of range
[[nodiscard]] double similar_cells(double outer_over_inner, Eigen::Index cells_radius);

}  // namespace signorini

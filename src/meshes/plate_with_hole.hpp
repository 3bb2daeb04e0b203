/// \file
/// Rectangular plates with a round hole in the middle.
#pragma once
#include <Eigen/Core>
#include <string>

#include "meshes/ring.hpp"

namespace signorini {

/// A rectangle with a round hole in its middle and how it is divided.
struct PlateWithHoleSpec {
  std::string name = "plate";                           ///< what messages call it
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();     ///< of hole and plate [length]
  double hole_radius = 1;                               ///< [length], positive
  Eigen::Vector2d size = Eigen::Vector2d::Constant(4);  ///< of the whole plate, > the hole [length]
  Eigen::Index cells_angle = 8;                         ///< cells along the hole, more than corners
  Eigen::Index cells_radius = 1;  ///< cells from the hole to the outer sides, at least 1
  double grading = 1;             ///< last (outer) cell of a ray / first, positive; geometric [-]
  Eigen::VectorXd rays = {};      ///< `cells_angle + 1` directions [rad]; even ones if empty
  Sector sector = Sector::Full;   ///< how much of the plate
  MeshOrder order = MeshOrder::Linear;  ///< 4 or 8 nodes per cell; 8: midpoints lie on the hole
};

/// Divides the plate along rays from the hole to the outer sides, numbered along the rays first.
///
/// Each corner of the plate takes the outer end of the nearest ray, of two equally near ones the
/// first; its inner end stays. Boundaries, with the body on the left: `hole`, `right`, `top`,
/// `left`, `bottom`, as far as the sector has them; of a half or a quarter also `symmetry` on the x
/// axis, of a quarter also `symmetry_y` on the y axis.
/// \param spec  the plate
/// \return a mesh; check_mesh() finds cells that few or uneven rays have folded
/// \throws std::invalid_argument unless sizes, counts, grading and rays are as described, or if two
///   corners want the same ray or one wants the first or last ray
[[nodiscard]] Mesh make_plate_with_hole(const PlateWithHoleSpec& spec);

}  // namespace signorini

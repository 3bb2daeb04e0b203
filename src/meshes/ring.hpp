/// \file
/// Cells between an inner and an outer line: rings and discs with a hole, and what plates with one share with them.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "meshes/block.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// How much of a body around a hole is meshed, counter-clockwise from the positive x axis.
enum class Sector {
  Quarter,  ///< x and y not below the centre: two lines of symmetry
  Half,     ///< y not below the centre: one line of symmetry
  Full      ///< all the way round
};

/// \param sector  of a body around a hole
/// \return the angle it spans [rad]
[[nodiscard]] double opening(Sector sector);

/// Directions of the rays from the centre and between them.
/// \param rays    what the user gave: directions [rad], or none
/// \param cells   number of cells along the angle
/// \param sector  that they fill
/// \return `2 cells + 1` directions [rad]: the rays, even ones if none were given, and their
///   bisectors
/// \throws std::invalid_argument unless there are `cells + 1` rays that increase from 0 to
///   opening(), each less than half a turn from the next
[[nodiscard]] Eigen::VectorXd ray_directions(const Eigen::VectorXd& rays, Eigen::Index cells,
                                             Sector sector);

/// Rays that divide each quadrant evenly, counter-clockwise from the positive x axis.
/// \param cells  number of cells in each of one, two or four quadrants, at least 1
/// \return one direction more than cells [rad]
/// \throws std::invalid_argument if a quadrant has no cell or their number fits no sector
[[nodiscard]] Eigen::VectorXd rays_by_quadrant(const std::vector<Eigen::Index>& cells);

/// Unit vector of a direction; exact on the axes.
/// \param angle  from the x axis [rad]
/// \return (cos, sin), with components below rounding set to 0
[[nodiscard]] Eigen::RowVector2d unit_vector(double angle);

/// Straight rays from an inner to an outer line, divided into cells, numbered along the rays first.
///
/// The boundaries, counter-clockwise with the body on the left: `symmetry` (the first ray, outwards), `outer`,
/// `symmetry_y` or, of a half, again `symmetry` (the last ray, inwards), `inner`. A closed ring has only `outer`
/// and `inner`.
/// \param name    what messages call it
/// \param inner   `2 n + 1` points of the inner line, even ones on rays, odd ones between [length]
/// \param outer   `2 n + 1` points of the outer line [length]
/// \param steps   `m + 1` places of the nodes along each ray, from 0 (inner) to 1 (outer) [-]
/// \param sector  Full joins the last ray to the first
/// \param order   odd points are used by quadratic cells only
/// \return `n x m` cells
[[nodiscard]] Mesh make_ring_of_rays(const std::string& name, const NodeArray& inner,
                                     const NodeArray& outer, const Eigen::VectorXd& steps,
                                     Sector sector, MeshOrder order);

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

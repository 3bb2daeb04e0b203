/// \file
/// Rigid obstacles: where they are, and how far a point is from them.
///
/// An obstacle is given by a function, not by a mesh: a gap and a normal for each point. That is
/// all that a contact with a rigid body needs, and the normal comes without the steps that sides of
/// a mesh would have.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// What a point of the body sees of an obstacle.
struct ObstacleContact {
  double gap;              ///< [length], open > 0, overlap < 0
  Eigen::Vector2d normal;  ///< unit vector out of the obstacle, towards the body [-]
};

/// A rigid obstacle: the target that has no mesh. In axial symmetry it goes round the axis x = 0 like the body: a
/// half-plane whose normal is along y is a flat, an inclined one a cone, one whose normal is along x a tube; a disc centred
/// on the axis is a sphere, one beside it a torus.
struct Obstacle {
  std::string name;                                             ///< what messages call it
  std::function<ObstacleContact(const Eigen::Vector2d&)> look;  ///< seen from a point [length]
  /// Whether the gap is linear in what moves a point, along the normal at its place in the mesh: as of a half plane it is,
  /// and of pin_in_hole() it is meant to be
  bool linear = false;
  /// Whether the gap is that of a place in the mesh, wherever the place moves: no obstacle for bodies that move
  bool of_mesh = false;
};

/// Everything behind a line.
/// \param point   on the line [length]
/// \param normal  out of the obstacle, of any length > 0
/// \return the obstacle; gap and normal are exact
/// \throws ProblemError if the normal has no length or a number is not finite
[[nodiscard]] Obstacle half_plane(const Eigen::Vector2d& point, const Eigen::Vector2d& normal);

/// A disc; the body lies outside of it.
/// \param centre  [length]
/// \param radius  [length], positive
/// \return the obstacle, with gap = distance from the centre - radius
/// \throws ProblemError if the radius is not positive or a number not finite; when looked at, if
///   the point is the centre, where no normal exists
[[nodiscard]] Obstacle disc(const Eigen::Vector2d& centre, double radius);

/// A hole; the body lies inside of it, as a shaft in its bearing.
/// \param centre  [length]
/// \param radius  [length], positive
/// \return the obstacle, with gap = radius - distance from the centre
/// \throws ProblemError as disc()
[[nodiscard]] Obstacle hole(const Eigen::Vector2d& centre, double radius);

/// A round pin in a round hole with little clearance, seen from the hole:
/// radial normals and the gap
/// \f[ g = c - n \cdot s, \f]
/// with the clearance c, the shift s of the pin and the radial direction n. It is linear in c and s,
/// as linear elasticity is in the displacements, and differs from the gap of disc() by
/// \f$ |s|^2 / 2 \f$ over the radius at most.
/// \param hole_centre  about which the body's hole is round [length]
/// \param clearance    radius of the hole less radius of the pin [length]
/// \param shift        of the pin's centre from the hole's [length]; as long as the clearance: they
///   touch
/// \return the obstacle
/// \throws ProblemError if a number is not finite; when looked at, if the point is the centre
[[nodiscard]] Obstacle pin_in_hole(const Eigen::Vector2d& hole_centre, double clearance,
                                   const Eigen::Vector2d& shift);

/// Everything below the curve y = f(x).
///
/// The gap is measured along the normal of the curve at the same x:
/// \f[ g = n_y\,(y - f(x)), \quad n = (-f', 1)/\sqrt{1 + f'^2}, \f]
/// \PaperEq{XuanLi2002, 1}, with the sign of our normal, and
/// \PaperEq{XuanLi2002, 2} with its second division by the root taken out (a misprint, see chapter
/// 1). It is the distance up to terms of the order gap^2 times the curvature.
/// \param height  f(x) [length]
/// \param slope   f'(x) [-]
/// \return the obstacle
/// \throws std::invalid_argument if a function is missing
/// \throws ProblemError, when looked at, if height or slope is not finite there
[[nodiscard]] Obstacle profile(const std::function<double(double)>& height,
                               const std::function<double(double)>& slope);

}  // namespace signorini

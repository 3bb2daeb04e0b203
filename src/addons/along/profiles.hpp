// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Rigid obstacles that are given by points: a polyline, or a smooth curve through them.
///
/// Who walks from the first point to the last has the body on the left and the obstacle on the right. So of a floor the points run
/// to the right, and normals point to the left of the walk. Beyond its ends an open profile goes on straight.
///
/// The gap is the distance from the closest place, > 0 on the left. It is that of half_plane() where a profile is straight, and
/// differs from that of a curve, whose points are h apart, by its curvature times h^2/8 at most for a polyline. A natural spline
/// differs from it by about h^4 a few points away from its ends; in the last pieces, where it is straight at the end, by up to
/// 0.4 of what a polyline errs by. In front of a corner that points to the body all look at the corner, and normals turn around it;
/// a spline has none.
#pragma once
#include <Eigen/Core>

#include "signorini/contact/obstacle.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// A profile of straight lines.
/// \param points  `n x 2`, n >= 2, in the order of the walk [length]; if the first is the last, the profile is closed
/// \return the obstacle, with exact gaps
/// \throws ProblemError for fewer points, two in a row that are the same, or numbers that are not finite
[[nodiscard]] Obstacle polyline(const NodeArray& points);

/// A smooth profile: the natural cubic spline over the lengths of the chords, so that it is straight at its ends.
/// \param points  `n x 2`, n >= 2, as of polyline(), not closed [length]
/// \return the obstacle; the closest place is found by Newton's method, from the closest of eight chords for each piece
/// \throws ProblemError as polyline(), or if the first point is the last
[[nodiscard]] Obstacle spline(const NodeArray& points);

}  // namespace signorini

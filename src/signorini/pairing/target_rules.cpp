// # Which place a point faces
//
// On a smooth curve the closest place is clear: the line to it is normal to the curve. A mesh is a
// chain of straight sides or parabolas, with a vertex at each node. Two things go wrong there.
// Above a vertex that sticks out lies a wedge of points whose line is normal to no side. Above one
// that recedes lies a line of points with two closest places. Taken literally, such points would
// have no pair or two. Where nodes face nodes, as in the most common meshes, rounding would decide.
//
// So a vertex is a place of its own, with all normals between those of its two sides (the normal
// cone of convex analysis). A point in the wedge takes the normal along its line to the vertex,
// and the gap is the distance to it. A point with two closest places on sides that meet is given
// their vertex, with a normal in between.

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/pairing/target_query.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

/// Sides are neighbours if one begins at the node where the other ends.
Index TargetSearch::neighbour(Index number, int end) const {
  return (end < 0 ? before_ : after_)[static_cast<std::size_t>(number)];
}

/// A line of symmetry cuts a curve at a vertex and leaves one half. The vertex then is an end, and
/// a point on the line of symmetry lies just in the wedge that the other half would have made. So
/// the boundary is thought to turn on by the angle of its last vertex. More than 45 degrees is a
/// corner of the body; nothing follows.
Vector2d TargetSearch::normal_beyond(Index number, int end) const {
  const Vector2d here = side(number).normal(end);
  const Index other = neighbour(number, -end);
  if (other < 0) return here;
  // From one normal to the other the boundary turns at the far end of the side; as far again.
  const Vector2d a = side(other).normal(end), b = side(number).normal(-end);
  const double cosine = a.dot(b), sine = cross(a, b);
  if (cosine < corner_cosine) return here;  // an edge, not a curve in sides
  return {cosine * here.x() - sine * here.y(), sine * here.x() + cosine * here.y()};
}

/// A side that looks away from the point is no neighbour: the far side of a thin sheet begins
/// there.
bool TargetSearch::next_faces(Index number, int end, const Query& query) const {
  const Index next = neighbour(number, end);
  return next >= 0 && faces(side(next).normal(-end), query.normal);
}

/// Rounding puts a place that should be the vertex a little before it, on one side or on both.
/// Within rounding of an end it is set to the end, or the two sides would disagree on which of them
/// the point is above.
double TargetSearch::projection(Index number, const Query& query) const {
  const SideCurve& curve = side(number);
  const double xi = curve.closest(query.x);
  const int end = xi < 0 ? -1 : 1;
  // By rounding the feet on two sides may lie on both sides of their vertex, or on neither.
  return (curve.point(xi) - curve.point(end)).norm() <= query.rounding ? end : xi;
}

/// The closest place of a side is one of its ends: is the point above the vertex, above the next
/// side, or beyond the boundary? If the next side faces the point, it decides: either it has the
/// same vertex as its closest place, or a nearer one. At the end of a boundary, rounding is
/// forgiven and the wedge is looked at.
bool TargetSearch::resolve_end(Candidate& candidate, const Query& query) const {
  const SideCurve& curve = side(candidate.side);
  const int end = candidate.xi < 0 ? -1 : 1;
  if (next_faces(candidate.side, end, query)) {
    candidate.vertex = end;
    return projection(neighbour(candidate.side, end), query) == -end;  // else it is nearer
  }
  const double xi = curve.continued(query.x, end);
  if (std::abs(xi) <= 1 + end_tolerance)
    candidate.xi = xi;
  else if (end * cross(normal_beyond(candidate.side, end), query.x - curve.point(end)) <= 0)
    candidate.vertex = end;
  else
    return false;
  return true;
}

/// One side is asked, in four steps: its closest place, whether that place faces the point, whether
/// an end is meant, and how far the point lies behind. A point that lies behind it by more than its
/// cell is deep belongs to another side, or is buried; how deep is kept for the message.
void TargetSearch::consider(Index number, Query& query) const {
  const SideCurve& curve = side(number);
  Candidate candidate{number, projection(number, query), 0, 0};
  if (!faces(curve.normal(candidate.xi), query.normal)) return;
  if (std::abs(candidate.xi) == 1 && !resolve_end(candidate, query)) return;
  const Vector2d arm = query.x - curve.point(candidate.xi);
  candidate.distance = arm.norm();
  if (arm.dot(curve.normal(candidate.xi)) < -depth(number)) {
    query.inside = query.inside || inside_body(query.x);
    query.pass(candidate.distance);
    return;
  }
  query.add(candidate);
}

/// Where bodies hardly move, a gap is less than the rounding of the sides that it lies between.
Projection TargetSearch::placed(Index number, double xi, const Vector2d& normal,
                                const Query& query) const {
  Projection found{true, number, -1, xi, side(number).point(xi), normal};
  found.gap = query.x.way_from(found.point).rounded.dot(normal);
  return found;
}

/// With the arm \f$r\f$ from the vertex to the point and the normals \f$n_1, n_2\f$, we want
/// \f$n \parallel (1-s)\,n_1 + s\,n_2\f$ along \f$r\f$, or against it if the point lies inside:
/// \f$r\times n = 0\f$ gives \f$s = a/(a-b)\f$ with \f$a = r\times n_1\f$ and
/// \f$b = r\times n_2\f$. Outside of the wedge \f$s\f$ ends at 0 or 1.
Projection TargetSearch::at_vertex(Index number, int end, const Query& query) const {
  const Index next = neighbour(number, end);
  const bool between = next_faces(number, end, query);
  const Vector2d arm = query.x - side(number).point(end);
  const Vector2d one = side(number).normal(end);
  const Vector2d two = between ? side(next).normal(-end) : normal_beyond(number, end);
  const double a = cross(arm, one), b = cross(arm, two);
  // The share of the second normal in the one along the arm. An arm that rounding cannot tell from
  // the middle has half: the direction of a short one is mostly rounding, which would hold a ring
  // that turns in another.
  const bool middle = std::min(std::abs(a - b), std::abs(a + b)) <= query.rounding;
  const double share = middle ? 0.5 : std::clamp(a / (a - b), 0.0, 1.0);
  const Vector2d normal = ((1 - share) * one + share * two).normalized();
  if (!between) return placed(number, end, normal, query);
  Projection found = placed(std::min(number, next), number < next ? end : -end, normal, query);
  found.next = std::max(number, next);  // both sides turn what is at their vertex
  return found;
}

/// Within a side, place and normal are those of the curve.
Projection TargetSearch::on_side(const Candidate& best, const Query& query) const {
  return placed(best.side, best.xi, side(best.side).normal(best.xi), query);
}

/// All that is within rounding of the nearest is a candidate, in the order of the boundary, so that
/// the answer does not depend on the order of the search. A vertex, or the common vertex of two
/// sides that meet, counts more than a place within a side. The last rule is for lines of symmetry:
/// a point on the line that halves the wedge at the end of a boundary gets the normal along this
/// line.
Projection TargetSearch::chosen(Query& query) const {
  std::vector<Candidate>& all = query.candidates;
  if (all.empty()) {
    Projection none;
    none.inside = query.inside;
    none.penetration = query.penetration;
    return none;
  }
  std::sort(all.begin(), all.end(),
            [](const Candidate& a, const Candidate& b) { return a.side < b.side; });
  for (const Candidate& one : all) {
    if (one.vertex != 0) return at_vertex(one.side, one.vertex, query);
    for (const Candidate& two : all)
      if (two.side != one.side && two.side == neighbour(one.side, 1))
        return at_vertex(one.side, 1, query);
  }
  const Candidate& best = all.front();
  for (const int end : {-1, 1}) {
    const Vector2d arm = query.x - side(best.side).point(end);
    const Vector2d middle =
        (side(best.side).normal(end) + normal_beyond(best.side, end)).normalized();
    if (!next_faces(best.side, end, query) && std::abs(cross(arm, middle)) <= query.rounding)
      return at_vertex(best.side, end, query);
  }
  return on_side(best, query);
}

/// Take a plate that lies on a block and hangs over its edge, tilted by a fifth of a degree. The
/// side of the block then faces the plate, and the nearest place of what hangs over is the edge, at
/// a distance along the plate. Such distances say nothing of overlap. In the mean of an edge they
/// would count, with weights that are negative at its other end: with edges of 0.67 on a block of
/// width 1 the plate would be pressed with 26.3 in the place of 7.1.
///
/// So a corner ends the target for such a point. Where the first one lies, on the way along the
/// boundary from the side that was found:
std::pair<Index, Index> TargetSearch::next_corner(Index from, int end) const {
  Index here = from, next = neighbour(from, end);
  while (next >= 0 && next != from) {
    const Vector2d one = side(here).normal(end), two = side(next).normal(-end);
    if (one.dot(two) < corner_cosine && end * cross(one, two) > 0) return {here, next};
    next = neighbour(here = next, end);
  }
  return {-1, -1};
}

/// A point that hangs over does not face the side behind the corner if it does so only by a tilt of
/// less than 10 degrees. A point hangs over if it lies above the near side, or no deeper below it
/// than the cell there. A tooth in the middle of the block lies deeper, though it looks at the side
/// of the block as well. Places at the corner are left if their normal leans by less than 50 degrees.
bool TargetSearch::beyond_corner(const Projection& place, const Vector2d& source_normal) const {
  const auto faced = [&](const Vector2d& normal) { return -normal.dot(source_normal); };
  if (faced(place.normal) > facing_cosine) return false;
  for (const int end : {-1, 1}) {
    const auto [here, next] = next_corner(place.side, end);
    if (next < 0) continue;
    Vector2d near = side(here).normal(end), far = side(next).normal(-end);
    const bool swapped = faced(far) > faced(near);
    if (swapped) std::swap(near, far);
    if (faced(near) <= facing_cosine || faced(far) >= grazing_cosine) continue;
    const Vector2d arm = place.gap * place.normal + (place.point - side(here).point(end));
    const double deepest = depth(swapped ? next : here);
    if (near.dot(arm) + deepest > -grazing_cosine * arm.norm()) return true;
  }
  return false;
}

/// For a rectangle it is the height of the cell. Small displacements cannot bring a point deeper.
double TargetSearch::depth(Index number) const {
  const CellSide& own = boundary(*mesh_, boundary_)[static_cast<std::size_t>(number)];
  const SideCurve& curve = side(number);
  const Vector2d chord = (curve.point(1) - curve.point(-1)).normalized();
  double depth = 0;
  const int n = mesh_->corners(own.cell);
  for (int k = 2; k < n; ++k) {
    const Index corner = mesh_->cells(own.cell, (own.side + k) % n);
    const Vector2d arm = mesh_->nodes.row(corner).transpose() - curve.point(-1);
    depth = std::max(depth, cross(chord, arm));
  }
  return depth;
}

/// The point is in a cell if it lies to the left of all its sides; sides that bulge are taken as
/// straight. This is only asked for points that are too deep for the side they face, so that a loop
/// over all cells is cheap enough.
bool TargetSearch::inside_body(const AnchoredPoint& x) const {
  for (Index cell = 0; cell < mesh_->n_cells(); ++cell) {
    bool inside = true;
    const int n = mesh_->corners(cell);
    for (int k = 0; k < n && inside; ++k) {
      const Vector2d a = mesh_->nodes.row(mesh_->cells(cell, k)).transpose();
      const Vector2d b = mesh_->nodes.row(mesh_->cells(cell, (k + 1) % n)).transpose();
      inside = cross(b - a, x - a) >= 0;
    }
    if (inside) return true;
  }
  return false;
}

}  // namespace signorini

// # Where a normal jumps
//
// Along an edge of the source the gap is continuous and its normal is not: where the edge passes from one side of
// the target to the next, the force that a unit of length puts on the nodes changes from \f$ f_1 \f$ to \f$ f_2 \f$. As
// long as nothing moves, that is no matter for an integral that is cut there. If the bodies move, the place itself moves, by
// \f$ ds \f$, and the nodes get
//
// \f[ dF = (f_1 - f_2)\,ds, \qquad f_k = \lambda\,\frac{\psi}{w}\,N_k^T \f]
//
// more, with the row \f$ N_k \f$ of the place on the side k. So two such rows are kept, and the rest is up to
// those who let bodies move. Flat targets have jumps of nothing, which cost little.
//
// A groove has the corner (1, 0) and flanks that rise by a half, and an edge lies 1 above the corner. It passes from flank to flank at
// \f$ x = 1 \f$, where both lie 0.894 away, and the normals are \f$ (0.447, 0.894) \f$ and
// \f$ (-0.447, 0.894) \f$. If the groove goes by 0.1 to the right, so does the place.

#include "addons/motion/jumps.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// Whether two places lie on sides that meet, and neither at a vertex, where a normal turns and does not jump.
bool on_two_sides(const TargetSearch& search, const Projection& one, const Projection& two) {
  if (one.side == two.side || std::abs(one.xi) == 1 || std::abs(two.xi) == 1) return false;
  const std::vector<Index>& first = search.side(one.side).nodes();
  const std::vector<Index>& second = search.side(two.side).nodes();
  return first.front() == second.back() || first.back() == second.front();
}

/// The place of a given side that a point faces, whichever other side may be as near.
Projection place_on(const TargetSearch& search, Index side, const AnchoredPoint& x) {
  const SideCurve& curve = search.side(side);
  Projection place;
  place.found = true;
  place.side = side;
  place.xi = curve.closest(x);
  place.point = curve.point(place.xi);
  place.normal = curve.normal(place.xi);
  place.gap = (x - place.point).dot(place.normal);
  return place;
}

/// Adds a jump from one side of the target to the other, at a place of an edge that counts by a part of it. It is a jump
/// of both pairs that have a dual function there, one of them often of negative sign.
void add_jump(const SampledEdge& of, double xi, double part, Index one, Index other,
              const Interface& interface, std::vector<KeptJump>& jumps) {
  // The dual functions are those by which the points of the edge count.
  std::vector<EdgePoint> covered;
  for (const FacingPoint& point : of.samples.facing) covered.push_back(point.at);
  const DualBasis basis = dual_basis(covered, of.samples.share);
  const SourceEdge& edge = of.edge;
  const AnchoredPoint x = edge.side->point(xi);
  const double s = (2 * xi - edge.begin - edge.end) / (edge.end - edge.begin);
  const Vector2d psi = part * interface.depth.part(x.position().x()) * basis.value(s);
  for (const Index i : {0, 1}) {
    if (basis.mean(i) == 0) continue;
    const auto facing = [&](Index side) {
      const Index node = edge.nodes[static_cast<std::size_t>(i)];
      return kept(interface, {node, edge.side, xi, place_on(interface.search, side, x)}, psi(i));
    };
    jumps.push_back({facing(one), facing(other), edge.side->tangent(xi).normalized()});
  }
}

/// The cut itself may be a node of the source, which is usual where two meshes match. Then the last point of an edge and the
/// first one of the next face two sides. Whether one edge follows another one, and faces another side from its beginning on.
bool jumps_between(const SampledEdge& last, const SampledEdge& next, const TargetSearch& search) {
  return last.edge.nodes[1] == next.edge.nodes[0] && !last.samples.facing.empty() &&
         !next.samples.facing.empty() &&
         on_two_sides(search, last.samples.facing.back().target,
                      next.samples.facing.front().target);
}

}  // namespace

/// A jump between two points of an edge lies in the cut between their segments: segments end where normals of the
/// target's nodes meet the source, and sides change nowhere else. A closed source begins where it ends, so the last
/// edge comes before the first one, unless it ends elsewhere.
std::vector<KeptJump> jumps_along(const std::vector<SampledEdge>& edges,
                                  const Interface& interface) {
  std::vector<KeptJump> jumps;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SampledEdge& last = edges[(k > 0 ? k : edges.size()) - 1];
    const SampledEdge& here = edges[k];
    const std::vector<FacingPoint>& points = here.samples.facing;
    if (jumps_between(last, here, interface.search)) {
      const Index before = last.samples.facing.back().target.side;
      const Index behind = points.front().target.side;
      add_jump(last, last.edge.end, 0.5, before, behind, interface, jumps);
      add_jump(here, here.edge.begin, 0.5, before, behind, interface, jumps);
    }
    for (std::size_t q = 1; q < points.size(); ++q) {
      const Projection& before = points[q - 1].target;
      const Projection& behind = points[q].target;
      if (!on_two_sides(interface.search, before, behind)) continue;
      const auto cut = std::upper_bound(here.cuts->begin(), here.cuts->end(), points[q - 1].xi);
      if (cut != here.cuts->end() && *cut <= points[q].xi)
        add_jump(here, *cut, 1, before.side, behind.side, interface, jumps);
    }
  }
  return jumps;
}

}  // namespace signorini

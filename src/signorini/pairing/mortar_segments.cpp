// # Where edges are cut
//
// The gap along an edge of the source is smooth as long as its points face one side of the target.
// Where they pass on to the next side it has a kink, and Gauss rules are made for polynomials. So
// the edge is cut at the kinks, and each *segment* is integrated alone. On straight sides gap
// times weight function is of degree 2 there, and two points are exact.
//
// A groove has the corners (0, 1), (1, 0.5), (2, 1), and a straight edge from (0, 1) to (2, 1)
// lies above it. The distance to the flanks is 0 at both ends and largest in the middle; its mean
// is 0.2236. On the whole edge two points give 0.189, three 0.278 and six 0.219. With cuts two
// points are enough.

#include "signorini/pairing/mortar_segments.hpp"

#include <algorithm>
#include <map>

#include "signorini/fem/element.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// Cuts that are closer than this are one, up to rounding; the sliver joins the next segment [-].
constexpr double sliver = 1e-12;

/// Sorts cuts and drops those that would leave a sliver.
///
/// A sliver has no length, but each of its points would be projected.
void tidy(std::vector<double>& cuts) {
  std::sort(cuts.begin(), cuts.end());
  std::vector<double> kept;
  for (const double cut : cuts)
    if (cut > (kept.empty() ? -1 : kept.back()) + sliver && cut < 1 - sliver) kept.push_back(cut);
  cuts = kept;
}

}  // namespace

/// A kink belongs to a node of the target. We stand on the node, look along a normal, and mark
/// where the line meets the source. At a vertex there are two normals and three lines: along the
/// first normal, along the second, and midway. We do not ask whether the vertex sticks out or
/// recedes. A cut too many does no harm.
std::vector<std::vector<double>> segment_cuts(const Interface& interface) {
  const TargetSearch source(interface.source.mesh, interface.source.boundary);
  const TargetSearch& target = interface.search;
  std::vector<std::vector<double>> cuts(static_cast<std::size_t>(source.n_sides()));
  const auto cut = [&](const AnchoredPoint& from, const Vector2d& normal) {
    const Projection seen = source.along(from, normal);
    if (seen.found) cuts[static_cast<std::size_t>(seen.side)].push_back(seen.xi);
  };
  std::map<Index, Vector2d> before;  // normal of the side that ends, or begins, at a node
  for (Index s = 0; s < target.n_sides(); ++s) {
    const SideCurve& side = target.side(s);
    for (const int end : {-1, 1}) {
      const Vector2d normal = side.normal(end);
      cut(side.point(end), normal);
      const auto [other, first] =
          before.emplace(end < 0 ? side.nodes().front() : side.nodes().back(), normal);
      if (!first) cut(side.point(end), (other->second + normal).normalized());
    }
  }
  for (std::vector<double>& list : cuts) tidy(list);
  return cuts;
}

std::vector<SourceEdge> edges_of(const SideCurve& side) {
  const std::vector<Index>& nodes = side.nodes();
  if (nodes.size() == 2) return {{&side, {nodes[0], nodes[1]}, -1, 1}};
  return {{&side, {nodes[0], nodes[1]}, -1, 0}, {&side, {nodes[1], nodes[2]}, 0, 1}};
}

/// A Gauss point \f$\xi_g\f$ of the segment from \f$a\f$ to \f$b\f$ lies at
/// \f$\xi = \tfrac12(a+b) + \tfrac12(b-a)\,\xi_g\f$ of the side, and at a place \f$s\f$ of its own
/// on the edge, at which weight functions are taken.
EdgeSamples sample_edge(const SourceEdge& edge, const Interface& interface,
                        const std::vector<double>& cuts, int points) {
  std::vector<double> ends;
  for (const double cut : cuts)
    if (cut > edge.begin + sliver && cut < edge.end - sliver) ends.push_back(cut);
  ends.push_back(edge.end);
  EdgeSamples samples;
  double begin = edge.begin;
  for (const double end : ends) {
    const double half = 0.5 * (end - begin);
    for (const GaussPoint& gauss : gauss_line(points)) {
      const double xi = 0.5 * (begin + end) + half * gauss.xi;
      const double s = (2 * xi - edge.begin - edge.end) / (edge.end - edge.begin);
      const AnchoredPoint place = edge.side->point(xi);
      const double part = interface.depth.part(place.position().x());
      const EdgePoint at{s, half * gauss.weight * edge.side->tangent(xi).norm() * part};
      // All points count in the shares of the ends, facing or not. The shares tell how much hangs
      // over.
      samples.share += at.length * end_shape(s);
      const Projection seen = interface.closest(place, edge.side->normal(xi));
      if (seen.found && !interface.search.beyond_corner(seen, edge.side->normal(xi)))
        samples.facing.push_back({at, xi, seen});
    }
    begin = end;
  }
  return samples;
}

}  // namespace signorini

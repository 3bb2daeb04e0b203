#include "signorini/contact/point_pairs.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Entries = std::vector<Eigen::Triplet<double>>;

/// What the nodes of a side receive of a unit force on one of its points.
/// \PaperEq{LinEtAl, 27} \PaperEq{LinEtAl, 36} \PaperEq{LinEtAl, 41}
void share_out(Index row, const SideCurve& side, double xi, const Vector2d& force, Index first_node,
               Entries& entries) {
  const SideShape shape = side.shape(xi);
  for (std::size_t k = 0; k < side.nodes().size(); ++k)
    for (int axis = 0; axis < 2; ++axis) {
      const double entry = shape.value(static_cast<Index>(k)) * force(axis);
      const Index column = 2 * (first_node + side.nodes()[k]) + axis;
      if (entry != 0) entries.emplace_back(static_cast<int>(row), static_cast<int>(column), entry);
    }
}

/// The forces of a pair of points: `direction` on the source, the opposite on the target.
/// \PaperEq{LinEtAl, 23} \PaperEq{LinEtAl, 24} \PaperEq{LinEtAl, 25} \PaperEq{LinEtAl, 26}
void act_and_react(Index row, const Interface& interface, const PointPair& point,
                   const Vector2d& direction, Entries& entries) {
  share_out(row, *point.side, point.xi, direction, interface.source().first_node, entries);
  share_out(row, interface.search().side(point.place.side), point.place.xi, -direction,
            interface.target().first_node, entries);
}

}  // namespace

Pairs write_pairs(const Interface& interface, const std::vector<PointPair>& points,
                  const GapOptions& options) {
  const Index n_pairs = static_cast<Index>(points.size());
  Pairs pairs;
  pairs.initial_gap.resize(n_pairs);
  pairs.weight.resize(n_pairs);
  pairs.position.resize(n_pairs, 2);
  pairs.normal.resize(n_pairs, 2);
  Entries opening;
  Entries sliding;
  for (Index row = 0; row < n_pairs; ++row) {
    const PointPair& point = points[static_cast<std::size_t>(row)];
    const Vector2d n = point.place.normal;
    act_and_react(row, interface, point, n, opening);
    if (options.sliding) act_and_react(row, interface, point, {n.y(), -n.x()}, sliding);
    pairs.initial_gap(row) = point.place.gap;
    pairs.weight(row) = point.weight;
    pairs.position.row(row) = point.position.transpose();
    pairs.normal.row(row) = n.transpose();
    pairs.node.push_back(point.node);
  }
  for (const auto& [entries, matrix] :
       {std::pair(&opening, &pairs.opening), std::pair(&sliding, &pairs.sliding)}) {
    matrix->resize(n_pairs, 2 * options.n_nodes);
    matrix->setFromTriplets(entries->begin(), entries->end());
  }
  return pairs;
}

}  // namespace signorini

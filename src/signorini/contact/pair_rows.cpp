#include "signorini/contact/pair_rows.hpp"

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Entries = std::vector<Eigen::Triplet<double>>;

/// What the nodes of a side receive of a unit force on one of its points.
/// \PaperEq{LinEtAl, 27} \PaperEq{LinEtAl, 36} \PaperEq{LinEtAl, 41}
void share_out(Index row, const SideCurve& side, double xi, double amount, const Vector2d& force,
               Index first_node, Entries& entries) {
  const SideShape shape = side.shape(xi);
  for (std::size_t k = 0; k < side.nodes().size(); ++k)
    for (int axis = 0; axis < 2; ++axis) {
      const double entry = amount * shape.value(static_cast<Index>(k)) * force(axis);
      const Index column = 2 * (first_node + side.nodes()[k]) + axis;
      if (entry != 0) entries.emplace_back(static_cast<int>(row), static_cast<int>(column), entry);
    }
}

/// The forces of a pair of points: `direction` on the source, the opposite on the target.
/// \PaperEq{LinEtAl, 23} \PaperEq{LinEtAl, 24} \PaperEq{LinEtAl, 25} \PaperEq{LinEtAl, 26}
void act_and_react(const Interface& interface, const PairPoint& point, const Vector2d& direction,
                   Entries& entries) {
  share_out(point.pair, *point.side, point.xi, point.amount, direction, interface.source.first_node,
            entries);
  share_out(point.pair, interface.search.side(point.place.side), point.place.xi, -point.amount,
            direction, interface.target.first_node, entries);
}

void write_matrix(const Entries& entries, const Eigen::VectorXd& total, Index columns,
                  NodalRows& matrix) {
  matrix.resize(total.size(), columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (Index row = 0; row < total.size(); ++row) matrix.row(row) /= total(row);
}

/// A pair whose normals point all ways has no direction to press in.
void check_normals(const Interface& interface, const Pairs& pairs, const Eigen::VectorXd& total) {
  for (Index pair = 0; pair < total.size(); ++pair)
    pose(total(pair) > 0, "contact of '", interface.source.boundary, "' of '",
         interface.source.mesh.name, "' with '", interface.target.boundary, "' of '",
         interface.target.mesh.name, "': around (", pairs.position(pair, 0), ", ",
         pairs.position(pair, 1),
         ") the normals of the target add up to nothing. Give the parts of a side that folds back "
         "names of their own, and each its own contact");
}

}  // namespace

Eigen::VectorXd write_rows(const Interface& interface, const std::vector<PairPoint>& points,
                           const GapOptions& options, Pairs& pairs) {
  const Index n_pairs = pairs.position.rows();
  pairs.initial_gap.setZero(n_pairs);
  for (NodeArray* sums : {&pairs.normal, &pairs.moment, &pairs.target_moment})
    sums->setZero(n_pairs, 2);
  Entries opening;
  Entries sliding;
  for (const PairPoint& point : points) {
    const Vector2d n = point.place.normal;
    const double amount = point.amount;
    pairs.initial_gap(point.pair) += amount * point.place.gap;
    pairs.normal.row(point.pair) += amount * n.transpose();
    pairs.moment.row(point.pair) += amount * moments_at(point.side->point(point.xi).position(), n);
    pairs.target_moment.row(point.pair) -= amount * moments_at(point.place.point.position(), n);
    act_and_react(interface, point, n, opening);
    if (options.sliding) act_and_react(interface, point, {n.y(), -n.x()}, sliding);
  }
  const Eigen::VectorXd total = pairs.normal.rowwise().norm();
  check_normals(interface, pairs, total);
  pairs.initial_gap.array() /= total.array();
  for (NodeArray* sums : {&pairs.normal, &pairs.moment, &pairs.target_moment})
    sums->array().colwise() /= total.array();
  write_matrix(opening, total, 2 * options.n_nodes, pairs.opening);
  write_matrix(sliding, total, 2 * options.n_nodes, pairs.sliding);
  return total;
}

}  // namespace signorini

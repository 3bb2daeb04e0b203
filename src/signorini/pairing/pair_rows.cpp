// # From points to rows
//
// Every operator ends here, with a list of points of the source, each with the place that it faces
// and the amount by which it counts in its pair. A row is written once and read twice. Times the
// displacements it is the opening of the gap, and its transpose times a force is what the nodes
// receive. That is the principle of virtual work: \f$\lambda\,(N u) = (N^T\lambda)\cdot u\f$ for
// all \f$u\f$. Whoever writes the two apart has two chances to get a sign wrong, and a stiffness
// that is not symmetric.
//
// Action and reaction: on the source the entries of a row add up to \f$n\f$, on the target to
// \f$-n\f$. So the forces of a pair add up to zero. Contact forces act along the line of the two
// points, so that their moments add up to zero, too. Friction acts across this line: two friction
// forces a gap apart turn the bodies a little, and the moments below keep account of it.

#include "signorini/pairing/pair_rows.hpp"

#include <utility>

#include "signorini/contact/gaps.hpp"

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

/// Division by the total turns sums into means. Gaps are lengths then, whatever the size of the
/// mesh.
void write_matrix(Entries entries, const Eigen::VectorXd& total, Index columns,
                  NodalRows& matrix) {
  matrix = rows_of(std::move(entries), total.size(), columns);
  for (Index row = 0; row < total.size(); ++row) matrix.row(row) /= total(row);
}

/// The way from the place on the target to the point that faces it, and along the target, against the walking
/// direction, \f$ w = x - \bar x \f$ and \f$ a \f$. Both are sums over nodes, counted from a node of the target, so that nothing is
/// lost far from the origin. Of places of nodes they are w and a, of what nodes have moved they are what w and a have changed.
struct Facing {
  Vector2d way = {0, 0}, along = {0, 0};

  Facing(const PairPoint& point, const SideCurve& target,
         const Eigen::Ref<const NodeArray>& of_source,
         const Eigen::Ref<const NodeArray>& of_target) {
    const auto anchor = of_target.row(target.nodes().front());
    const SideShape here = point.side->shape(point.xi);
    const SideShape there = target.shape(point.place.xi);
    for (std::size_t k = 0; k < point.side->nodes().size(); ++k)
      way += here.value(static_cast<Index>(k)) * (of_source.row(point.side->nodes()[k]) - anchor);
    for (std::size_t k = 0; k < target.nodes().size(); ++k) {
      const Vector2d node = of_target.row(target.nodes()[k]) - anchor;
      way -= there.value(static_cast<Index>(k)) * node;
      along -= there.slope(static_cast<Index>(k)) * node;
    }
  }
};

/// How far a point has slid since the nodes stood elsewhere: by how much two places that face each
/// other now lay apart along the target then. Take a node that stood above the place 0 of a straight
/// target and is above the place 0.37 now. That place lay 0.37 to the right of it, and so much it has
/// slid. If both bodies have turned meanwhile, the tangents are those of now and then, and the number
/// is the same:
/// \f[ t\cdot w - t_0\cdot w_0 = t\cdot(w - w_0) + (t - t_0)\cdot w_0. \f]
/// The right side is what is summed. There \f$ w - w_0 \f$ comes from what the nodes have moved. A slip of 1e-12 beside a
/// body of length 1 keeps its digits, which the difference of two places would not.
double slid(const Interface& interface, const PairPoint& point, const NodeArray& since) {
  const SideCurve& target = interface.search.side(point.place.side);
  const Surface &one = interface.source, &other = interface.target;
  const Facing now(point, target, one.mesh.nodes, other.mesh.nodes);
  const Facing moved(point, target, since.middleRows(one.first_node, one.mesh.n_nodes()),
                     since.middleRows(other.first_node, other.mesh.n_nodes()));
  const Vector2d tangent = now.along.normalized();
  const Vector2d turned = tangent - (now.along - moved.along).normalized();
  return tangent.dot(moved.way) + turned.dot(now.way - moved.way);
}

}  // namespace

/// A mean of several unit normals is shorter than 1 if the target turns among the points of a pair.
/// It is not normalised: force times this mean is exactly what the points push with. The moments
/// tell where the resultant of the pair acts, if not at its position.
void write_rows(const Interface& interface, const std::vector<PairPoint>& points,
                const Eigen::VectorXd& total, const GapOptions& options, Pairs& pairs) {
  pairs.initial_gap.setZero(total.size());
  for (NodeArray* means : {&pairs.normal, &pairs.moment, &pairs.target_moment})
    means->setZero(total.size(), 2);
  const bool moved = options.sliding && options.since != nullptr;
  if (moved) pairs.slid.setZero(total.size());
  Entries opening, sliding;
  for (const PairPoint& point : points) {
    const Vector2d n = point.place.normal;
    const double share = point.amount / total(point.pair);
    pairs.initial_gap(point.pair) += share * point.place.gap;
    pairs.normal.row(point.pair) += share * n.transpose();
    const AnchoredPoint x(pairs.position.row(point.pair).transpose());
    pairs.moment.row(point.pair) += share * moments_at(point.side->point(point.xi) - x, n);
    pairs.target_moment.row(point.pair) -= share * moments_at(point.place.point - x, n);
    act_and_react(interface, point, n, opening);
    if (options.sliding) act_and_react(interface, point, {n.y(), -n.x()}, sliding);
    if (moved) pairs.slid(point.pair) += share * slid(interface, point, *options.since);
  }
  write_matrix(std::move(opening), total, 2 * options.n_nodes, pairs.opening);
  write_matrix(std::move(sliding), total, 2 * options.n_nodes, pairs.sliding);
}

}  // namespace signorini

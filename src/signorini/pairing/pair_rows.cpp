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

using Eigen::Index, Eigen::Vector2d;
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

/// The way from the place on the target to the point that faces it, \f$ w = x - \bar x \f$: a sum over nodes, counted from a node of
/// the target, so that nothing is lost far from the origin. Of places of nodes it is w, of what nodes have moved it is what w has
/// changed.
Vector2d way_of(const PairPoint& point, const SideCurve& target,
                const Eigen::Ref<const NodeArray>& of_source,
                const Eigen::Ref<const NodeArray>& of_target) {
  const auto anchor = of_target.row(target.nodes().front());
  const SideShape here = point.side->shape(point.xi);
  const SideShape there = target.shape(point.place.xi);
  Vector2d way(0, 0);
  for (std::size_t k = 0; k < point.side->nodes().size(); ++k)
    way += here.value(static_cast<Index>(k)) * (of_source.row(point.side->nodes()[k]) - anchor);
  for (std::size_t k = 0; k < target.nodes().size(); ++k)
    way -= there.value(static_cast<Index>(k)) * (of_target.row(target.nodes()[k]) - anchor);
  return way;
}

/// Along a side of the target, by places of nodes or by what they have moved.
Vector2d along(const SideCurve& side, double xi, const Eigen::Ref<const NodeArray>& of_target) {
  const SideShape there = side.shape(xi);
  Vector2d along(0, 0);
  for (std::size_t k = 1; k < side.nodes().size(); ++k)  // slopes add up to 0
    along += there.slope(static_cast<Index>(k)) *
             (of_target.row(side.nodes()[k]) - of_target.row(side.nodes()[0]));
  return along;
}

/// \f$ t - t_0 \f$: a tangent of the target now, less what it was before the target turned. A vertex turns as the mean of its two
/// sides.
Vector2d turned_since(const Interface& interface, const Projection& place, const Vector2d& t,
                      const NodeArray& since) {
  const Surface& target = interface.target;
  const auto moved = since.middleRows(target.first_node, target.mesh.n_nodes());
  Vector2d now(0, 0), then(0, 0);
  const auto add = [&](const SideCurve& side, double xi) {
    const Vector2d here = along(side, xi, target.mesh.nodes);
    now += here.normalized();
    then += (here - along(side, xi, moved)).normalized();
  };
  add(interface.search.side(place.side), place.xi);
  if (place.next >= 0) add(interface.search.side(place.next), -place.xi);
  now.normalize();
  then.normalize();
  const double sine = now.x() * then.y() - now.y() * then.x();
  const double cosine = now.dot(then);
  const double less = cosine < 0 ? 1 - cosine : sine * sine / (1 + cosine);
  return less * t + sine * Vector2d(t.y(), -t.x());
}

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
  const Vector2d& n = point.place.normal;
  const Vector2d tangent(n.y(), -n.x());
  const Vector2d now = way_of(point, target, one.mesh.nodes, other.mesh.nodes);
  const Vector2d moved =
      way_of(point, target, since.middleRows(one.first_node, one.mesh.n_nodes()),
             since.middleRows(other.first_node, other.mesh.n_nodes()));
  return tangent.dot(moved) +
         turned_since(interface, point.place, tangent, since).dot(now - moved);
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

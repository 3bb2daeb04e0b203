// # Do the reported forces add up?
//
// The same contact forces stand in a solution twice. The solver pushes nodes by rows of A. A
// reader sees forces of pairs, each with a place and a normal, and adds them up to a
// resultant. If a normal or a place were wrong, the nodes would still be in balance, and the
// resultant would be wrong. So we add up both and compare, per body:
// \f[ \Big(\sum f,\; \sum (x - x_m) \times f\Big), \qquad a \times f = a_x f_y - a_y f_x, \f]
// with \f$ x_m \f$ the middle of the body. For example, forces 2 and 4 along (0, 1) act at
// (-1, 0) and (1, 0). Their resultant is (0, 6), and their moment about the origin is
// \f$ -1\cdot 2 + 1\cdot 4 = 2 \f$. A reader who took the second place for (0.5, 0) would
// find the moment 0.

#include "signorini/scene/balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "signorini/core/index.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

// Force and moment about the middle of a body. They are summed in long double, because
// forces all round a body cancel, and what is left would be rounding.
using Sum = std::array<long double, 3>;

void add(Sum& sum, double factor, const Vector2d& force, double moment) {
  sum[0] += static_cast<long double>(factor) * force.x();
  sum[1] += static_cast<long double>(factor) * force.y();
  sum[2] += static_cast<long double>(factor) * moment;
}

// The middle of every body and how far its nodes are from there. Moments about a far origin
// would be large and cancel. The reach tells how large a moment the largest force can make, and the rounding by how much
// places may be wrong that are sums.
struct Extent {
  Vector2d middle;
  double reach;
  double rounding = 0;
};

Extent extent(const NodeArray& nodes) {
  const Vector2d middle = nodes.colwise().mean().transpose();
  return {middle, (nodes.rowwise() - middle.transpose()).rowwise().norm().maxCoeff()};
}

// Forces act where the bodies are: if pairs were found where they have moved to, there. A couple of
// forces that is in balance at one place of two bodies may turn them at another, so that moments
// must be taken in the present places. Those of pairs and of nodes are rounded one by one, far from the origin by more than a
// certificate lets pass of a moment: two roundings of each place are no error of forces.
Extent extent(const Model& model, const BodyModel& body) {
  if (!model.standing) return extent(body.mesh.nodes);
  const NodeArray& moved = model.standing->displacement;
  const NodeArray there = body.mesh.nodes + moved.middleRows(body.first_node, body.mesh.n_nodes());
  Extent whole = extent(there);
  whole.rounding = 2 * epsilon * there.cwiseAbs().maxCoeff();
  return whole;
}

// tell() adds what a reader adds, hand_on() takes away what the nodes got. If both agree,
// the three sums of every body are zero but for rounding.
class Balance {
 public:
  explicit Balance(const Model& model)
      : model_(model), sums_(model.bodies.size(), Sum{}), pushed_(model.bodies.size(), 0) {
    for (const BodyModel& body : model.bodies) extents_.push_back(extent(model, body));
  }

  // A force of a pair along its normal or tangent, on both sides. The target gets the
  // opposite. A pair may act on several nodes, so that it has a moment about its own place,
  // too.
  void tell(Index pair, int which, double force) {
    const Pairs& pairs = model_.pairs;
    const Vector2d n = pairs.normal.row(pair).transpose();
    const Vector2d direction = which == 0 ? n : Vector2d(n.y(), -n.x());
    const ContactBodies& bodies = model_.contact_bodies[model_.contact_of[at(pair)]];
    const Vector2d x = pairs.position.row(pair).transpose();
    const auto act = [&](std::size_t body, const Vector2d& along, double moment) {
      add(sums_[body], force, along, moment + cross(x - extents_[body].middle, along));
      pushed_[body] += std::abs(force) * along.norm();
    };
    act(bodies.source, direction, pairs.moment(pair, which));
    if (bodies.target) act(*bodies.target, -direction, pairs.target_moment(pair, which));
  }

  // The same force by its row, taken away. An entry of the row is a force on one component
  // of one node.
  void hand_on(const NodalRows& rows, Index row, double force) {
    for (NodalRows::InnerIterator it(rows, row); it; ++it) {
      const std::size_t body = body_of_node(model_.bodies, it.col() / 2);
      const BodyModel& own = model_.bodies[body];
      Vector2d along = Vector2d::Zero();
      along(it.col() % 2) = it.value();
      Vector2d x = own.mesh.nodes.row(it.col() / 2 - own.first_node).transpose();
      if (model_.standing) x += model_.standing->displacement.row(it.col() / 2).transpose();
      add(sums_[body], -force, along, cross(x - extents_[body].middle, along));
    }
  }

  // The largest entry of a body, made free of units: a sum of forces over the largest force,
  // a moment over that of the largest force at the farthest node. All round an axis, radial
  // forces and moments cancel anyway, so in axial symmetry only the force along the axis
  // counts.
  [[nodiscard]] double worst(double largest_force) const {
    const bool axial = is_axial(model_.bodies.front());
    double worst = 0;
    for (std::size_t body = 0; body < sums_.size(); ++body)
      for (int k = axial ? 1 : 0; k < (axial ? 2 : 3); ++k) {
        const double size = largest_force * (k == 2 ? extents_[body].reach : 1);
        const double rounding = k == 2 ? extents_[body].rounding * pushed_[body] : 0;
        const double off = static_cast<double>(std::abs(sums_[body][at(k)])) - rounding;
        if (off > 0) worst = std::max(worst, off / size);
      }
    return worst;
  }

 private:
  const Model& model_;
  std::vector<Extent> extents_;
  std::vector<Sum> sums_;
  std::vector<double> pushed_;  // magnitudes of the forces of pairs, summed
};

}  // namespace

// What a reader sees are the forces of the contact state. What the nodes got are the
// certified forces of all rows of A: those of gaps come first, those of slips behind them. A
// pair without friction has no second row.
//
// A relation may push on three bodies at once, in three directions, and tells of the first one
// alone. What it tells is a part of what the nodes got, and such a pair is not asked.
double imbalance(const Model& model, const ContactState& contact,
                 const Eigen::VectorXd& certified) {
  const Index pairs = contact.force.size();
  if (pairs == 0) return 0;
  Balance balance(model);
  for (Index pair = 0; pair < pairs; ++pair) {
    if (model.contact_bodies[model.contact_of[at(pair)]].acts_elsewhere) continue;
    balance.tell(pair, 0, contact.force(pair));
    balance.hand_on(model.pairs.opening, pair, certified(pair));
  }
  for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k) {
    const Index slip = static_cast<Index>(k);
    balance.tell(contact.frictional_pairs[k], 1, contact.friction(slip));
    balance.hand_on(model.pairs.sliding, contact.frictional_pairs[k], certified(pairs + slip));
  }
  return balance.worst(largest(certified));
}

}  // namespace signorini

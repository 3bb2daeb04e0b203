// # Contact forces that turn
//
// A pair with the force \f$ \lambda \f$ puts \f$ \lambda N^T \f$ on the nodes. If the bodies move, so do the normal
// in N and the place of the target that the point faces. Newton's method wants this change too.
//
// A point at the distance g from the place \f$ \bar x(\xi) \f$ of a side, with the tangent t, the normal n out of it,
// \f$ J = |\bar x'| \f$ and the curvature \f$ \kappa = -n\cdot\bar x''/J^2 \f$ (1/R on a disc, 0 on a straight side),
// reads three numbers of a displacement: along t and along n by how much it goes away from its place,
// \f$ T u \f$ and \f$ N u \f$, and by which angle the side turns under it, \f$ \theta u = \sum N_c'\,n\cdot u_c/J \f$.
// The foot of the point is where \f$ (x - \bar x)\cdot\bar x' = 0 \f$. The change of this equation tells how far the foot
// wanders, and so how the normal turns:
//
// \f[ J\,d\xi = \frac{T + g\,\theta}{1 + \kappa g}\,u, \qquad dn = t\,(\kappa J\,d\xi - \theta u). \f]
//
// With both, the change of \f$ \lambda N^T \f$ is symmetric, as that of a gradient must be:
//
// \f[ B = \frac{\lambda}{1 + \kappa g}\,\bigl(\kappa\,T^TT - T^T\theta - \theta^TT - g\,\theta^T\theta\bigr). \f]
//
// Two ends of \f$ \kappa \f$ need no other formula. A vertex is a disc of radius 0: what is left of B
// is \f$ \lambda\,T^TT/g \f$. And an obstacle does not turn: \f$ \theta = 0 \f$, and its normal tells
// \f$ \kappa/(1 + \kappa g) \f$, that is \f$ 1/(R + g) \f$ on a disc. A node at (0, 2.5) above a disc of radius 2, with
// the force 10, that goes by 0.1 to the right: its force turns by 0.1/2.5, and the disc pushes it on with 0.4.
//
// Between two sides of a target the normal jumps. The place s of the jump is where both sides are equally far,
// and so it wanders by \f$ ds = -(N_1 - N_2)\,u / \tau\cdot(n_1 - n_2) \f$ along the tangent \f$ \tau \f$ of the source.
// Times the jump of the force that is again symmetric, and of rank one:
//
// \f[ B = -\lambda\,\psi\,\frac{(N_1 - N_2)^T(N_1 - N_2)}{\tau\cdot(n_1 - n_2)}. \f]

#include "addons/motion/curvature.hpp"

#include <cmath>
#include <vector>

#include "signorini/fem/side_curve.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// What turns by less than this is a straight line: directions of sides have rounding, too [rad].
constexpr double no_turn = 1e-9;

/// The numbers of two or three sides, one after the other: a jump has a source and two targets.
constexpr int most = 18;
using Columns = Eigen::Matrix<Index, Eigen::Dynamic, 1, 0, most, 1>;
using Reading = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;

/// The columns of the nodes of some places.
Columns columns_of(const std::vector<const SidePlace*>& places) {
  Columns columns(6 * static_cast<Index>(places.size()));
  Index k = 0;
  for (const SidePlace* place : places)
    for (const Index node : place->node)
      for (const Index axis : {0, 1}) columns(k++) = node < 0 ? -1 : 2 * node + axis;
  return columns;
}

/// What nodes with these amounts read along a direction.
Eigen::Matrix<double, 6, 1> along(const Vector3d& amount, const Vector2d& direction) {
  Eigen::Matrix<double, 6, 1> reading;
  for (Index k = 0; k < 3; ++k) reading.segment<2>(2 * k) = amount(k) * direction;
  return reading;
}

/// What a point reads along a direction: its place less that of the target.
Reading apart(const KeptPoint& point, const Vector2d& direction) {
  Reading reading(12);
  reading << along(point.source.value, direction), -along(point.target.value, direction);
  return reading;
}

/// The lower half of a symmetric block, wherever its numbers stand among the others.
void write(const Columns& columns, const Block& block, Triplets& lower) {
  for (Index i = 0; i < columns.size(); ++i)
    for (Index k = 0; k < columns.size(); ++k)
      if (columns(k) >= 0 && columns(i) >= columns(k) && block(i, k) != 0)
        lower.emplace_back(static_cast<int>(columns(i)), static_cast<int>(columns(k)), block(i, k));
}

/// A side of the target at a place: its tangent, and how it bends and turns.
struct Bend {
  Vector2d slope = {0, 0};      ///< dx/dxi [length]
  Vector2d bend = {0, 0};       ///< d^2x/dxi^2 [length]
  Vector3d change = {0, 0, 0};  ///< dN/dxi of its nodes [-]
};

/// Differences to the first node, which are exact far from the origin.
Bend bend_of(const SidePlace& side, double xi, const NodeArray& places) {
  const std::size_t n = side.n_nodes();
  Bend at;
  at.change = side_shape(n, xi).slope;
  const Vector3d second = n == 3 ? Vector3d(1, -2, 1) : Vector3d(0, 0, 0);
  for (std::size_t k = 1; k < n; ++k) {
    const Vector2d arm = (places.row(side.node[k]) - places.row(side.node[0])).transpose();
    at.slope += at.change(static_cast<Index>(k)) * arm;
    at.bend += second(static_cast<Index>(k)) * arm;
  }
  return at;
}

/// B of a point for a force of one.
Block of_point(const KeptPoint& point, const NodeArray& places) {
  const Vector2d& n = point.normal;
  const Vector2d t(-n.y(), n.x());
  const Reading T = apart(point, t);
  if (point.target.n_nodes() == 0) return point.turning * T * T.transpose();
  const Bend side = bend_of(point.target, point.xi, places);
  const double J = side.slope.norm();
  if (std::abs(side.slope.dot(n)) > no_turn * J)  // a vertex
    return (std::abs(point.gap) > no_turn * J ? 1 / point.gap : 0) * T * T.transpose();
  const double kappa = -n.dot(side.bend) / (J * J);
  Reading turn = Reading::Zero(12);
  turn.tail<6>() = along(side.change / J, n);
  return (kappa * T * T.transpose() - T * turn.transpose() - turn * T.transpose() -
          point.gap * turn * turn.transpose()) /
         (1 + kappa * point.gap);
}

/// B of a jump for a force of one. Sides that go on straight have none.
Block of_jump(const KeptJump& jump) {
  const Vector2d& n = jump.before.normal;
  const Vector2d change = n - jump.behind.normal;
  Reading J(18);
  J << along(jump.before.source.value, change), -along(jump.before.target.value, n),
      along(jump.behind.target.value, jump.behind.normal);
  const double slope = jump.along.dot(change);
  return (std::abs(slope) > no_turn ? -1 / slope : 0) * J * J.transpose();
}

}  // namespace

/// Only half is written, and the other half is the same: so B is symmetric to the last bit.
Eigen::SparseMatrix<double> contact_curvature(const KeptPoints& kept, const Eigen::VectorXd& force,
                                              const NodeArray& places) {
  Triplets lower;
  for (const KeptPoint& point : kept.points)
    if (const double push = point.share * force(point.pair); push != 0)
      write(columns_of({&point.source, &point.target}), push * of_point(point, places), lower);
  for (const KeptJump& jump : kept.jumps) {
    const KeptPoint& point = jump.before;
    if (const double push = point.share * force(point.pair); push != 0)
      write(columns_of({&point.source, &point.target, &jump.behind.target}), push * of_jump(jump),
            lower);
  }
  Eigen::SparseMatrix<double> half(places.size(), places.size());
  half.setFromTriplets(lower.begin(), lower.end());
  return half.selfadjointView<Eigen::Lower>();
}

}  // namespace signorini

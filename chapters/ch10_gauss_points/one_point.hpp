/// \file
/// One Gauss point of an edge of the source over an edge of the target, by hand: equations (32) to (41).
#pragma once
#include <Eigen/Core>

namespace ch10 {

using Eigen::Vector2d;
using FourNodes =
    Eigen::Matrix<double, 4, 2>;  // points or vectors: 1, 2 of the source, 3, 4 of the target

/// Where a Gauss point is, and what it faces. The target lies on the left of its edge from 3 to 4.
struct PointOverEdge {
  double N1, N2, N3, N4;  ///< shape functions at the point, and at the place that it faces [-]
  Vector2d x, place;      ///< of the point, and of what it faces [length]
  Vector2d n, t;          ///< out of the target, and along it: t = (n_y, -n_x)
  double gap;             ///< open > 0 [length]
  double share;  ///< half the edge times the weight of the rule; l_12/2 with two points [length]
};

/// \PaperEq{LinEtAl, 32}: all positions are those of now, X = X0 + U.
/// \param X0  before loading \param U  displacements \param xi  of the point on the edge, -1 at node 1 and 1 at node 2
/// \param weight  of the rule; 1 with two points
/// \return the point and its place
// [point]
inline PointOverEdge point_over_edge(const FourNodes& X0, const FourNodes& U, double xi,
                                     double weight = 1) {
  const FourNodes X = X0 + U;
  PointOverEdge at;
  at.N1 = (1 - xi) / 2;
  at.N2 = (1 + xi) / 2;
  at.x = (at.N1 * X.row(0) + at.N2 * X.row(1)).transpose();  // (32)
  const Vector2d edge = (X.row(3) - X.row(2)).transpose();
  const Vector2d from3 = at.x - X.row(2).transpose();
  at.N4 = from3.dot(edge) / edge.squaredNorm();
  at.N3 = 1 - at.N4;
  at.place = (at.N3 * X.row(2) + at.N4 * X.row(3)).transpose();
  at.n = Vector2d(edge.y(), -edge.x()).normalized();
  at.t = Vector2d(at.n.y(), -at.n.x());
  at.gap = (at.x - at.place).dot(at.n);
  at.share = weight * (X.row(1) - X.row(0)).norm() / 2;
  return at;
}
// [point]

/// \PaperEq{LinEtAl, 33} to \PaperEq{LinEtAl, 36}, and \PaperEq{LinEtAl, 38} to \PaperEq{LinEtAl, 41} along the tangent
/// \param at  the point \param fn  its pressure \param tau  its shear, on the source [force/length^2]
/// \return forces on the four nodes, for a thickness of 1
// [forces]
inline FourNodes forces_of_point(const PointOverEdge& at, double fn, double tau) {
  const Vector2d gp = at.share * (fn * at.n + tau * at.t);  // (33), (38)
  const Vector2d pgp = -gp;                                 // (34), (39)
  FourNodes forces;
  forces << at.N1 * gp.transpose(), at.N2 * gp.transpose(),  // (35), (40)
      at.N3 * pgp.transpose(), at.N4 * pgp.transpose();      // (36), (41)
  return forces;
}
// [forces]

}  // namespace ch10

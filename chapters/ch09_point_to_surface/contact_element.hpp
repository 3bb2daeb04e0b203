/// \file
/// One node of the source over one edge of the target: geometry, forces, equations and their Jacobian.
#pragma once
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "signorini/problem/complementarity_functions.hpp"

namespace ch09 {

using Eigen::Vector2d;
using signorini::ComplementaritySlope;
using signorini::fischer_burmeister;
using signorini::fischer_burmeister_slope;
using Nodes = Eigen::Matrix<double, 3, 2>;  // points or vectors of the nodes 1, 2 and 3
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Vector10d = Eigen::Matrix<double, 10, 1>;
using Matrix10d = Eigen::Matrix<double, 10, 10>;

/// Where node 3 stands over the edge from 1 to 2, which has its body on the left.
struct Place {
  double N1, N2;  ///< shape functions [-]
  Vector2d n, t;  ///< out of the target, and along it: t = (n_y, -n_x)
  double gap;     ///< g_0 [length]
};

/// Projects node 3 onto the edge. \PaperEq{LinEtAl, 20}
// [place]
inline Place projected(const Nodes& X) {
  const Vector2d edge = (X.row(1) - X.row(0)).transpose();
  const Vector2d to3 = (X.row(2) - X.row(0)).transpose();
  Place place;
  place.N2 = to3.dot(edge) / edge.squaredNorm();
  place.N1 = 1 - place.N2;
  place.n = Vector2d(edge.y(), -edge.x()).normalized();
  place.t = Vector2d(place.n.y(), -place.n.x());
  const Vector2d X3 = place.N1 * X.row(0).transpose() + place.N2 * X.row(1).transpose();  // (20)
  place.gap = (X.row(2).transpose() - X3).dot(place.n);
  return place;
}
// [place]

/// What a force on node 3 is on all three nodes. \PaperEq{LinEtAl, 23} to \PaperEq{LinEtAl, 27}
// [forces]
inline Nodes nodal_forces(const Place& place, double fn, double ft) {
  const Vector2d on3 = fn * place.n + ft * place.t;  // (23), (24)
  const Vector2d back = -on3;                        // (25), (26), at 3'
  Nodes forces;
  forces << place.N1 * back.transpose(), place.N2 * back.transpose(), on3.transpose();  // (27)
  return forces;
}
// [forces]

/// Moment of forces on the nodes about the origin.
inline double moment(const Nodes& X, const Nodes& forces) {
  return X.col(0).dot(forces.col(1)) - X.col(1).dot(forces.col(0));
}

/// Four signs that must fit together. f_n is a pressure on node 3, or it keeps the sign of the stress sigma_n; then it is
/// a pull, tau is the shear on the target and the slip is that of the target.
struct Signs {
  double gap_row;   ///< of f_n in (28)
  double bound;     ///< of mu f_n in (29)
  double reaction;  ///< of a in (31), and of F^C on the left of (42)
};
inline constexpr Signs as_pressure{1, 1, -1};  ///< (28) as printed, the other two changed
inline constexpr Signs as_stress{-1, -1, 1};   ///< as printed but for the row of the gap; tau and slip of the target
inline constexpr Signs as_printed{1, -1, 1};   ///< all as printed

/// The element: its nodes on springs, loads on them, and the laws of contact and friction.
struct ContactElement {
  Nodes X;           ///< positions [mm]
  Vector6d springs;  ///< diagonal K, components node by node [N/mm]
  Vector6d load;     ///< [N]
  double mu;         ///< friction coefficient
  double cohesion;   ///< c [N]
  Signs sign = as_pressure;
};

/// Unknowns are U of the nodes 1, 2, 3, then f_n, tau, u+ and u-.
struct System {
  Vector10d residual;
  Matrix10d jacobian;
};

/// (30) for one element. \PaperEq{LinEtAl, 21} \PaperEq{LinEtAl, 22} \PaperEq{LinEtAl, 28} to \PaperEq{LinEtAl, 31}
// [equations]
inline System equations(const ContactElement& element, const Vector10d& x) {
  const Place at = projected(element.X);
  const Signs& sign = element.sign;
  const double fn = x(6), tau = x(7), plus = x(8), minus = x(9);
  Vector6d a1, a2;  // the columns of a: what opens the gap, and what slides
  a1 << -at.N1 * at.n, -at.N2 * at.n, at.n;
  a2 << -at.N1 * at.t, -at.N2 * at.t, at.t;
  const Vector6d U = x.head(6);
  const double gap = at.gap + a1.dot(U), slip = -sign.reaction * a2.dot(U);  // (22)
  const double mu = sign.bound * element.mu, B = element.cohesion + mu * fn;
  System system{Vector10d::Zero(), Matrix10d::Zero()};
  system.residual << element.springs.cwiseProduct(U) - element.load +
                         sign.reaction * (a1 * fn + a2 * tau),                // (30)
      fischer_burmeister(gap, sign.gap_row * fn), slip - (plus - minus),      // (28), (19)
      fischer_burmeister(plus, B + tau), fischer_burmeister(minus, B - tau);  // (29)
  const ComplementaritySlope n = fischer_burmeister_slope(gap, sign.gap_row * fn),
                             p = fischer_burmeister_slope(plus, B + tau),
                             m = fischer_burmeister_slope(minus, B - tau);
  Matrix10d& J = system.jacobian;  // (31)
  J.topLeftCorner(6, 6) = element.springs.asDiagonal();
  J.block(0, 6, 6, 2) << sign.reaction * a1, sign.reaction * a2;
  J.block(6, 0, 1, 6) = n.a * a1.transpose();
  J(6, 6) = sign.gap_row * n.b;
  J.block(7, 0, 1, 6) = -sign.reaction * a2.transpose();
  J.block(7, 8, 1, 2) << -1, 1;
  J.block(8, 6, 1, 3) << mu * p.b, p.b, p.a;
  J.block(9, 6, 1, 4) << mu * m.b, -m.b, 0, m.a;
  return system;
}
// [equations]

/// Where full Newton steps end.
struct End {
  Vector10d x;
  int steps = 0;
  double residual = 0;
  bool solved = false;
};

/// \param element  with its signs \param x  the start \return the end, after 60 steps at most
inline End solved(const ContactElement& element, Vector10d x) {
  End end;
  for (int k = 0; k <= 60; ++k) {
    const System at = equations(element, x);
    end = {x, k, at.residual.cwiseAbs().maxCoeff(), false};
    end.solved = end.residual <= 1e-12;
    if (end.solved || !std::isfinite(end.residual)) break;
    x -= at.jacobian.fullPivLu().solve(at.residual);
  }
  return end;
}

/// \param x  unknowns with f_n as a pressure
/// \return the same state with f_n as a stress: f_n and tau change their signs, the parts of the slip their places
inline Vector10d mirrored(const Vector10d& x) {
  Vector10d image = x;
  image(6) = -x(6);
  image(7) = -x(7);
  image(8) = x(9);
  image(9) = x(8);
  return image;
}

}  // namespace ch09

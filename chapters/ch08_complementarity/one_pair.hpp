/// \file
/// One pair with friction: the split of the paper, and one equation instead.
#pragma once
#include <Eigen/LU>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace signorini {

/// One pair whose normal and tangential compliance are 1: gap = d + f_n, slip = s + f_t.
struct OnePair {
  double free_gap;   ///< d [length], overlap < 0
  double free_slip;  ///< s [length], of the source along the tangent
  double mu;         ///< friction coefficient
  double cohesion;   ///< [force]
};

struct NamedPair {
  const char* name;
  OnePair pair;
};

// [pairs]
inline const std::vector<NamedPair> one_pairs = {{"closed, sticks", {-1, 0.3, 0.5, 0}},
                                                 {"closed, slides", {-1, 1, 0.5, 0}},
                                                 {"closed, no friction", {-1, 0.3, 0, 0}},
                                                 {"open, no cohesion", {0.5, 0.3, 0.5, 0}},
                                                 {"open, cohesion", {0.5, 0.3, 0.5, 0.2}}};
// [pairs]

/// Residual and Jacobian of some equations.
struct System {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
};

/// The split: normal force, friction force, u+ and u-. \PaperEq{LinEtAl, 13} to \PaperEq{LinEtAl, 19}
// [split]
inline System split(const OnePair& pair, const Eigen::VectorXd& x) {
  const double fn = x(0), ft = x(1), plus = x(2), minus = x(3);
  const double gap = pair.free_gap + fn, bound = pair.cohesion + pair.mu * fn;
  const ComplementaritySlope n = fischer_burmeister_slope(gap, fn);
  const ComplementaritySlope p = fischer_burmeister_slope(plus, bound + ft);
  const ComplementaritySlope m = fischer_burmeister_slope(minus, bound - ft);
  System system{Eigen::VectorXd(4), Eigen::MatrixXd(4, 4)};
  system.residual << fischer_burmeister(gap, fn),  // (12)
      pair.free_slip + ft - plus + minus,          // (19)
      fischer_burmeister(minus, bound - ft),       // (17)
      fischer_burmeister(plus, bound + ft);        // (18)
  system.jacobian << n.a + n.b, 0, 0, 0,           //
      0, 1, -1, 1,                                 //
      pair.mu * m.b, -m.b, 0, m.a,                 //
      pair.mu * p.b, p.b, p.a, 0;
  return system;
}
// [split]

/// One equation in the place of (17)-(19): phi(B + f_t, phi(B - f_t, -slip)) = 0.
// [one]
inline System one_equation(const OnePair& pair, const Eigen::VectorXd& x) {
  const double fn = x(0), ft = x(1);
  const double gap = pair.free_gap + fn, slip = pair.free_slip + ft;
  const double bound = pair.cohesion + pair.mu * fn;
  const double inner = fischer_burmeister(bound - ft, -slip);
  const ComplementaritySlope n = fischer_burmeister_slope(gap, fn);
  const ComplementaritySlope i = fischer_burmeister_slope(bound - ft, -slip);
  const ComplementaritySlope o = fischer_burmeister_slope(bound + ft, inner);
  System system{Eigen::VectorXd(2), Eigen::MatrixXd(2, 2)};
  system.residual << fischer_burmeister(gap, fn), fischer_burmeister(bound + ft, inner);
  system.jacobian << n.a + n.b, 0,  //
      pair.mu * (o.a + o.b * i.a), o.a - o.b * (i.a + i.b);
  return system;
}
// [one]

/// Where Newton's method ends, after how many full steps, and how near to singular it is there.
struct End {
  Eigen::VectorXd x;
  int steps = 0;
  double smallest = 0;  ///< singular value of the Jacobian
};

/// \param equations  split or one_equation
/// \param pair       whose equations
/// \param x          the start
/// \throws NotSolved if 60 steps do not bring all residuals to 1e-12
template <class Equations>
End solved(Equations equations, const OnePair& pair, Eigen::VectorXd x) {
  for (int k = 0; k <= 60; ++k) {
    const System at = equations(pair, x);
    if (at.residual.cwiseAbs().maxCoeff() <= 1e-12)
      return {x, k, singular_values(at.jacobian).values.minCoeff()};
    x -= at.jacobian.fullPivLu().solve(at.residual);
  }
  throw NotSolved("one pair with friction: 60 steps are not enough");
}

}  // namespace signorini

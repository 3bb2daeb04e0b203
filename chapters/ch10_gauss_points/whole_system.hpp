/// \file
/// The whole system (42), with friction and with the displacements as unknowns, on meshes with Gauss points.
#pragma once
#include <Eigen/LU>
#include <cmath>
#include <utility>
#include <vector>

#include "interfaces.hpp"
#include "signorini/problem/complementarity_functions.hpp"

namespace ch10 {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What f_n is: a pressure, with the signs of chapter 9, or a stress, with the signs of (42) as printed but for its row of
/// the gap, which has \f$ -f_n \f$. Then tau is the shear on the target, and the slip is that of the target.
enum class NormalTraction { Pressure = 1, Stress = -1 };

/// What (42) is made of.
struct WholeSystem {
  SolvedScene run;      ///< by the library, to compare with. The system takes its model only
  MatrixXd normal;      ///< `n x n_c` loads of the nodes of unit pressures: (33) to (36) [length^2]
  MatrixXd tangential;  ///< `n x n_c` of unit shears: (38) to (41) [length^2]
  double mu;            ///< friction coefficient
  double cohesion;      ///< [force/length^2]
  NormalTraction reading = NormalTraction::Pressure;
};

/// F and J at some place; unknowns are U, then all f_n, tau, u+ and u-.
struct WholeState {
  VectorXd residual;
  MatrixXd jacobian;
};

/// Two blocks of 8 over 11 edges with two points on an edge; the top is pushed down and to the side.
/// \param side  how far to the side, over how far down \return the scene
inline Scene sheared_blocks(double side) {
  Scene scene = blocks(8, 11, Sampling{"gauss_points", 2});
  scene.bodies[0].loads.edges.clear();
  scene.bodies[0].supports = {prescribed("top", Axis::Y, -0.001),
                              prescribed("top", Axis::X, 0.001 * side)};
  scene.bodies[1].supports = {fixed("bottom")};
  scene.contacts[0].friction = Friction{0.3, 0};
  return scene;
}

/// \param scene  with friction at every pair \return its system
inline WholeSystem whole_system(const Scene& scene) {
  WholeSystem whole{solved(scene, "blocks with friction"),
                    {},
                    {},
                    scene.contacts[0].friction->coefficient,
                    scene.contacts[0].friction->cohesion};
  const MatrixXd A(whole.run.model.programme.A);  // gaps, then slips: g - A u
  const Index pairs = whole.run.model.pairs.weight.size();
  const auto weight = whole.run.model.pairs.weight.asDiagonal();
  whole.normal = -A.topRows(pairs).transpose() * weight;
  whole.tangential = -A.bottomRows(pairs).transpose() * weight;
  return whole;
}

/// \PaperEq{LinEtAl, 42}, with \PaperEq{LinEtAl, 37} for its row of the gap and \PaperEq{LinEtAl, 31} for J
/// \param whole  the system \param x  unknowns \return F and J
// [whole]
inline WholeState evaluate(const WholeSystem& whole, const VectorXd& x) {
  const auto& [K, external, A, initial, reached] = whole.run.model.programme;
  const Index n = external.size(), m = whole.normal.cols();
  const double s = whole.reading == NormalTraction::Pressure ? 1 : -1;
  const VectorXd U = x.head(n), fn = x.segment(n, m), tau = x.segment(n + m, m);
  const VectorXd plus = x.segment(n + 2 * m, m), minus = x.tail(m);
  const VectorXd moved = initial - A * U;  // gaps, then slips of the source
  WholeState at{VectorXd(n + 4 * m), MatrixXd::Zero(n + 4 * m, n + 4 * m)};
  at.residual.head(n) = K * U - external - s * (whole.normal * fn + whole.tangential * tau);
  at.jacobian.topLeftCorner(n, n) = MatrixXd(K);
  at.jacobian.block(0, n, n, m) = -s * whole.normal;
  at.jacobian.block(0, n + m, n, m) = -s * whole.tangential;
  const MatrixXd rows(A);
  for (Index i = 0; i < m; ++i) {
    const Index gap = n + i, slip = gap + m, ahead = slip + m, back = ahead + m;
    const double B = whole.cohesion + s * whole.mu * fn(i);
    const auto g = fischer_burmeister_slope(moved(i), s * fn(i));
    const auto p = fischer_burmeister_slope(plus(i), B + tau(i));
    const auto q = fischer_burmeister_slope(minus(i), B - tau(i));
    at.residual(gap) = fischer_burmeister(moved(i), s * fn(i));   // (37)
    at.residual(slip) = s * moved(m + i) - (plus(i) - minus(i));  // (19)
    at.residual(ahead) = fischer_burmeister(plus(i), B + tau(i));
    at.residual(back) = fischer_burmeister(minus(i), B - tau(i));
    at.jacobian.row(gap).head(n) = -g.a * rows.row(i);
    at.jacobian(gap, gap) = s * g.b;
    at.jacobian.row(slip).head(n) = -s * rows.row(m + i);
    at.jacobian(slip, ahead) = -1;
    at.jacobian(slip, back) = 1;
    at.jacobian(ahead, gap) = s * whole.mu * p.b;
    at.jacobian(ahead, slip) = p.b;
    at.jacobian(ahead, ahead) = p.a;
    at.jacobian(back, gap) = s * whole.mu * q.b;
    at.jacobian(back, slip) = -q.b;
    at.jacobian(back, back) = q.a;
  }
  return at;
}
// [whole]

/// A run of Newton's method with whole steps.
struct WholeRun {
  VectorXd x;
  std::vector<double> residuals;  ///< largest entry of |F|, before every step and after the last
  bool solved = false;
};

/// From U = 0, with a pressure of 1 at every point and no slip, until no entry of F exceeds 1e-10, or for 40 steps.
/// \param whole  the system \return the run
inline WholeRun newton(const WholeSystem& whole) {
  const Index n = whole.run.model.programme.load.size(), m = whole.normal.cols();
  WholeRun run{VectorXd::Zero(n + 4 * m), {}, false};
  run.x.segment(n, m).setConstant(whole.reading == NormalTraction::Pressure ? 1 : -1);
  for (int k = 0; k <= 40; ++k) {
    const WholeState at = evaluate(whole, run.x);
    run.residuals.push_back(at.residual.cwiseAbs().maxCoeff());
    run.solved = run.residuals.back() <= 1e-10;
    if (run.solved || !std::isfinite(run.residuals.back())) break;
    run.x -= at.jacobian.fullPivLu().solve(at.residual);
  }
  return run;
}

}  // namespace ch10

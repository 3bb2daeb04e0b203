#include "signorini/as_printed/friction_split.hpp"

#include <algorithm>
#include <utility>

#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/solvers/friction_descent.hpp"
#include "signorini/solvers/friction_newton.hpp"
#include "signorini/solvers/friction_proofs.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is taken off the diagonal of u+ and u-. An entry of a regular Jacobian loses no digit that a
/// Newton step needs; where both entries vanish, 1e-10 still leaves six digits of their difference.
constexpr double shift = 1e-10;

// The law: phi(u+, b + tau) = 0, phi(u-, b - tau) = 0, slip = u+ - u-.
Index first_forward(const FrictionEquations& equations) {
  return 2 * equations.pairs() + equations.modes();
}

void start(const FrictionEquations& equations, VectorXd& x) {
  const Index n = equations.pairs();
  const Index plus = first_forward(equations);
  x.segment(plus, n) = equations.movement().tail(n).cwiseMax(0.0);
  x.segment(plus + n, n) = (-equations.movement().tail(n)).cwiseMax(0.0);
}

void evaluate(const FrictionEquations& equations, const VectorXd& x, VectorXd& residual) {
  const Index n = equations.pairs();
  for (Index i = 0; i < n; ++i) {
    const Index plus = first_forward(equations) + i;
    const double b = equations.bound(x, i);
    residual(n + i) = equations.movement()(n + i) - x(plus) + x(plus + n);  // LinEtAl 19
    residual(plus) = fischer_burmeister(x(plus), b + x(n + i));             // LinEtAl 29
    residual(plus + n) = fischer_burmeister(x(plus + n), b - x(n + i));
  }
}

void differentiate(const FrictionEquations& equations, const VectorXd& x, Eigen::MatrixXd& J) {
  const Index n = equations.pairs();
  for (Index i = 0; i < n; ++i) {
    const Index plus = first_forward(equations) + i;
    const Index minus = plus + n;
    const double b = equations.bound(x, i);
    const double slope = equations.bound_slope(x, i);
    J(n + i, plus) = -1;
    J(n + i, minus) = 1;
    const ComplementaritySlope ahead = fischer_burmeister_slope(x(plus), b + x(n + i));
    J(plus, plus) = ahead.a - shift;
    J(plus, n + i) = ahead.b;
    J(plus, i) = ahead.b * slope;
    const ComplementaritySlope back = fischer_burmeister_slope(x(minus), b - x(n + i));
    J(minus, minus) = back.a - shift;
    J(minus, n + i) = -back.b;
    J(minus, i) = back.b * slope;
  }
}

constexpr FrictionFormulation split = {2, start, evaluate, differentiate};

}  // namespace

FrictionState friction_split(const FrictionProblem& problem, const SolverOptions& options) {
  const ScaledFriction scaled = equilibrate(problem);
  if (VectorXd way = escape(scaled); way.size() > 0)
    return escaping(problem, scaled, std::move(way));
  FrictionPoint point = friction_start(scaled);
  descend(scaled, split, options.iteration_limit > 0 ? options.iteration_limit : newton_limit,
          point);
  return finished_state(problem, scaled, std::move(point));
}

}  // namespace signorini

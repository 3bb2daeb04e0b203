#include "signorini/solvers/friction_newton.hpp"

#include <utility>

#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/solvers/friction_active_set.hpp"
#include "signorini/solvers/friction_descent.hpp"
#include "signorini/solvers/friction_lemke.hpp"
#include "signorini/solvers/friction_proofs.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The law: phi(tau + b, phi(b - tau, -slip)) = 0.
void evaluate(const FrictionEquations& equations, const VectorXd& x, VectorXd& residual) {
  const Index n = equations.pairs();
  for (Index i = 0; i < n; ++i) {
    const double b = equations.bound(x, i);
    const double inner = fischer_burmeister(b - x(n + i), -equations.movement()(n + i));
    residual(n + i) = fischer_burmeister(x(n + i) + b, inner);
  }
}

void differentiate(const FrictionEquations& equations, const VectorXd& x, Eigen::MatrixXd& J) {
  const Index n = equations.pairs();
  for (Index i = 0; i < n; ++i) {
    const double b = equations.bound(x, i);
    const double tau = x(n + i);
    const double slip = equations.movement()(n + i);
    const ComplementaritySlope in = fischer_burmeister_slope(b - tau, -slip);
    const ComplementaritySlope out =
        fischer_burmeister_slope(tau + b, fischer_burmeister(b - tau, -slip));
    J.row(n + i) *= -out.b * in.b;
    J(n + i, n + i) += out.a - out.b * in.a;
    J(n + i, i) += (out.a + out.b * in.a) * equations.bound_slope(x, i);
  }
}

constexpr FrictionFormulation nested = {0, nullptr, evaluate, differentiate};

}  // namespace

void follow_newton(const ScaledFriction& problem, Eigen::Index limit, FrictionPoint& point) {
  descend(problem, nested, limit, point);
}

FrictionState friction_newton(const FrictionProblem& problem, const SolverOptions& options) {
  const ScaledFriction scaled = equilibrate(problem);
  if (VectorXd way = escape(scaled); way.size() > 0)
    return escaping(problem, scaled, std::move(way));
  FrictionPoint point = friction_start(scaled);
  const bool limited = options.iteration_limit > 0;
  follow_newton(scaled, limited ? options.iteration_limit : newton_limit, point);
  if (!point.closure.confirmed && !limited) exchange_motions(scaled, exchange_limit, point);
  if (!point.closure.confirmed && !limited) follow_lemke(scaled, {}, point);
  return finished_state(problem, scaled, std::move(point));
}

}  // namespace signorini

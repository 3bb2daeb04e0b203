#include "signorini/as_printed/friction_split.hpp"

#include <utility>

#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/closing/proofs.hpp"
#include "signorini/solvers/newton.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is taken off the diagonal of u+ and u-. An entry of a regular Jacobian loses no digit that a
/// Newton step needs; where both entries vanish, 1e-10 still leaves six digits of their difference.
constexpr double shift = 1e-10;

// The law: phi(u+, b + tau) = 0, phi(u-, b - tau) = 0, slip = u+ - u-.
Index first_forward(const ContactEquations& equations) {
  return equations.rows() + equations.modes();
}

void start(const ContactEquations& equations, VectorXd& x) {
  const Index slips = equations.slips();
  const Index plus = first_forward(equations);
  x.segment(plus, slips) = equations.movement().tail(slips).cwiseMax(0.0);
  x.segment(plus + slips, slips) = (-equations.movement().tail(slips)).cwiseMax(0.0);
}

void evaluate(const ContactEquations& equations, const VectorXd& x, VectorXd& residual) {
  const Index slips = equations.slips();
  for (Index k = 0; k < slips; ++k) {
    const Index row = equations.pairs() + k;
    const Index plus = first_forward(equations) + k;
    const double b = equations.bound(x, k);
    residual(row) = equations.movement()(row) - x(plus) + x(plus + slips);  // LinEtAl 19
    residual(plus) = fischer_burmeister(x(plus), b + x(row));               // LinEtAl 29
    residual(plus + slips) = fischer_burmeister(x(plus + slips), b - x(row));
  }
}

void differentiate(const ContactEquations& equations, const VectorXd& x, Eigen::MatrixXd& J) {
  const Index slips = equations.slips();
  for (Index k = 0; k < slips; ++k) {
    const Index row = equations.pairs() + k;
    const Index plus = first_forward(equations) + k;
    const Index minus = plus + slips;
    const double b = equations.bound(x, k);
    const double slope = equations.bound_slope(x, k);
    J(row, plus) = -1;
    J(row, minus) = 1;
    const ComplementaritySlope ahead = fischer_burmeister_slope(x(plus), b + x(row));
    J(plus, plus) = ahead.a - shift;
    J(plus, row) = ahead.b;
    J(plus, equations.pair(k)) = ahead.b * slope;
    const ComplementaritySlope back = fischer_burmeister_slope(x(minus), b - x(row));
    J(minus, minus) = back.a - shift;
    J(minus, row) = -back.b;
    J(minus, equations.pair(k)) = back.b * slope;
  }
}

constexpr Formulation split = {2, start, evaluate, differentiate};

}  // namespace

ContactState friction_split(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  if (auto away = pulled_away(problem, scaled)) return *away;
  Attempt attempt = first_attempt(scaled);
  follow_newton(scaled, split, options.iteration_limit > 0 ? options.iteration_limit : newton_limit,
                attempt);
  return finished(problem, scaled, std::move(attempt));
}

}  // namespace signorini

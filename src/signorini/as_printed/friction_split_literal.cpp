#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "signorini/as_printed/friction_split.hpp"
#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/friction_descent.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The unknowns (lambda, tau, a, u+, u-) and what follows from them.
struct Iterate {
  VectorXd x;
  VectorXd movement;  ///< gaps, then slips
  VectorXd residual;
};

/// \PaperEq{LinEtAl, 30}
void evaluate(const FrictionProblem& problem, Iterate& now) {
  const Index n = problem.free_gap.size();
  const Index k = problem.resultant.size();
  const Index plus = 2 * n + k;
  now.movement << problem.free_gap, problem.free_slip;
  now.movement.noalias() += problem.compliance * now.x.head(2 * n);
  if (k > 0) {
    now.movement.noalias() += problem.rigid * now.x.segment(2 * n, k);
    now.residual.segment(2 * n, k) = -problem.resultant;
    now.residual.segment(2 * n, k).noalias() += problem.rigid.transpose() * now.x.head(2 * n);
  }
  for (Index i = 0; i < n; ++i) {
    const double tau = now.x(n + i);
    const double ahead = now.x(plus + i);
    const double back = now.x(plus + n + i);
    const double bound = problem.cohesion(i) + problem.coefficient(i) * now.x(i);
    now.residual(i) = fischer_burmeister(now.movement(i), now.x(i));  // LinEtAl 28
    now.residual(n + i) = now.movement(n + i) - ahead + back;         // LinEtAl 19
    now.residual(plus + i) = fischer_burmeister(ahead, bound + tau);  // LinEtAl 29
    now.residual(plus + n + i) = fischer_burmeister(back, bound - tau);
  }
}

/// \PaperEq{LinEtAl, 31}, without the displacements
void jacobian(const FrictionProblem& problem, const Iterate& now, MatrixXd& J) {
  const Index n = problem.free_gap.size();
  const Index k = problem.resultant.size();
  const Index plus = 2 * n + k;
  J.setZero();
  J.topLeftCorner(2 * n, 2 * n) = problem.compliance;
  if (k > 0) {
    J.block(0, 2 * n, 2 * n, k) = problem.rigid;
    J.block(2 * n, 0, k, 2 * n) = problem.rigid.transpose();
  }
  for (Index i = 0; i < n; ++i) {
    const double mu = problem.coefficient(i);
    const double bound = problem.cohesion(i) + mu * now.x(i);
    const auto normal = fischer_burmeister_slope(now.movement(i), now.x(i));
    const auto ahead = fischer_burmeister_slope(now.x(plus + i), bound + now.x(n + i));
    const auto back = fischer_burmeister_slope(now.x(plus + n + i), bound - now.x(n + i));
    J.row(i) *= normal.a;
    J(i, i) += normal.b;
    J(n + i, plus + i) = -1;
    J(n + i, plus + n + i) = 1;
    J(plus + i, plus + i) = ahead.a;
    J(plus + i, n + i) = ahead.b;
    J(plus + i, i) = mu * ahead.b;
    J(plus + n + i, plus + n + i) = back.a;
    J(plus + n + i, n + i) = -back.b;
    J(plus + n + i, i) = mu * back.b;
  }
}

/// In words, what makes the Jacobian singular: a pair whose two slip equations do not know u+ and u-.
std::string singular(const FrictionProblem& problem, const Iterate& now) {
  const Index n = problem.free_gap.size();
  const Index plus = 2 * n + problem.resultant.size();
  const auto free = [](double slope) { return std::abs(slope) < 1e-6; };
  for (Index i = 0; i < n; ++i) {
    const double bound = problem.cohesion(i) + problem.coefficient(i) * now.x(i);
    if (free(fischer_burmeister_slope(now.x(plus + i), bound + now.x(n + i)).a) &&
        free(fischer_burmeister_slope(now.x(plus + n + i), bound - now.x(n + i)).a))
      return text("the Jacobian is singular: pair ", i + 1, " has c + mu f_n = ", bound,
                  ", where u+ and u- enter only by their difference");
  }
  return "the Jacobian is singular, and not by u+ and u-: too few pairs are closed for the rigid "
         "modes, "
         "or pairs repeat each other";
}

FrictionState state_of(const FrictionProblem& problem, const Iterate& now) {
  const Index n = problem.free_gap.size();
  FrictionState state;
  state.force = now.x.head(n);
  state.friction = now.x.segment(n, n);
  state.amplitude = now.x.segment(2 * n, problem.resultant.size());
  state.gap = now.movement.head(n);
  state.slip = now.movement.tail(n);
  for (Index i = 0; i < n; ++i) {
    const double bound = problem.cohesion(i) + problem.coefficient(i) * state.force(i);
    const double reserve = bound - std::abs(state.friction(i));
    state.status.push_back(state.force(i) <= state.gap(i)      ? PairStatus::Open
                           : reserve > std::abs(state.slip(i)) ? PairStatus::Stick
                                                               : PairStatus::Slip);
  }
  return state;
}

/// No displacement and no force; or for bodies with rigid modes the forces of friction_start(), since from
/// no force at all no pair would hold the modes.
Iterate first_iterate(const FrictionProblem& problem) {
  const Index n = problem.free_gap.size();
  const Index size = 4 * n + problem.resultant.size();
  Iterate now{VectorXd::Zero(size), VectorXd(2 * n), VectorXd(size)};
  if (problem.resultant.size() > 0) {
    const ScaledFriction scaled = equilibrate(problem);
    now.x.head(2 * n) = scaled.scale.cwiseProduct(friction_start(scaled).closure.force);
  }
  evaluate(problem, now);
  return now;
}

/// Newton's method until the residual, once below the tolerance, falls no more: its steps are cheap there.
/// \return why it ended, if not there
std::string iterate(const FrictionProblem& problem, const SolverOptions& options, Iterate& now,
                    Report& report) {
  const Index n = problem.free_gap.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 50;
  const double first = now.residual.norm();
  MatrixXd J(now.x.size(), now.x.size());
  LuFactor factor;
  report.status = Status::IterationLimit;
  double last = std::numeric_limits<double>::infinity();
  while (now.residual.norm() > 0 &&
         (now.residual.norm() > options.tolerance * first || now.residual.norm() < last)) {
    if (report.iterations >= limit) break;
    last = now.residual.norm();
    jacobian(problem, now, J);
    factor = LuFactor(J);
    ++report.factorisations;
    if (!(factor.rcond() > epsilon)) {
      report.status = Status::Breakdown;
      return singular(problem, now);
    }
    now.x -= factor.solve(now.residual);
    ++report.iterations;
    evaluate(problem, now);
    Iteration entry{};
    entry.active = (now.x.head(n).array() > now.movement.head(n).array()).count();
    entry.residual = first == 0 ? 0 : now.residual.norm() / first;
    report.history.push_back(entry);
  }
  return "Newton's method did not come to rest";
}

}  // namespace

FrictionState friction_split_literal(const FrictionProblem& problem, const SolverOptions& options) {
  check_problem(problem);
  Iterate now = first_iterate(problem);
  const double first = now.residual.norm();
  Report report;
  std::string reason = iterate(problem, options, now, report);
  FrictionState state = state_of(problem, now);
  if (now.residual.norm() <= options.tolerance * first) {
    const bool contact = certify(problem, state).holds();
    report.status = contact ? Status::Solved : Status::Breakdown;
    reason = contact ? "" : "the printed equations are solved, but contact is not";
  }
  state.report = std::move(report);
  state.reason = std::move(reason);
  return state;
}

}  // namespace signorini

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "signorini/as_printed/friction_split.hpp"
#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/newton.hpp"

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

/// Where the parts of x begin, and the bound c + mu lambda of slip k.
struct Layout {
  explicit Layout(const ContactProblem& problem)
      : pairs(problem.free_gap.size()),
        slips(problem.free_slip.size()),
        modes(problem.resultant.size()),
        law(problem.law) {}
  [[nodiscard]] Index rows() const { return pairs + slips; }
  [[nodiscard]] Index plus() const { return rows() + modes; }
  [[nodiscard]] Index size() const { return plus() + 2 * slips; }
  [[nodiscard]] Index pair(Index k) const { return law.pair[static_cast<std::size_t>(k)]; }
  [[nodiscard]] double bound(const VectorXd& x, Index k) const {
    return law.cohesion(k) + law.coefficient(k) * x(pair(k));
  }
  Index pairs;
  Index slips;
  Index modes;
  const FrictionLaw& law;
};

/// \PaperEq{LinEtAl, 30}
void evaluate(const ContactProblem& problem, Iterate& now) {
  const Layout at(problem);
  now.movement = free_movement(problem);
  now.movement.noalias() += problem.compliance * now.x.head(at.rows());
  if (at.modes > 0) {
    now.movement.noalias() += problem.rigid * now.x.segment(at.rows(), at.modes);
    now.residual.segment(at.rows(), at.modes) = -problem.resultant;
    now.residual.segment(at.rows(), at.modes).noalias() +=
        problem.rigid.transpose() * now.x.head(at.rows());
  }
  for (Index i = 0; i < at.pairs; ++i)
    now.residual(i) = fischer_burmeister(now.movement(i), now.x(i));  // LinEtAl 28
  for (Index k = 0; k < at.slips; ++k) {
    const Index row = at.pairs + k;
    const double ahead = now.x(at.plus() + k);
    const double back = now.x(at.plus() + at.slips + k);
    const double bound = at.bound(now.x, k);
    now.residual(row) = now.movement(row) - ahead + back;                         // LinEtAl 19
    now.residual(at.plus() + k) = fischer_burmeister(ahead, bound + now.x(row));  // LinEtAl 29
    now.residual(at.plus() + at.slips + k) = fischer_burmeister(back, bound - now.x(row));
  }
}

/// \PaperEq{LinEtAl, 31}, without the displacements
void jacobian(const ContactProblem& problem, const Iterate& now, MatrixXd& J) {
  const Layout at(problem);
  J.setZero();
  J.topLeftCorner(at.rows(), at.rows()) = problem.compliance;
  if (at.modes > 0) {
    J.block(0, at.rows(), at.rows(), at.modes) = problem.rigid;
    J.block(at.rows(), 0, at.modes, at.rows()) = problem.rigid.transpose();
  }
  for (Index i = 0; i < at.pairs; ++i) {
    const auto normal = fischer_burmeister_slope(now.movement(i), now.x(i));
    J.row(i) *= normal.a;
    J(i, i) += normal.b;
  }
  for (Index k = 0; k < at.slips; ++k) {
    const Index row = at.pairs + k;
    const Index plus = at.plus() + k;
    const Index minus = plus + at.slips;
    const double mu = at.law.coefficient(k);
    const double bound = at.bound(now.x, k);
    const auto ahead = fischer_burmeister_slope(now.x(plus), bound + now.x(row));
    const auto back = fischer_burmeister_slope(now.x(minus), bound - now.x(row));
    J(row, plus) = -1;
    J(row, minus) = 1;
    J(plus, plus) = ahead.a;
    J(plus, row) = ahead.b;
    J(plus, at.pair(k)) = mu * ahead.b;
    J(minus, minus) = back.a;
    J(minus, row) = -back.b;
    J(minus, at.pair(k)) = mu * back.b;
  }
}

/// In words, what makes the Jacobian singular: a pair whose two slip equations do not know u+ and u-.
std::string singular(const ContactProblem& problem, const Iterate& now) {
  const Layout at(problem);
  const auto free = [](double slope) { return std::abs(slope) < 1e-6; };
  for (Index k = 0; k < at.slips; ++k) {
    const double bound = at.bound(now.x, k);
    const double tau = now.x(at.pairs + k);
    if (free(fischer_burmeister_slope(now.x(at.plus() + k), bound + tau).a) &&
        free(fischer_burmeister_slope(now.x(at.plus() + at.slips + k), bound - tau).a))
      return text("the Jacobian is singular: pair ", at.pair(k) + 1, " has c + mu f_n = ", bound,
                  ", where u+ and u- enter only by their difference");
  }
  return "the Jacobian is singular, and not by u+ and u-: too few pairs are closed for the rigid "
         "modes, "
         "or pairs repeat each other";
}

ContactState state_of(const ContactProblem& problem, const Iterate& now) {
  const Layout at(problem);
  ContactState state;
  state.force = now.x.head(at.pairs);
  state.friction = now.x.segment(at.pairs, at.slips);
  state.amplitude = now.x.segment(at.rows(), at.modes);
  state.gap = now.movement.head(at.pairs);
  state.slip = now.movement.tail(at.slips);
  for (Index i = 0; i < at.pairs; ++i)
    if (state.force(i) > state.gap(i)) state.active.push_back(i);
  state.rubbing = at.law.pair;
  for (Index k = 0; k < at.slips; ++k) {
    const double reserve = at.bound(now.x, k) - std::abs(state.friction(k));
    const double slip = state.slip(k);
    state.motion.push_back(state.force(at.pair(k)) <= state.gap(at.pair(k)) ? Motion::Open
                           : reserve > std::abs(slip)                       ? Motion::Stick
                           : slip > 0                                       ? Motion::Forward
                                                                            : Motion::Backward);
  }
  return state;
}

/// No displacement and no force; or for bodies with rigid modes the forces of first_attempt(), since from
/// no force at all no pair would hold the modes.
Iterate first_iterate(const ContactProblem& problem) {
  const Layout at(problem);
  Iterate now{VectorXd::Zero(at.size()), VectorXd(at.rows()), VectorXd(at.size())};
  if (at.modes > 0) {
    const ScaledProblem scaled = equilibrate(problem);
    now.x.head(at.rows()) = scaled.scale.cwiseProduct(first_attempt(scaled).closure.force);
  }
  evaluate(problem, now);
  return now;
}

/// Newton's method until the residual, once below the tolerance, falls no more: its steps are cheap there.
/// \return why it ended, if not there
std::string iterate(const ContactProblem& problem, const SolverOptions& options, Iterate& now,
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

ContactState friction_split_literal(const ContactProblem& problem, const SolverOptions& options) {
  check_problem(problem);
  Iterate now = first_iterate(problem);
  const double first = now.residual.norm();
  Report report;
  std::string reason = iterate(problem, options, now, report);
  ContactState state = state_of(problem, now);
  if (now.residual.norm() <= options.tolerance * first) {
    for (Index i = 0; i < state.force.size(); ++i)  // the smaller of the two is rounding
      (state.force(i) > state.gap(i) ? state.gap : state.force)(i) = 0;
    const bool contact = certify(problem, state).holds();
    report.status = contact ? Status::Solved : Status::Breakdown;
    reason = contact ? "" : "the printed equations are solved, but contact is not";
  }
  state.report = std::move(report);
  state.reason = std::move(reason);
  return state;
}

}  // namespace signorini

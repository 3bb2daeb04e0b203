// # The slip in two parts
//
// Coulomb's law has three cases: a pair sticks, slides forwards or slides backwards. Lin et al.
// write it with two conditions of the kind that contact has already. The slip is the difference of
// two parts that are not negative, and each part has a condition with the friction that is left on
// its side,
// \f[ \text{slip} = u^+ - u^-, \qquad \varphi(u^+, b + \tau) = 0, \qquad \varphi(u^-, b - \tau) = 0, \qquad b = c + \mu\lambda, \f]
// where \f$ \varphi \f$ is the Fischer-Burmeister function: \f$ \varphi(x, y) = 0 \f$ says that x
// and y are not negative and one of them is zero. So \f$ u^+ > 0 \f$ needs \f$ \tau = -b \f$: who
// slides forwards is held back with all the friction there is.
//
// One pair with \f$ b = 0.5 \f$ whose slip is \f$ 1 + \tau \f$: with \f$ \tau = -0.5 \f$ it slides
// by 0.5, so \f$ u^+ = 0.5 \f$ and \f$ u^- = 0 \f$; the two conditions are
// \f$ \varphi(0.5, 0) = 0 \f$ and \f$ \varphi(0, 1) = 0 \f$. With \f$ b = 2 \f$ it sticks,
// \f$ \tau = -1 \f$, and both parts are zero.
//
// The weak place is \f$ b = 0 \f$, as at every open pair without cohesion. Both conditions then say
// only \f$ \tau = 0 \f$, the parts may grow together, and where both are positive the Jacobian is
// singular.
// [Chapter 8](../../chapters/ch08_complementarity/README.md) has the table. This file has the
// equations, Newton's method on them, and what makes it work.

#include "papers/friction_split.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/complementarity_functions.hpp"
#include "signorini/problem/contact_equations.hpp"
#include "signorini/solvers/newton.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// What is taken off the diagonal of u+ and u-. An entry of a regular Jacobian loses no digit that a
/// Newton step needs; where both entries vanish, 1e-10 still leaves six digits of their difference.
constexpr double shift = 1e-10;

// The law: phi(u+, b + tau) = 0, phi(u-, b - tau) = 0, slip = u+ - u-. The unknowns are those of
// ContactEquations, forces and amplitudes, and behind them all \f$ u^+ \f$ and then all
// \f$ u^- \f$.
Index first_forward(const ContactEquations& equations) {
  return equations.rows() + equations.modes();
}

// At the start each slip is one part alone.
void start(const ContactEquations& equations, VectorXd& x) {
  const Index slips = equations.slips();
  const Index plus = first_forward(equations);
  x.segment(plus, slips) = equations.movement().tail(slips).cwiseMax(0.0);
  x.segment(plus + slips, slips) = (-equations.movement().tail(slips)).cwiseMax(0.0);
}

// \PaperEq{LinEtAl, 30}
// Three equations for each pair with friction: the split itself, and a condition for each part.
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

// \PaperEq{LinEtAl, 31}, without the displacements
// Each of the three has entries in the columns of its own part, of \f$ \tau \f$ and, through the
// bound b, of \f$ \lambda \f$.
void jacobian(const ContactEquations& equations, const VectorXd& x, MatrixXd& J) {
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
    J(plus, plus) = ahead.a;
    J(plus, row) = ahead.b;
    J(plus, equations.pair(k)) = ahead.b * slope;
    const ComplementaritySlope back = fischer_burmeister_slope(x(minus), b - x(row));
    J(minus, minus) = back.a;
    J(minus, row) = -back.b;
    J(minus, equations.pair(k)) = back.b * slope;
  }
}

// The repair lowers two entries of each pair with friction by \f$ 10^{-10} \f$. It changes the step
// and not the equations, so the solution stays where it is.
void shifted_jacobian(const ContactEquations& equations, const VectorXd& x, MatrixXd& J) {
  jacobian(equations, x, J);
  J.diagonal().tail(2 * equations.slips()).array() -= shift;
}

// The two methods of this file are the same equations with different Jacobians, starts and readings
// of the bound.
constexpr Formulation mended = {2, start, evaluate, shifted_jacobian};
constexpr Formulation printed = {2, nullptr, evaluate, jacobian, Reading::AsPrinted};

// A problem that is not scaled, in the form of one that is.
// The paper compares lengths with forces as they come. To do the same, the printed method gets a
// problem whose scales are all 1.
// Rows of friction and rigid modes are handed on as they are.
ScaledProblem unscaled(const ContactProblem& problem) {
  const Index modes = problem.resultant.size();
  const VectorXd free = free_movement(problem);
  return {problem.compliance,
          free,
          VectorXd::Ones(free.size()),
          true,
          problem.law,
          problem.rigid,
          problem.resultant,
          MatrixXd::Identity(modes, modes)};
}

// In words, what makes the Jacobian singular: a pair whose two slip equations do not know u+ and u-.
// A user who sees the printed method break down wants to know where. The slope of \f$ \varphi \f$
// with respect to a part is zero if that part is positive and the friction left on its side is
// zero. If this happens to both parts of a pair, that pair is named.
std::string singular(const ContactEquations& equations, const VectorXd& x) {
  const auto free = [](double slope) { return std::abs(slope) < 1e-6; };
  for (Index k = 0; k < equations.slips(); ++k) {
    const Index plus = first_forward(equations) + k;
    const double b = equations.bound(x, k);
    const double tau = x(equations.pairs() + k);
    if (free(fischer_burmeister_slope(x(plus), b + tau).a) &&
        free(fischer_burmeister_slope(x(plus + equations.slips()), b - tau).a))
      return text("the Jacobian is singular: pair ", equations.pair(k) + 1, " has c + mu f_n = ", b,
                  ", where u+ and u- enter only by their difference");
  }
  return "the Jacobian is singular, and not by u+ and u-: too few pairs are closed for the rigid "
         "modes, or pairs repeat each other";
}

// Newton's method until the residual, once below the tolerance, falls no more: its steps are cheap there.
// \return why it ended, or nothing if there
// No step is shortened here, and none is checked. Whole steps, the columns of u+ and u- and the test are
// ours; the paper names none.
// Below the tolerance it goes on as long as the residual falls: near a solution each step doubles
// the digits, and one or two steps more give all that there are.
std::string newton_iterations(ContactEquations& equations, const SolverOptions& options,
                              VectorXd& x, Report& report) {
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 50;
  const Index pairs = equations.pairs();
  VectorXd residual(x.size());
  MatrixXd J(x.size(), x.size());
  equations.evaluate(x, residual);
  const double first = residual.norm();
  const double enough = options.tolerance * first;
  double last = std::numeric_limits<double>::infinity();
  while (residual.norm() > 0 && (residual.norm() > enough || residual.norm() < last) &&
         report.iterations < limit) {
    last = residual.norm();
    equations.differentiate(x, J);
    const LuFactor factor(J);
    ++report.factorisations;
    if (!(factor.rcond() > epsilon)) {
      if (last > enough) return singular(equations, x);
      break;
    }
    x -= factor.solve(residual);
    ++report.iterations;
    equations.evaluate(x, residual);
    Iteration entry{};
    entry.active = (x.head(pairs).array() > equations.movement().head(pairs).array()).count();
    entry.residual = residual.norm() / first;
    report.history.push_back(entry);
  }
  report.status = residual.norm() <= enough ? SolveStatus::Solved : SolveStatus::IterationLimit;
  return report.status == SolveStatus::Solved ? "" : "Newton's method did not come to rest";
}

}  // namespace

// Without force nothing holds a body that only contact holds, and the first Jacobian would be
// singular. In that case the method starts from forces that balance the load.
ContactState friction_split_literal(const ContactProblem& problem, const SolverOptions& options) {
  check_problem(problem);
  const ScaledProblem raw = unscaled(problem);
  ContactEquations equations(raw, printed);
  VectorXd x = VectorXd::Zero(equations.size());
  if (equations.modes() > 0) {  // from no force at all no pair would hold the modes
    const ScaledProblem scaled = equilibrate(problem);
    x.head(equations.rows()) = scaled.scale.cwiseProduct(first_iterate(scaled).solution.force);
  }
  equations.choose_closed(x);
  Report report;
  std::string reason = newton_iterations(equations, options, x, report);
  ActiveSetSolution end;
  equations.read(x, end);
  std::vector<ContactStatus> statuses = statuses_of({}, equations.pairs());
  predict(raw, end, 1, statuses);
  if (report.status == SolveStatus::Solved)  // the smaller of force and gap is rounding
    for (std::size_t i = 0; i < statuses.size(); ++i)
      if (statuses[i] == ContactStatus::Open) end.force(static_cast<Index>(i)) = 0;
  const bool solved = report.status == SolveStatus::Solved;
  ContactState state = finished(problem, raw, end, statuses, std::move(report));
  state.reason = solved && state.report.status != SolveStatus::Solved
                     ? "the printed equations are solved, but contact is not"
                     : std::move(reason);
  return state;
}

// The repaired method is the Newton method of the library with these equations in the place of its
// own.
ContactState friction_split(const ContactProblem& problem, const SolverOptions& options) {
  const ScaledProblem scaled = equilibrate(problem);
  Iterate iterate = first_iterate(scaled);
  follow_newton(scaled, mended,
                options.iteration_limit > 0 ? options.iteration_limit : newton_limit, iterate);
  return finished(problem, scaled, std::move(iterate));
}

}  // namespace signorini

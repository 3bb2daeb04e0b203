// # Newton's method with a line search
//
// The equations \f$ \Phi(x) = 0 \f$ are contact, and friction, written with the Fischer-Burmeister
// function. A step solves
// \f[ J\,p = -\Phi(x), \qquad J = \frac{\partial\Phi}{\partial x}. \f]
// At a kink J is one element of the generalised derivative, so this is a semi-smooth Newton method.
// It is fast near a solution. Three things make it a method that one can leave alone.
//
// *The step is shortened.* The merit \f$ m = \tfrac12|\Phi|^2 \f$ falls along p at first, with the
// slope \f$ \Phi^TJp = -|\Phi|^2 = -2m \f$. Armijo's rule halves the step until m has fallen
// enough. So no step makes it larger.
//
// *There is a second direction.* If J is nearly singular, its step may be useless. Then the method
// goes down the gradient \f$ J^T\Phi \f$ of the merit. That exists even where \f$ \Phi \f$ has a
// kink, because the square of \f$ \varphi \f$ is smooth (De Luca, Facchinei and Kanzow 1996).
//
// *The end is exact.* Newton's method comes near the solution, and the signs of what is nearly zero
// stay open. So two iterates that agree on what every pair does are taken as a guess of the closed
// pairs. Their linear system is solved exactly, and all conditions are looked at. Where they do not
// hold, the steps go on from where they were: ends_exactly() in [iterate.cpp](iterate.cpp).
//
// For the one pair with G = 1 and d = -1, \f$ \lambda = 0 \f$ has \f$ \Phi = 2 \f$ and the first
// step \f$ \lambda = 2/3 \f$ has 0.41. No such step is made: the pair overlaps at the start, the
// guess is *closed*, and the exact end is \f$ \lambda = 1 \f$.

#include "signorini/solvers/newton.hpp"

#include <cmath>

#include "signorini/core/dense.hpp"
#include "signorini/core/line_search.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Newton's method with memory of its own. The vectors and J are allocated once. Which pairs carry
// cohesion is decided between the steps, never during one: it would make the merit jump, and the
// line search compares merits.
class Newton {
 public:
  Newton(ContactEquations& equations, VectorXd& x)
      : equations_(equations),
        x_(x),
        trial_(x.size()),
        residual_(x.size()),
        J_(x.size(), x.size()) {
    equations_.choose_closed(x_);
    evaluate();
  }

  /// \return false if the residual falls no more
  bool step() {
    equations_.differentiate(x_, J_);
    factor_ = LuFactor(J_);
    gradient_.noalias() = J_.transpose() * residual_;
    direction_ = -factor_.solve(residual_);
    // An exactly solved Newton step has the slope -|Phi|^2 = -2 merit; half of it may be lost to rounding.
    bool moved = direction_.allFinite() && gradient_.dot(direction_) <= -merit_ && search();
    if (!moved) {  // down the gradient, to the lowest point of the linear model
      const double curvature = (J_ * gradient_).squaredNorm();
      if (!(curvature > 0)) return false;
      direction_ = -(gradient_.squaredNorm() / curvature) * gradient_;
      moved = search();
    }
    equations_.choose_closed(x_);
    evaluate();
    return moved;
  }

  [[nodiscard]] double residual() const { return std::sqrt(2 * merit_); }

 private:
  void evaluate() {
    equations_.evaluate(x_, residual_);
    merit_ = 0.5 * residual_.squaredNorm();
  }
  /// Goes as far along the direction as Armijo's rule allows. \return false if the merit falls no more
  bool search() {
    trial_ = x_;
    const auto merit_at = [&](double length) {
      x_ = trial_ + length * direction_;
      evaluate();
      return merit_;
    };
    if (armijo(merit_, gradient_.dot(direction_), merit_at) > 0) return true;
    x_ = trial_;
    evaluate();
    return false;
  }

  ContactEquations& equations_;
  VectorXd& x_;
  VectorXd trial_;
  VectorXd residual_;
  VectorXd gradient_;
  VectorXd direction_;
  MatrixXd J_;
  LuFactor factor_;
  double merit_ = 0;
};

}  // namespace

// Steps are taken until the statuses settle (two iterates agree), until the residual is rounding,
// until no step lowers it, or until the limit. In each case the exact end is tried. The first
// statuses are tried before any step: on a good start Newton's method has nothing to do.
//
// Statuses that settled and were wrong are no reason to stop. The steps go on until they settle
// anew.
//
// \f$ |\Phi| \f$ is compared with its first value, because its unit is that of the problem. The
// history keeps this ratio.
void follow_newton(const ScaledProblem& problem, const Formulation& form, Index limit,
                   Iterate& iterate) {
  ContactEquations equations(problem, form);
  const double unit = equations.force_scale();
  VectorXd x = equations.unknowns(iterate.solution);
  Newton newton(equations, x);
  Report& report = iterate.report;
  const auto look = [&] {
    equations.read(x, iterate.solution);
    return predict(problem, iterate.solution, unit, iterate.statuses);
  };
  const double first = newton.residual();
  Index last_changes = 1;  // so that the first statuses are tried
  for (Index changes = 0;;) {
    const bool limited = report.iterations >= limit;
    const bool settled = changes == 0 && last_changes > 0;
    const bool rounding =
        newton.residual() <= static_cast<double>(problem.free.size()) * epsilon * first;
    if (!limited && !settled && !rounding && newton.step()) {
      ++report.iterations;
      ++report.factorisations;
      last_changes = changes;
      changes = look();
      Iteration entry = summary(problem, iterate.statuses, iterate.solution, changes);
      entry.residual = first == 0 ? 0 : newton.residual() / first;
      report.history.push_back(entry);
      continue;
    }
    if (ends_exactly(problem, unit, iterate)) return;
    last_changes = 0;
    report.status = limited ? SolveStatus::IterationLimit : SolveStatus::Breakdown;
    iterate.reason = limited
                         ? "Newton's method did not settle on what each pair does"
                         : "no step lowers the residual any more, at a point that is no solution";
    if (!settled) return;
  }
}

}  // namespace signorini

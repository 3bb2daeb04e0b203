#include "signorini/solvers/newton.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "signorini/core/line_search.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Newton's method with memory of its own.
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

/// What statuses say is closed, the pairs whose force exceeds their gap most first.
ActiveSet clearest_first(const ScaledProblem& problem, const Iterate& iterate, double force_scale,
                         const std::vector<ContactStatus>& statuses) {
  ActiveSet set = active_set(statuses, problem.law);
  if (!problem.law.pair.empty()) return set;
  const VectorXd excess = force_scale * iterate.solution.force - iterate.solution.movement;
  std::stable_sort(set.closed.begin(), set.closed.end(),
                   [&](Index i, Index j) { return excess(i) > excess(j); });
  return set;
}

/// Opens closed pairs without a force, if that is a solution as well: a pair that only touches holds nothing.
void open_idle_pairs(const ScaledProblem& problem, Iterate& iterate) {
  const ActiveSetSolution& end = iterate.solution;
  std::vector<Index> pressed;
  for (const Index i : closed_pairs(iterate.statuses))
    if (end.force(i) > end.force_rounding) pressed.push_back(i);
  if (pressed.size() == end.rows.size()) return;
  if (Confirmed other = confirmed(problem, pressed, &end))
    std::tie(iterate.solution, iterate.statuses) = std::move(*other);
}

/// The exact end from the statuses of an iterate, or from those which that end asks for: of a pair that touches
/// without force, rounding decides the side.
bool ends(const ScaledProblem& problem, double force_scale, Iterate& iterate) {
  std::vector<ContactStatus> statuses = iterate.statuses;
  ActiveSetSolution start = iterate.solution;
  const bool frictional = !problem.law.pair.empty();
  if (!frictional) start.force.setZero();
  for (int trial = 0; trial < (problem.symmetric ? 2 : 1); ++trial) {
    const ActiveSet set = clearest_first(problem, iterate, force_scale, statuses);
    iterate.report.factorisations += set.closed.empty() ? 0 : 1;
    ActiveSetSolution end = solve_active_set(problem, set, &start);
    const std::vector<ContactStatus> closed =
        frictional ? statuses : statuses_of(end.rows, problem.pairs());
    if (solves(problem, closed, end)) {
      iterate.solution = std::move(end);
      iterate.statuses = closed;
      iterate.confirmed = true;
      if (!frictional) open_idle_pairs(problem, iterate);
      return true;
    }
    statuses = closed;
    if (!end.solvable || predict(problem, end, force_scale, statuses) == 0) return false;
  }
  return false;
}

}  // namespace

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
    if (ends(problem, unit, iterate)) return;
    last_changes = 0;
    report.status = limited ? SolveStatus::IterationLimit : SolveStatus::Breakdown;
    iterate.reason = limited
                         ? "Newton's method did not settle on what each pair does"
                         : "no step lowers the residual any more, at a point that is no solution";
    if (!settled) return;
  }
}

}  // namespace signorini

#include "signorini/solvers/newton.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "addons/certified/proofs.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What Armijo's rule asks of a step: this part of the decrease that the slope promises. Any number
/// below 1/2 lets the full Newton step pass near a solution.
constexpr double enough = 1e-4;

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
  /// Halves the step until the merit falls by enough.
  bool search() {
    const double slope = gradient_.dot(direction_);
    const double merit = merit_;
    trial_ = x_;
    for (double length = 1; length > epsilon; length /= 2) {
      x_ = trial_ + length * direction_;
      evaluate();
      if (merit_ <= merit + enough * length * slope && merit_ < merit) return true;
    }
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

Iterate first_iterate(const ScaledProblem& problem) {
  const Index pairs = problem.pairs();
  const MatrixXd& U = problem.rigid;
  Iterate iterate;
  ActiveSetSolution& now = iterate.solution;
  now.force.setZero(problem.free.size());
  now.amplitude.setZero(U.cols());
  double unit = force_scale(problem);
  if (U.cols() > 0) {
    unit = ContactEquations(problem, nested_friction).force_scale();
    now.force = U * problem.resultant;
    now.amplitude = -U.transpose() * (problem.free + problem.compliance * now.force);
  } else if (!problem.law.pair.empty() && problem.symmetric && problem.sparse.size() == 0) {
    const ContactState normal =
        goldfarb_idnani({problem.compliance.topLeftCorner(pairs, pairs), problem.free.head(pairs)});
    if (normal.report.status == SolveStatus::Solved) now.force.head(pairs) = normal.force;
  }
  now.movement = problem.free + problem.compliance * now.force;
  VectorXd size = problem.free.cwiseAbs() + problem.compliance.cwiseAbs() * now.force.cwiseAbs();
  if (U.cols() > 0) {
    now.movement += U * now.amplitude;
    size += U.cwiseAbs() * now.amplitude.cwiseAbs();
  }
  // A pair that touches is open until something presses it, whatever rounding says of its gap.
  now.movement_rounding = static_cast<double>(size.size() + U.cols() + 1) * epsilon * size;
  iterate.statuses = statuses_of({}, pairs);
  predict(problem, now, unit, iterate.statuses);
  return iterate;
}

ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled, Iterate iterate) {
  Report& report = iterate.report;
  if (iterate.confirmed) {
    report.status = SolveStatus::Solved;
    iterate.reason.clear();
  } else if (report.status == SolveStatus::Solved) {
    report.status = SolveStatus::Breakdown;  // of another problem that was solved on the way
  }
  ContactState state =
      finished(problem, scaled, iterate.solution, iterate.statuses, std::move(report));
  if (state.reason.empty()) state.reason = std::move(iterate.reason);
  if (iterate.confirmed && !scaled.law.pair.empty() && scaled.symmetric)
    state.uniqueness = uniqueness(scaled, iterate.statuses, iterate.solution);
  if (state.uniqueness == Uniqueness::Doubtful)
    state.uniqueness_warning = uniqueness_warning(scaled, iterate.statuses, iterate.solution);
  return state;
}

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

#include "signorini/solvers/fischer_burmeister.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Candidate = std::pair<ClosedPairs, std::vector<Index>>;

/// What Armijo's rule asks of a step: this part of the decrease that the slope promises. Any number
/// below 1/2 lets the full Newton step pass near a solution.
constexpr double enough = 1e-4;

/// An iterate of the equilibrated problem and what follows from it. Forces are measured by the gap that
/// they make: lambda = force / reach.
struct Point {
  VectorXd force;     ///< reach * lambda
  VectorXd gap;       ///< d + G lambda
  VectorXd residual;  ///< Phi
  double merit = 0;   ///< |Phi|^2 / 2
};

/// \PaperEq{LinEtAl, 28}
void evaluate(const ScaledProblem& problem, Point& point) {
  point.gap = problem.free_gap;
  point.gap.noalias() += problem.compliance * point.force;
  for (Index i = 0; i < point.force.size(); ++i)
    point.residual(i) = fischer_burmeister(point.gap(i), point.force(i));
  point.merit = 0.5 * point.residual.squaredNorm();
}

/// J = D_a G + D_b at a point.
void jacobian(const ScaledProblem& problem, const Point& point, Eigen::MatrixXd& J) {
  const Index n = point.force.size();
  VectorXd of_gap(n);
  VectorXd of_force(n);
  for (Index i = 0; i < n; ++i) {
    const ComplementaritySlope slope = fischer_burmeister_slope(point.gap(i), point.force(i));
    of_gap(i) = slope.a;
    of_force(i) = slope.b;
  }
  J = of_gap.asDiagonal() * problem.compliance;
  J.diagonal() += of_force;
}

/// Pairs whose force exceeds their gap, the clearest first.
std::vector<Index> closed_pairs(const Point& point) {
  std::vector<Index> closed;
  const VectorXd excess = point.force - point.gap;
  for (Index i = 0; i < excess.size(); ++i)
    if (excess(i) > 0) closed.push_back(i);
  std::stable_sort(closed.begin(), closed.end(),
                   [&](Index i, Index j) { return excess(i) > excess(j); });
  return closed;
}

/// The exact end, if the set of closed pairs or the one that an active set method takes next is right:
/// of a pair that touches without force, rounding decides the side.
std::optional<Candidate> confirmed_nearby(const ScaledProblem& problem, std::vector<Index> closed) {
  if (auto end = confirmed(problem, closed)) return end;
  std::sort(closed.begin(), closed.end());
  const ClosedPairs now = close_pairs(problem, closed);
  if (!now.solvable) return std::nullopt;
  std::vector<Index> next;
  for (Index i = 0; i < now.force.size(); ++i)
    if (now.force(i) > 0 || now.gap(i) < 0) next.push_back(i);
  return confirmed(problem, next);
}

/// One step of the method, from a point to one with a smaller residual.
class Newton {
 public:
  explicit Newton(const ScaledProblem& problem)
      : problem_(problem), J_(problem.compliance.rows(), problem.compliance.cols()) {}

  /// \return false if the residual falls no more
  bool step(Point& point, Report& report) {
    jacobian(problem_, point, J_);
    factor_ = LuFactor(J_);
    ++report.factorisations;
    gradient_.noalias() = J_.transpose() * point.residual;
    direction_ = -factor_.solve(point.residual);
    // An exactly solved Newton step has the slope -|Phi|^2 = -2 merit; half of it may be lost to rounding.
    if (direction_.allFinite() && gradient_.dot(direction_) <= -point.merit &&
        search(point, gradient_.dot(direction_)))
      return true;
    // Down the gradient, to the lowest point of the linear model of Phi.
    const double curvature = (J_ * gradient_).squaredNorm();
    if (!(curvature > 0)) return false;
    direction_ = -(gradient_.squaredNorm() / curvature) * gradient_;
    return search(point, gradient_.dot(direction_));
  }

 private:
  /// Armijo's rule: halves the step until the merit falls by enough.
  bool search(Point& point, double slope) {
    trial_ = point;
    for (double length = 1; length > epsilon; length /= 2) {
      trial_.force = point.force + length * direction_;
      evaluate(problem_, trial_);
      if (trial_.merit < point.merit && trial_.merit <= point.merit + enough * length * slope) {
        std::swap(point, trial_);
        return true;
      }
    }
    return false;
  }

  const ScaledProblem& problem_;
  Eigen::MatrixXd J_;
  LuFactor factor_;
  VectorXd gradient_;
  VectorXd direction_;
  Point trial_;
};

/// The largest gap that forces 1 on all pairs can make anywhere: the largest sum of a row of |G|.
double reach_of(const Eigen::MatrixXd& G) {
  const double reach = G.size() == 0 ? 0 : G.cwiseAbs().rowwise().sum().maxCoeff();
  return reach > 0 ? reach : 1;
}

Iteration summary(const ScaledProblem& scaled, const Point& point, double reach, Index changes,
                  double first) {
  const auto negative = [](const VectorXd& v) { return std::max(0.0, -v.minCoeff()); };
  Iteration entry;
  entry.active = (point.force.array() > point.gap.array()).count();
  entry.changes = changes;
  entry.penetration = negative(point.gap.cwiseQuotient(scaled.scale));
  entry.tension = negative(scaled.scale.cwiseProduct(point.force)) / reach;
  entry.dual_energy = -0.5 * point.force.dot(scaled.free_gap + point.gap) / reach;
  entry.residual = first == 0 ? 0 : std::sqrt(2 * point.merit) / first;
  return entry;
}

}  // namespace

ContactState fischer_burmeister(const ContactProblem& problem, const SolverOptions& options) {
  const Index n = problem.free_gap.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 10 * n + 100;
  const ScaledProblem scaled = equilibrate_any(problem);
  Point point{VectorXd::Zero(n), VectorXd(n), VectorXd(n)};
  const double reach = reach_of(scaled.compliance);
  const ScaledProblem measured{scaled.compliance / reach, scaled.free_gap, scaled.scale};
  evaluate(measured, point);
  const double first = point.residual.norm();
  Newton newton(measured);
  Report report;
  std::vector<Index> closed = closed_pairs(point);
  Index last_changes = 1;  // so that the first set is tried
  for (Index changes = 0;;) {
    const bool limited = report.iterations >= limit;
    const bool settled = changes == 0 && last_changes > 0;
    const bool rounding = point.residual.norm() <= static_cast<double>(n) * epsilon * first;
    if (!limited && !settled && !rounding && newton.step(point, report)) {
      ++report.iterations;
      last_changes = changes;
      const std::vector<Index> last = std::exchange(closed, closed_pairs(point));
      changes = differences(closed, last);
      report.history.push_back(summary(scaled, point, reach, changes, first));
      continue;
    }
    report.factorisations += closed.empty() ? 0 : 1;
    auto end = scaled.symmetric ? confirmed_nearby(scaled, closed) : confirmed(scaled, closed);
    if (end) {
      report.status = Status::Solved;
      return certified(problem,
                       unscaled(scaled, end->first, std::move(end->second), std::move(report)));
    }
    last_changes = 0;
    report.status = limited ? Status::IterationLimit : Status::Breakdown;
    if (!settled) break;
  }
  std::sort(closed.begin(), closed.end());
  return unscaled(scaled, {point.force / reach, point.gap, {}, {}, false}, closed, report);
}

}  // namespace signorini

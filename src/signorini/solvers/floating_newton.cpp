#include "signorini/solvers/floating_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "signorini/closing/balanced_pairs.hpp"
#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/closing/floating_projection.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Armijo's rule, as in fischer_burmeister.cpp.
constexpr double enough = 1e-4;

/// One step of Newton's method on forces in balance.
class Newton {
 public:
  explicit Newton(const FloatingProjection& problem)
      : problem_(problem),
        J_(MatrixXd::Zero(problem.d.size() + problem.U.cols(),
                          problem.d.size() + problem.U.cols())) {
    J_.bottomLeftCorner(problem.U.cols(), problem.d.size()) = problem.U.transpose();
  }

  /// \return false if the residual falls no more
  bool step(FloatingPoint& point, Report& report) {
    const Index n = problem_.d.size();
    const Index k = problem_.U.cols();
    jacobian(point);
    factor_ = LuFactor(J_);
    ++report.factorisations;
    VectorXd wanted(n + k);
    wanted << -point.residual, problem_.share - problem_.U.transpose() * point.force;
    VectorXd gradient = J_.topRows(n).transpose() * point.residual;
    gradient.head(n) -= problem_.U * (problem_.U.transpose() * gradient.head(n));
    direction_ = factor_.solve(wanted);
    // An exactly solved Newton step has the slope -|Phi|^2 = -2 merit; half of it may be lost to rounding.
    if (direction_.allFinite() && gradient.dot(direction_) <= -point.merit &&
        search(point, gradient.dot(direction_)))
      return true;
    // Down the gradient, to the lowest point of the linear model of Phi.
    const double curvature = (J_.topRows(n) * gradient).squaredNorm();
    if (!(curvature > 0)) return false;
    direction_ = -(gradient.squaredNorm() / curvature) * gradient;
    return search(point, gradient.dot(direction_));
  }

 private:
  void jacobian(const FloatingPoint& point) {
    const Index n = problem_.d.size();
    for (Index i = 0; i < n; ++i) {
      const ComplementaritySlope slope = fischer_burmeister_slope(point.gap(i), point.force(i));
      J_.row(i).head(n) = slope.a * problem_.G.row(i);
      J_.row(i).tail(problem_.U.cols()) = slope.a * problem_.U.row(i);
      J_(i, i) += slope.b;
    }
  }

  /// Halves the step until the merit falls by enough.
  bool search(FloatingPoint& point, double slope) {
    trial_ = point;
    for (double length = 1; length > epsilon; length /= 2) {
      trial_.force = point.force + length * direction_.head(point.force.size());
      trial_.motion = point.motion + length * direction_.tail(point.motion.size());
      evaluate(problem_, trial_);
      if (trial_.merit < point.merit && trial_.merit <= point.merit + enough * length * slope) {
        std::swap(point, trial_);
        return true;
      }
    }
    return false;
  }

  const FloatingProjection& problem_;
  MatrixXd J_;
  LuFactor factor_;
  VectorXd direction_;
  FloatingPoint trial_;
};

Iteration summary(const ScaledFloating& scaled, const FloatingPoint& point, double reach,
                  Index changes, double first) {
  const auto negative = [](const VectorXd& v) { return std::max(0.0, -v.minCoeff()); };
  Iteration entry{};
  entry.active = (point.force.array() > point.gap.array()).count();
  entry.changes = changes;
  entry.penetration = negative(point.gap.cwiseQuotient(scaled.contact.scale));
  entry.tension = negative(scaled.contact.scale.cwiseProduct(point.force)) / reach;
  entry.residual = first == 0 ? 0 : std::sqrt(2 * point.merit) / first;
  return entry;
}

}  // namespace

FloatingState fischer_burmeister(const FloatingProblem& problem, const SolverOptions& options) {
  const ScaledFloating scaled = equilibrate(problem);
  const Index n = scaled.contact.free_gap.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 10 * n + 100;
  const FloatingProjection projected(scaled);
  FloatingPoint point = first_point(projected);
  const double first = point.residual.norm();
  Newton newton(projected);
  Report report;
  std::vector<Index> closed = closed_pairs(point);
  Index last_changes = 1;  // so that the first set is tried
  VectorXd amplitude;
  for (Index changes = 0;;) {
    const bool limited = report.iterations >= limit;
    const bool settled = changes == 0 && last_changes > 0;
    const bool rounding = point.residual.norm() <= static_cast<double>(n) * epsilon * first;
    if (!limited && !settled && !rounding && newton.step(point, report)) {
      ++report.iterations;
      last_changes = changes;
      const std::vector<Index> last = std::exchange(closed, closed_pairs(point));
      changes = differences(closed, last);
      report.history.push_back(summary(scaled, point, projected.reach, changes, first));
      continue;
    }
    amplitude = projected.amplitude(scaled, point.force, point.motion);
    ++report.factorisations;
    const BalancedPairs end = balance_pairs(scaled, closed, amplitude);
    if (auto state = certified(problem, scaled, end, report)) return *state;
    const BalancedPairs next = balance_pairs(scaled, next_set(end), amplitude);
    if (auto state = certified(problem, scaled, next, report)) return *state;
    last_changes = 0;
    report.status = limited ? Status::IterationLimit : Status::Breakdown;
    if (!settled) break;
  }
  std::sort(closed.begin(), closed.end());
  return unscaled(scaled, {point.force / projected.reach, point.gap, {}, {}, false}, closed,
                  amplitude, std::move(report));
}

}  // namespace signorini

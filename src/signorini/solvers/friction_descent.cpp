#include "signorini/solvers/friction_descent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/closing/complementarity_functions.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What Armijo's rule asks of a step, as in fischer_burmeister().
constexpr double enough = 1e-4;

/// Newton's method with memory of its own, so that no step allocates.
class Newton {
 public:
  Newton(FrictionEquations& equations, VectorXd& x)
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
    direction_ = factor_.solve(residual_);
    direction_ *= -1;
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

  FrictionEquations& equations_;
  VectorXd& x_;
  VectorXd trial_;
  VectorXd residual_;
  VectorXd gradient_;
  VectorXd direction_;
  Eigen::MatrixXd J_;
  LuFactor factor_;
  double merit_ = 0;
};

/// The exact end from the motions of an iterate, or from those which that end asks for.
bool finished(const ScaledFriction& problem, double reach, FrictionPoint& point) {
  std::vector<Motion> motions = point.motions;
  for (int attempt = 0; attempt < 2; ++attempt) {
    ++point.report.factorisations;
    FrictionClosure end =
        close_friction(problem, motions, point.closure.force, point.closure.amplitude);
    if (end.confirmed) {
      point.closure = std::move(end);
      point.motions = std::move(motions);
      return true;
    }
    if (!end.solvable || predict_motions(problem, end.force, end.movement, reach, motions) == 0)
      return false;
  }
  return false;
}

}  // namespace

double friction_reach(const ScaledFriction& problem) {
  const Eigen::MatrixXd& F = problem.compliance;
  const double sum = F.size() == 0 ? 0 : F.cwiseAbs().rowwise().sum().maxCoeff();
  return sum > 0 ? sum : 1;
}

Iteration friction_iteration(const ScaledFriction& problem, const FrictionPoint& point,
                             Index changes, double residual) {
  const Index n = problem.coefficient.size();
  const auto open = std::count(point.motions.begin(), point.motions.end(), Motion::Open);
  double penetration = 0;
  double tension = 0;
  for (Index i = 0; i < n; ++i) {
    const bool is_open = point.motions[static_cast<std::size_t>(i)] == Motion::Open;
    if (is_open) penetration = std::max(penetration, -point.closure.movement(i) / problem.scale(i));
    if (!is_open) tension = std::max(tension, -point.closure.force(i) * problem.scale(i));
  }
  return {n - static_cast<Index>(open), changes, penetration, tension, 0, residual};
}

FrictionEquations::FrictionEquations(const ScaledFriction& problem, const FrictionFormulation& law)
    : problem_(problem),
      law_(law),
      reach_(friction_reach(problem)),
      compliance_(problem.compliance / reach_),
      movement_(problem.free.size()),
      cohesion_(VectorXd::Zero(problem.coefficient.size())) {}

void FrictionEquations::choose_closed(const VectorXd& x) {
  movement_ = problem_.free;
  movement_.noalias() += compliance_ * x.head(2 * pairs());
  movement_.noalias() += problem_.rigid * x.segment(2 * pairs(), modes());
  for (Index i = 0; i < pairs(); ++i)
    cohesion_(i) = x(i) > movement_(i) ? reach_ * problem_.cohesion(i) : 0;
}

void FrictionEquations::start(VectorXd& x) {
  choose_closed(x);
  if (law_.start != nullptr) law_.start(*this, x);
}

double FrictionEquations::bound(const VectorXd& x, Index i) const {
  return problem_.coefficient(i) * std::max(x(i), 0.0) + cohesion_(i);
}

double FrictionEquations::bound_slope(const VectorXd& x, Index i) const {
  return x(i) > 0 ? problem_.coefficient(i) : 0;
}

void FrictionEquations::evaluate(const VectorXd& x, VectorXd& residual) {
  const Index n = pairs();
  movement_ = problem_.free;
  movement_.noalias() += compliance_ * x.head(2 * n);
  movement_.noalias() += problem_.rigid * x.segment(2 * n, modes());
  for (Index i = 0; i < n; ++i) residual(i) = fischer_burmeister(movement_(i), x(i));
  auto balance = residual.segment(2 * n, modes());
  balance = -reach_ * problem_.resultant;
  balance.noalias() += problem_.rigid.transpose() * x.head(2 * n);
  law_.evaluate(*this, x, residual);
}

void FrictionEquations::differentiate(const VectorXd& x, Eigen::MatrixXd& J) const {
  const Index n = pairs();
  J.setZero();
  J.topLeftCorner(2 * n, 2 * n) = compliance_;
  J.block(0, 2 * n, 2 * n, modes()) = problem_.rigid;
  J.block(2 * n, 0, modes(), 2 * n) = problem_.rigid.transpose();
  for (Index i = 0; i < n; ++i) {
    const ComplementaritySlope slope = fischer_burmeister_slope(movement_(i), x(i));
    J.row(i) *= slope.a;
    J(i, i) += slope.b;
  }
  law_.differentiate(*this, x, J);
}

FrictionPoint friction_start(const ScaledFriction& problem) {
  const Index n = problem.coefficient.size();
  FrictionPoint point;
  FrictionClosure& now = point.closure;
  now.force = problem.rigid * problem.resultant;
  now.amplitude = -problem.rigid.transpose() * (problem.free + problem.compliance * now.force);
  if (problem.resultant.size() == 0) {
    const ContactState normal = goldfarb_idnani(
        ContactProblem{problem.compliance.topLeftCorner(n, n), problem.free.head(n)});
    if (normal.report.status == Status::Solved) now.force.head(n) = normal.force;
  }
  now.movement = problem.free + problem.compliance * now.force + problem.rigid * now.amplitude;
  point.motions.assign(static_cast<std::size_t>(n), Motion::Open);
  static_cast<void>(
      predict_motions(problem, now.force, now.movement, friction_reach(problem), point.motions));
  return point;
}

void descend(const ScaledFriction& problem, const FrictionFormulation& law, Index limit,
             FrictionPoint& point) {
  const Index n = problem.coefficient.size();
  const Index k = problem.resultant.size();
  FrictionEquations equations(problem, law);
  const double reach = equations.reach();
  VectorXd x(equations.size());
  x.head(2 * n) = reach * point.closure.force;
  x.segment(2 * n, k) = point.closure.amplitude;
  equations.start(x);
  Newton newton(equations, x);
  const auto look = [&] {
    point.closure.force = x.head(2 * n) / reach;
    point.closure.amplitude = x.segment(2 * n, k);
    point.closure.movement = equations.movement();
    return predict_motions(problem, point.closure.force, point.closure.movement, reach,
                           point.motions);
  };
  static_cast<void>(look());
  bool fresh = true;  // whether the motions have not been tried yet
  const double first = newton.residual();
  while (true) {
    if (fresh && finished(problem, reach, point)) return;
    point.report.status = Status::IterationLimit;
    point.reason = "Newton's method did not settle on what each pair does";
    if (newton.residual() <= epsilon * first || point.report.iterations >= limit) break;
    const bool moved = newton.step();
    ++point.report.iterations;
    ++point.report.factorisations;
    const Index changes = look();
    fresh = changes > 0;
    point.report.history.push_back(
        friction_iteration(problem, point, changes, first == 0 ? 0 : newton.residual() / first));
    if (moved) continue;
    point.report.status = Status::Breakdown;
    point.reason = "no step lowers the residual any more, at a point that is no solution";
    break;
  }
  if (fresh) static_cast<void>(finished(problem, reach, point));
}

}  // namespace signorini

#include "signorini/solvers/friction_proofs.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/solvers/lemke.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double proof_rounding = 1e3 * std::numeric_limits<double>::epsilon();

/// The directions in which contact can push: one edge of each friction cone on either side, then
/// the tangential direction of each cohesive pair.
struct Pushes {
  MatrixXd direction;  ///< `k x` one column each
  VectorXd most;       ///< of cohesive pairs, the size of the last columns
};

Pushes pushes(const ScaledFriction& problem) {
  const Index n = problem.coefficient.size();
  const Index cohesive = (problem.cohesion.array() > 0).count();
  Pushes result{MatrixXd(problem.resultant.size(), 2 * n + cohesive), VectorXd(cohesive)};
  Index c = 0;
  for (Index i = 0; i < n; ++i) {
    const VectorXd normal = problem.rigid.row(i).transpose();
    const VectorXd tangent = problem.rigid.row(n + i).transpose();
    result.direction.col(i) = normal + problem.coefficient(i) * tangent;
    result.direction.col(n + i) = normal - problem.coefficient(i) * tangent;
    if (!(problem.cohesion(i) > 0)) continue;
    result.direction.col(2 * n + c) = tangent;
    result.most(c++) = problem.cohesion(i);
  }
  return result;
}

/// What the nearest resultant that contact can give lacks: min |D w - r| with w >= 0, the last ones
/// between -c and c.
VectorXd lacking(const ScaledFriction& problem) {
  const Pushes push = pushes(problem);
  const MatrixXd& D = push.direction;
  const Index c = push.most.size();
  const Index m = D.cols();
  VectorXd target = problem.resultant;
  target += D.rightCols(c) * push.most;  // the last ones count from -c, up to 2 c
  ContactProblem lcp{MatrixXd::Zero(m + c, m + c), VectorXd(m + c)};
  lcp.compliance.topLeftCorner(m, m) = D.transpose() * D;
  lcp.compliance.topRightCorner(m, c).bottomRows(c).setIdentity();
  lcp.compliance.bottomLeftCorner(c, m).rightCols(c) = -MatrixXd::Identity(c, c);
  lcp.free_gap << -D.transpose() * target, 2 * push.most;
  const VectorXd weight = lemke(lcp).force;
  VectorXd way = D * weight.head(m) - target;
  // The difference of two close numbers. What it must be orthogonal to, pushes that are neither at zero nor at
  // their bound, gives back the digits that it lost.
  std::vector<Index> inner;
  for (Index j = 0; j < m; ++j)
    if (weight(j) > 0 && (j < m - c || weight(c + j) == 0)) inner.push_back(j);
  if (inner.empty()) return way;
  const MatrixXd Q = column_span(D(Eigen::all, inner)).basis;
  for (int step = 0; step < 2; ++step) way -= Q * (Q.transpose() * way);
  return way;
}

/// Whether a direction proves that nothing balances r.
bool proves(const ScaledFriction& problem, const VectorXd& way) {
  const Index n = problem.coefficient.size();
  const VectorXd moved = problem.rigid * way;
  double work = problem.resultant.dot(way);
  double terms = problem.resultant.cwiseAbs().dot(way.cwiseAbs());
  for (Index i = 0; i < n; ++i) {
    const double slip = std::abs(moved(n + i));
    if (moved(i) <
        problem.coefficient(i) * slip - proof_rounding * (1 + problem.coefficient(i)) * way.norm())
      return false;
    work += problem.cohesion(i) * slip;
    terms += problem.cohesion(i) * slip;
  }
  return work < -proof_rounding * terms;
}

/// G - C T^-1 C^T - mu |T| mu / 4, or nothing if T is not positive definite.
bool bound_excludes_others(const MatrixXd& F, const VectorXd& coefficient) {
  const Index n = coefficient.size();
  if (n == 0) return true;
  const CholeskyFactor tangential(F.bottomRightCorner(n, n));
  if (!tangential.positive()) return false;
  const MatrixXd C = F.topRightCorner(n, n);
  MatrixXd S = F.topLeftCorner(n, n);
  S.noalias() -= C * tangential.solve_columns(C.transpose());
  const double largest = symmetric_eigenvalues(F.bottomRightCorner(n, n)).maxCoeff();
  if (!C.isZero(0)) S.diagonal() -= 0.25 * largest * coefficient.cwiseAbs2();
  // Rounding of the entries, which are at most 1, must not decide.
  S.diagonal().array() -= static_cast<double>(n) * proof_rounding;
  return CholeskyFactor(S).positive();
}

}  // namespace

VectorXd escape(const ScaledFriction& problem) {
  if (problem.loose.size() > 0) return problem.loose;
  if (problem.resultant.size() == 0 || problem.resultant.isZero(0)) return {};
  const VectorXd way = lacking(problem);
  if (!way.allFinite() || !proves(problem, way)) return {};
  return problem.inverse * way;
}

Uniqueness uniqueness(const ScaledFriction& problem, const FrictionClosure& solution) {
  const Index n = problem.coefficient.size();
  if (solution.reversed) return Uniqueness::Doubtful;
  for (Index i = 0; i < n; ++i)
    if (problem.coefficient(i) * std::abs(problem.compliance(i, n + i)) > problem.compliance(i, i))
      return Uniqueness::Doubtful;
  const bool rubs = !problem.coefficient.isZero(0) || !problem.cohesion.isZero(0);
  if (rubs && (problem.resultant.size() > 0 || !problem.cohesion.isZero(0)))
    return Uniqueness::Unknown;
  return bound_excludes_others(problem.compliance, problem.coefficient) ? Uniqueness::Proved
                                                                        : Uniqueness::Unknown;
}

FrictionState escaping(const FrictionProblem& problem, const ScaledFriction& scaled, VectorXd way) {
  FrictionClosure none;
  none.force = VectorXd::Zero(scaled.free.size());
  none.movement = scaled.free;
  none.amplitude = VectorXd::Zero(scaled.resultant.size());
  Report report;
  report.status = Status::Infeasible;
  const std::vector<Motion> open(static_cast<std::size_t>(problem.free_gap.size()), Motion::Open);
  FrictionState state = unscaled(
      problem, scaled, none, open, report,
      "no contact forces within their friction bounds balance the load: the body moves away");
  state.escape = std::move(way);
  return state;
}

FrictionState finished_state(const FrictionProblem& problem, const ScaledFriction& scaled,
                             FrictionPoint point) {
  Report& report = point.report;
  if (point.closure.confirmed) {
    report.status = Status::Solved;
    point.reason.clear();
  } else if (report.status == Status::Solved) {
    report.status = Status::Breakdown;  // of another problem that was solved on the way
  }
  FrictionState state =
      unscaled(problem, scaled, point.closure, point.motions, report, std::move(point.reason));
  if (point.closure.confirmed) state.uniqueness = uniqueness(scaled, point.closure);
  return state;
}

}  // namespace signorini

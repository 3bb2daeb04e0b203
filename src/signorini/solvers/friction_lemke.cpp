#include "signorini/solvers/friction_lemke.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "signorini/problem/report_sum.hpp"
#include "signorini/solvers/friction_active_set.hpp"
#include "signorini/solvers/friction_proofs.hpp"
#include "signorini/solvers/lemke.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// M and q of the linear complementarity problem, for given cohesion.
ContactProblem complementarity(const ScaledFriction& problem, const VectorXd& cohesion) {
  const Index n = problem.coefficient.size();
  const Index k = problem.resultant.size();
  // f = (lambda, p) spread: f = E (lambda, p) - (0, c) with tau = p - mu lambda - c.
  MatrixXd E = MatrixXd::Identity(2 * n, 2 * n);
  E.bottomLeftCorner(n, n).diagonal() = -problem.coefficient;
  VectorXd minus_c = VectorXd::Zero(2 * n);
  minus_c.tail(n) = -cohesion;
  ContactProblem lcp{MatrixXd::Zero(3 * n + 2 * k, 3 * n + 2 * k), VectorXd(3 * n + 2 * k)};
  MatrixXd& M = lcp.compliance;
  M.topLeftCorner(2 * n, 2 * n) = problem.compliance * E;
  M.block(n, 2 * n, n, n).setIdentity();
  M.block(2 * n, 0, n, n).diagonal() = 2 * problem.coefficient;
  M.block(2 * n, n, n, n).diagonal().setConstant(-1);
  lcp.free_gap.head(2 * n) = problem.free + problem.compliance * minus_c;
  lcp.free_gap.segment(2 * n, n) = 2 * cohesion;
  // a = a+ - a-; r - R^T f >= 0 belongs to a+ and R^T f - r >= 0 to a-.
  M.block(0, 3 * n, 2 * n, k) = problem.rigid;
  M.block(0, 3 * n + k, 2 * n, k) = -problem.rigid;
  M.block(3 * n, 0, k, 2 * n) = -problem.rigid.transpose() * E;
  M.block(3 * n + k, 0, k, 2 * n) = problem.rigid.transpose() * E;
  lcp.free_gap.segment(3 * n, k) = problem.resultant - problem.rigid.transpose() * minus_c;
  lcp.free_gap.segment(3 * n + k, k) = -lcp.free_gap.segment(3 * n, k);
  return lcp;
}

/// Runs lemke(), again with other covering vectors if it does not arrive: in exact numbers it would, but
/// where friction coefficients are huge, rounding can let it leave its path.
ContactState arrived(const ContactProblem& lcp, const SolverOptions& options, Report& report) {
  ContactState state;
  const Index m = lcp.free_gap.size();
  SolverOptions path = options;  // a path that arrives is about as long as the problem is large
  if (path.iteration_limit == 0) path.iteration_limit = 100 * m;
  for (Index attempt = 0; attempt < 4 && state.report.status != Status::Solved; ++attempt) {
    const VectorXd covering = VectorXd::LinSpaced(m, 1, static_cast<double>(1 + attempt));
    state = attempt == 0 ? lemke(lcp, path) : lemke(lcp, covering, path);
    append(report, state.report);
  }
  return state;
}

/// Takes the forces of a linear complementarity problem over, and what they say of each pair.
void take(const ScaledFriction& problem, const VectorXd& cohesion, const ContactState& state,
          FrictionPoint& point) {
  const Index n = problem.coefficient.size();
  const Index k = problem.resultant.size();
  const VectorXd& z = state.force;
  FrictionClosure& now = point.closure;
  now.force.head(n) = z.head(n);
  now.force.tail(n) = z.segment(n, n) - problem.coefficient.cwiseProduct(z.head(n)) - cohesion;
  now.amplitude = z.segment(3 * n, k) - z.segment(3 * n + k, k);
  now.movement = problem.free + problem.compliance * now.force + problem.rigid * now.amplitude;
  for (Index i = 0; i < n; ++i) {
    Motion& motion = point.motions[static_cast<std::size_t>(i)];
    const double backward = 2 * (problem.coefficient(i) * z(i) + cohesion(i)) - z(n + i);
    motion = !(z(i) > now.movement(i))                        ? Motion::Open
             : now.movement(n + i) > std::max(z(n + i), 0.0)  ? Motion::Forward
             : -now.movement(n + i) > std::max(backward, 0.0) ? Motion::Backward
                                                              : Motion::Stick;
  }
}

}  // namespace

void follow_lemke(const ScaledFriction& problem, const SolverOptions& options,
                  FrictionPoint& point) {
  const Index n = problem.coefficient.size();
  VectorXd cohesion = problem.cohesion;
  std::vector<VectorXd> seen;
  while (std::find(seen.begin(), seen.end(), cohesion) == seen.end()) {
    seen.push_back(cohesion);
    const ContactState state = arrived(complementarity(problem, cohesion), options, point.report);
    point.reason =
        std::string("Lemke's method ended with '") + to_string(state.report.status) + "'";
    if (!state.force.allFinite()) return;
    take(problem, cohesion, state, point);
    std::string reason = point.reason;
    exchange_motions(problem, 3, point);  // rounding may have the say over pairs that barely touch
    if (point.closure.confirmed) return;
    point.report.status = state.report.status;
    point.reason = std::move(reason);
    if (state.report.status != Status::Solved) return;
    for (Index i = 0; i < n; ++i)
      cohesion(i) =
          point.motions[static_cast<std::size_t>(i)] == Motion::Open ? 0 : problem.cohesion(i);
  }
  point.report.status = Status::Breakdown;
  point.reason = "pairs close only without cohesion and open only with it, or rounding decides";
}

FrictionState friction_lemke(const FrictionProblem& problem, const SolverOptions& options) {
  const ScaledFriction scaled = equilibrate(problem);
  if (VectorXd way = escape(scaled); way.size() > 0)
    return escaping(problem, scaled, std::move(way));
  FrictionPoint point = friction_start(scaled);
  follow_lemke(scaled, options, point);
  return finished_state(problem, scaled, std::move(point));
}

}  // namespace signorini

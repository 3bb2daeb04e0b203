// Friction and rigid modes as one linear complementarity problem, for lemke().
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/newton.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// M and q of the linear complementarity problem for (lambda, p, v-, a+, a-), with given cohesion.
ContactProblem complementarity(const ScaledProblem& problem, const VectorXd& cohesion) {
  const Index rows = problem.free.size();
  const Index pairs = problem.pairs();
  const Index slips = rows - pairs;
  const Index k = problem.rigid.cols();
  const Index size = rows + slips + 2 * k;
  // f = E (lambda, p) - (0, c) with tau = p - mu lambda - c.
  MatrixXd E = MatrixXd::Identity(rows, rows);
  VectorXd minus_c = VectorXd::Zero(rows);
  minus_c.tail(slips) = -cohesion;
  ContactProblem lcp{MatrixXd::Zero(size, size), VectorXd(size)};
  MatrixXd& M = lcp.compliance;
  for (Index j = 0; j < slips; ++j) {
    const Index pair = problem.law.pair[static_cast<std::size_t>(j)];
    E(pairs + j, pair) = -problem.law.coefficient(j);
    M(rows + j, pair) = 2 * problem.law.coefficient(j);
  }
  M.topLeftCorner(rows, rows) = problem.compliance * E;
  M.block(pairs, rows, slips, slips).setIdentity();
  M.block(rows, pairs, slips, slips) = -MatrixXd::Identity(slips, slips);
  lcp.free_gap.head(rows) = problem.free + problem.compliance * minus_c;
  lcp.free_gap.segment(rows, slips) = 2 * cohesion;
  if (k == 0) return lcp;
  // a = a+ - a-; r - R^T f >= 0 belongs to a+ and R^T f - r >= 0 to a-.
  const Index plus = rows + slips;
  M.block(0, plus, rows, k) = problem.rigid;
  M.block(0, plus + k, rows, k) = -problem.rigid;
  M.block(plus, 0, k, rows) = -problem.rigid.transpose() * E;
  M.block(plus + k, 0, k, rows) = problem.rigid.transpose() * E;
  lcp.free_gap.segment(plus, k) = problem.resultant - problem.rigid.transpose() * minus_c;
  lcp.free_gap.tail(k) = -lcp.free_gap.segment(plus, k);
  return lcp;
}

/// Runs lemke(), again with other covering vectors if it does not arrive: in exact numbers it would, but
/// where friction coefficients are huge, rounding can let it leave its path.
ContactState arrived(const ContactProblem& lcp, const SolverOptions& options, Report& report) {
  ContactState state;
  const Index m = lcp.free_gap.size();
  SolverOptions path = options;  // a path that arrives is about as long as the problem is large
  if (path.iteration_limit == 0) path.iteration_limit = 100 * m;
  for (Index trial = 0; trial < 4 && state.report.status != SolveStatus::Solved; ++trial) {
    const VectorXd covering = VectorXd::LinSpaced(m, 1, static_cast<double>(1 + trial));
    state = trial == 0 ? lemke(lcp, path) : lemke(lcp, covering, path);
    append(report, state.report);
  }
  return state;
}

/// Takes the forces of a linear complementarity problem over, and what they say of each pair.
void take(const ScaledProblem& problem, const VectorXd& cohesion, const VectorXd& z,
          Iterate& iterate) {
  const Index rows = problem.free.size();
  const Index pairs = problem.pairs();
  const Index slips = rows - pairs;
  const Index k = problem.rigid.cols();
  ActiveSetSolution& now = iterate.solution;
  now.force = z.head(rows);
  now.amplitude = z.segment(rows + slips, k) - z.tail(k);
  const auto bound = [&](Index j) {
    return problem.law.coefficient(j) * z(problem.law.pair[static_cast<std::size_t>(j)]) +
           cohesion(j);
  };
  for (Index j = 0; j < slips; ++j) now.force(pairs + j) -= bound(j);
  now.movement = problem.free + problem.compliance * now.force;
  if (k > 0) now.movement += problem.rigid * now.amplitude;
  for (Index i = 0; i < pairs; ++i)
    iterate.statuses[static_cast<std::size_t>(i)] =
        z(i) > now.movement(i) ? ContactStatus::Stick : ContactStatus::Open;
  for (Index j = 0; j < slips; ++j) {
    ContactStatus& contact_status =
        iterate.statuses[static_cast<std::size_t>(problem.law.pair[static_cast<std::size_t>(j)])];
    const double slip = now.movement(pairs + j);
    const double forward = z(pairs + j);
    if (contact_status == ContactStatus::Open) continue;
    if (slip > std::max(forward, 0.0))
      contact_status = ContactStatus::SlipForward;
    else if (-slip > std::max(2 * bound(j) - forward, 0.0))
      contact_status = ContactStatus::SlipBackward;
  }
}

/// The cohesion of a set of pairs: those that came out closed.
VectorXd carried(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses) {
  VectorXd cohesion = problem.law.cohesion;
  for (Index j = 0; j < cohesion.size(); ++j)
    if (statuses[static_cast<std::size_t>(problem.law.pair[static_cast<std::size_t>(j)])] ==
        ContactStatus::Open)
      cohesion(j) = 0;
  return cohesion;
}

/// The first slip of which two sets do not say the same, other than `last` if there is one; -1 if they are the same.
Index first_change(const VectorXd& now, const VectorXd& next, Index last) {
  Index found = -1;
  for (Index j = 0; j < now.size() && (found < 0 || found == last); ++j)
    if (now(j) != next(j)) found = j;
  return found;
}

}  // namespace

void follow_pivots(const ScaledProblem& problem, const SolverOptions& options, Iterate& iterate) {
  VectorXd cohesion = problem.law.cohesion;
  std::vector<VectorXd> seen;
  bool one_at_a_time = false;
  Index changed = -1;  // the slip whose pair got or lost its cohesion last, if it was the only one
  Index jumping = -1;
  bool circle = false;
  while (true) {
    if (std::find(seen.begin(), seen.end(), cohesion) != seen.end()) {
      circle = one_at_a_time;
      if (circle) break;
      one_at_a_time = true;
      seen.clear();
    }
    seen.push_back(cohesion);
    const ContactState state = arrived(complementarity(problem, cohesion), options, iterate.report);
    std::string reason =
        std::string("Lemke's method ended with '") + to_string(state.report.status) + "'";
    iterate.reason = reason;
    if (!state.force.allFinite()) return;
    take(problem, cohesion, state.force, iterate);
    const VectorXd next = carried(problem, iterate.statuses);
    primal_dual_iterations(problem, 3,
                           iterate);  // rounding may have the say over pairs that barely touch
    if (iterate.confirmed) return;
    iterate.report.status = state.report.status;
    iterate.reason = std::move(reason);
    if (state.report.status != SolveStatus::Solved) return;
    const Index change = first_change(cohesion, next, changed);
    if (change < 0) break;
    if (one_at_a_time && change == changed) {
      jumping = change;
      break;
    }
    if (one_at_a_time)
      cohesion(change) = next(change);
    else
      cohesion = next;
    changed = one_at_a_time ? change : -1;
  }
  iterate.report.status = circle || jumping >= 0 ? SolveStatus::Jump : SolveStatus::Breakdown;
  iterate.reason =
      jumping >= 0
          ? text("pair ", problem.law.pair[static_cast<std::size_t>(jumping)],
                 " closes only without its cohesion and opens only with it: cohesion that ends "
                 "with contact leaves no equilibrium here; change the load or the cohesion")
      : circle
          ? "no set of pairs that was tried stays closed with the cohesion it is given, and no "
            "other; change the load or the cohesion"
          : "rounding hides what the pairs do where Lemke's method arrived";
}

}  // namespace signorini

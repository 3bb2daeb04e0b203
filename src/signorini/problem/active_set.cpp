// What the statuses of pairs mean, and what numbers say of them.
#include <algorithm>
#include <optional>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What a closed frictional pair does. \param tau, slip, bound  of the pair, in one unit
/// \param slack  how far tau of a sticking pair may exceed the bound by rounding \param still  a slip that is rounding
ContactStatus closed_pair_status(ContactStatus last, double tau, double slip, double bound,
                                 double slack, double still) {
  const bool slides = friction_sign(last) != 0;
  if (slides && still > 0 && (bound == 0 || friction_sign(last) * slip <= still)) return last;
  const double pulled = tau - slip;
  const double allowed = bound + (last == ContactStatus::Stick ? slack : 0);
  return pulled > allowed    ? ContactStatus::SlipBackward
         : pulled < -allowed ? ContactStatus::SlipForward
                             : ContactStatus::Stick;
}

}  // namespace

ActiveSet active_set(const std::vector<ContactStatus>& statuses, const FrictionLaw& law) {
  const Index pairs = static_cast<Index>(statuses.size());
  ActiveSet set{closed_pairs(statuses)};
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const ContactStatus contact_status = statuses[at(law.pair[k])];
    const Index row = static_cast<Index>(k);
    const double sign = friction_sign(contact_status);
    const bool frictional = law.coefficient(row) > 0 || law.cohesion(row) > 0;
    if (contact_status == ContactStatus::Stick && frictional) set.closed.push_back(pairs + row);
    if (sign != 0 && frictional)
      set.sliding.push_back(
          {law.pair[k], pairs + row, sign * law.coefficient(row), sign * law.cohesion(row)});
  }
  return set;
}

std::vector<ContactStatus> statuses_of(const std::vector<Index>& active, Index pairs) {
  std::vector<ContactStatus> statuses(at(pairs), ContactStatus::Open);
  for (const Index i : active) statuses[at(i)] = ContactStatus::Stick;
  return statuses;
}

std::vector<ContactStatus> all_statuses(const ContactState& state) {
  std::vector<ContactStatus> statuses = statuses_of(state.active, state.force.size());
  for (std::size_t k = 0; k < state.contact_status.size(); ++k)
    statuses[at(state.frictional_pairs[k])] = state.contact_status[k];
  return statuses;
}

std::vector<Index> closed_pairs(const std::vector<ContactStatus>& statuses) {
  std::vector<Index> closed;
  for (std::size_t i = 0; i < statuses.size(); ++i)
    if (statuses[i] != ContactStatus::Open) closed.push_back(static_cast<Index>(i));
  return closed;
}

Index predict(const ScaledProblem& problem, const ActiveSetSolution& solution, double force_scale,
              std::vector<ContactStatus>& statuses) {
  const Index pairs = problem.pairs();
  const std::vector<ContactStatus> last = statuses;
  const bool exact = solution.movement_rounding.size() == 0;
  const auto rounding = [&](Index row) { return exact ? 0 : solution.movement_rounding(row); };
  const double force_rounding = exact ? 0 : force_scale * solution.force_rounding;
  const auto pressed = [&](Index i) {
    return force_scale * solution.force(i) - solution.movement(i);
  };
  for (Index i = 0; i < pairs; ++i) {
    const bool closed = exact || last[at(i)] == ContactStatus::Open ? pressed(i) > rounding(i)
                                                                    : pressed(i) >= -force_rounding;
    statuses[at(i)] = closed ? ContactStatus::Stick : ContactStatus::Open;
  }
  for (std::size_t k = 0; k < problem.law.pair.size(); ++k) {
    const Index i = problem.law.pair[k];
    if (statuses[at(i)] == ContactStatus::Open) continue;
    const Index row = static_cast<Index>(k);
    const double mu = problem.law.coefficient(row);
    const double bound = mu * std::max(pressed(i), 0.0) + force_scale * problem.law.cohesion(row);
    statuses[at(i)] = closed_pair_status(last[at(i)], force_scale * solution.force(pairs + row),
                                         solution.movement(pairs + row), bound,
                                         (1 + mu) * force_rounding, rounding(pairs + row));
  }
  Index changes = 0;
  for (std::size_t i = 0; i < statuses.size(); ++i) changes += statuses[i] != last[i] ? 1 : 0;
  return changes;
}

bool solves(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
            const ActiveSetSolution& solution) {
  std::vector<ContactStatus> next = statuses;
  if (!solution.solvable || predict(problem, solution, 1, next) != 0) return false;
  for (const Index row : active_set(statuses, problem.law).closed)
    if (!solution.closes(row)) return false;
  Claim claim{solution.force, solution.movement, solution.amplitude};
  const Index pairs = problem.pairs();
  claim.force.head(pairs) = solution.force.head(pairs).cwiseMax(0.0);
  claim.movement.head(pairs) = solution.movement.head(pairs).cwiseMax(0.0);
  // In the units of the problem every number is rounded once more.
  const ProblemBlocks blocks{problem.compliance, problem.free, problem.law, problem.rigid,
                             problem.resultant};
  return certify(blocks, claim).holds(0.25 * certificate_tolerance);
}

Confirmed confirmed(const ScaledProblem& problem, const std::vector<Index>& candidates,
                    const ActiveSetSolution* start) {
  ActiveSetSolution solution = solve_active_set(problem, ActiveSet{candidates}, start);
  std::vector<ContactStatus> statuses = statuses_of(solution.rows, problem.pairs());
  if (!solves(problem, statuses, solution)) return std::nullopt;
  return std::make_pair(std::move(solution), std::move(statuses));
}

}  // namespace signorini

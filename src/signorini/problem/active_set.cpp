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

void name_slides(const FrictionLaw& law, ContactState& state) {
  for (std::size_t k = 0; k < state.contact_status.size(); ++k) {
    const Index row = static_cast<Index>(k);
    const double slip = state.slip(row);
    const double pressed = std::max(state.force(law.pair[k]), 0.0);
    const bool frictional = law.coefficient(row) * pressed + law.cohesion(row) > 0;
    if (friction_sign(state.contact_status[k]) != 0 && slip != 0 && !frictional)
      state.contact_status[k] = slip > 0 ? ContactStatus::SlipForward : ContactStatus::SlipBackward;
  }
}

Iteration summary(const ScaledProblem& problem, const std::vector<ContactStatus>& statuses,
                  const ActiveSetSolution& solution, Index changes) {
  Iteration entry{0, changes, 0, 0};
  for (Index i = 0; i < problem.pairs(); ++i)
    if (statuses[at(i)] == ContactStatus::Open) {
      entry.penetration = std::max(entry.penetration, -solution.movement(i) / problem.scale(i));
    } else {
      ++entry.active;
      entry.tension = std::max(entry.tension, -solution.force(i) * problem.scale(i));
    }
  // gap = d + G lambda, so -d.lambda - 1/2 lambda.G lambda = -1/2 lambda.(d + gap)
  if (problem.rigid.cols() == 0 && problem.law.pair.empty())
    entry.dual_energy = -0.5 * solution.force.dot(problem.free + solution.movement);
  return entry;
}

bool is_kept(Index iteration) {
  Index spacing = 1;
  while (iteration / spacing >= 32) spacing *= 2;
  return iteration % spacing == 0;
}

std::vector<Index> by_falling(const VectorXd& weight) {
  std::vector<Index> order;
  for (Index i = 0; i < weight.size(); ++i)
    if (weight(i) > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return weight(i) > weight(j); });
  return order;
}

ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled,
                      const ActiveSetSolution& solution, const std::vector<ContactStatus>& statuses,
                      Report report, VectorXd proof) {
  const Index pairs = scaled.pairs();
  const Index slips = scaled.free.size() - pairs;
  const VectorXd force = scaled.scale.cwiseProduct(solution.force);
  VectorXd movement = solution.movement.cwiseQuotient(scaled.scale);
  ContactState state;
  if (report.status == SolveStatus::Solved)
    for (const Index row : active_set(statuses, scaled.law).closed) movement(row) = 0;
  state.force = force.head(pairs);
  state.gap = movement.head(pairs);
  state.friction = force.tail(slips);
  state.slip = movement.tail(slips);
  if (report.status == SolveStatus::Solved) {  // what is negative is of rounding size
    state.force = state.force.cwiseMax(0.0);
    state.gap = state.gap.cwiseMax(0.0);
  }
  state.active = closed_pairs(statuses);
  state.frictional_pairs = scaled.law.pair;
  for (const Index pair : scaled.law.pair) state.contact_status.push_back(statuses[at(pair)]);
  name_slides(scaled.law, state);
  if (problem.resultant.size() > 0)
    state.amplitude = solution.amplitude.size() > 0 ? VectorXd(scaled.inverse * solution.amplitude)
                                                    : VectorXd::Zero(problem.resultant.size());
  state.report = std::move(report);
  state.farkas_certificate = std::move(proof);
  if (state.report.status == SolveStatus::Solved && !certify(problem, state).holds()) {
    state.report.status = SolveStatus::Breakdown;
    state.reason = "the end of the method does not hold in the units of the problem";
  }
  if (state.report.status == SolveStatus::Infeasible &&
      !verify_farkas(problem, state.farkas_certificate)) {
    state.report.status = SolveStatus::Breakdown;
    state.farkas_certificate.resize(0);
  }
  return state;
}

}  // namespace signorini

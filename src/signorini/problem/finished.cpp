#include <algorithm>
#include <utility>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

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

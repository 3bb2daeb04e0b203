// # From the numbers of a method to a state
//
// A method works on the scaled problem and ends with forces, movements and a claim. The user wants
// newtons and millimetres, and no claim that does not hold. finished() does both. It multiplies
// forces by the scale and divides movements by it, and then it certifies the result against the
// problem as it was posed. Scaling is rounded once more, and dependent pairs with large forces can
// notice that. A claim that fails is taken back.
//
// Two scales 10 and 1/2, the scaled forces 2/3 and 2/3: the forces are 6.7 and 0.33. A scaled gap
// of 0.1 of the first pair is the gap 0.01.

#include <algorithm>
#include <utility>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

// A pair that slides without friction has no friction force that tells the direction, so its slip
// tells it. Where there is friction the force has the last word: its slip may be rounding, with the
// wrong sign.
void name_slides(const FrictionLaw& law, ContactState& state) {
  for (Index row = 0; row < state.slip.size(); ++row) {
    const Index pair = law.pair[at(row)];
    const double slip = state.slip(row);
    const double pressed = std::max(state.force(pair), 0.0);
    const bool frictional = law.coefficient(row) * pressed + law.cohesion(row) > 0;
    ContactStatus& status = state.contact_status[at(pair)];
    if (friction_sign(status) != 0 && slip != 0 && !frictional)
      status = slip > 0 ? ContactStatus::SlipForward : ContactStatus::SlipBackward;
  }
}

}  // namespace

// Numbers come as one vector over all rows, gaps first. A state lists forces, friction, gaps and
// slips apart. With three pairs of which the first and the last rub there are five rows: three gaps,
// then the slips of pair one and of pair three.
void fill_state(const FrictionLaw& law, const std::vector<ContactStatus>& statuses,
                const VectorXd& force, const VectorXd& movement, ContactState& state) {
  const Index slips = static_cast<Index>(law.pair.size());
  const Index pairs = force.size() - slips;
  state.force = force.head(pairs);
  state.friction = force.tail(slips);
  state.gap = movement.head(pairs);
  state.slip = movement.tail(slips);
  state.contact_status = statuses;
  state.frictional_pairs = law.pair;
  name_slides(law, state);
}

// One line of the history, which tables and pictures of the way are made of: how many pairs are
// closed, and how wrong the worst open and the worst closed pair are. The dual energy rises from step to step in methods that make it grow. It is left
// at 0 where it means nothing: with friction, and with rigid modes. Lengths and forces are those of
// the problem as it was posed, so that a reader can compare them with the result.
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

// Of dependent pairs the first one in a list is closed. So the heaviest come first, and pairs of
// equal weight keep their order, so that a run can be repeated. Weights 0, 2, 1 and 2 of four pairs
// give the order 1, 3, 2, counted from 0. The first pair has no weight and is left out.
std::vector<Index> by_falling(const VectorXd& weight) {
  std::vector<Index> order;
  for (Index i = 0; i < weight.size(); ++i)
    if (weight(i) > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return weight(i) > weight(j); });
  return order;
}

// Of a solution, rows that were closed have exactly 0, and forces that pull and gaps that overlap
// are cut off: all are within rounding. Without a solution the numbers are shown as they are, with
// the reason.
//
// A proof that nothing solves the problem is a claim too. It is checked in the same way, and taken
// back in the same way.
ContactState finished(const ContactProblem& problem, const ScaledProblem& scaled,
                      const ActiveSetSolution& solution, const std::vector<ContactStatus>& statuses,
                      Report report, VectorXd proof) {
  const Index pairs = scaled.pairs();
  VectorXd force = scaled.scale.cwiseProduct(solution.force);
  VectorXd movement = solution.movement.cwiseQuotient(scaled.scale);
  if (report.status == SolveStatus::Solved) {  // what is negative is of rounding size
    for (const Index row : active_set(statuses, scaled.law).closed) movement(row) = 0;
    force.head(pairs) = force.head(pairs).cwiseMax(0.0);
    movement.head(pairs) = movement.head(pairs).cwiseMax(0.0);
  }
  ContactState state;
  fill_state(scaled.law, statuses, force, movement, state);
  if (problem.resultant.size() > 0)
    state.amplitude = solution.amplitude.size() > 0 ? VectorXd(scaled.inverse * solution.amplitude)
                                                    : VectorXd::Zero(problem.resultant.size());
  state.report = std::move(report);
  state.system = solution.system;
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

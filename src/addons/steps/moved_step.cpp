// # A step of bodies that move
//
// Pairs of such a step are those of the place where it ends. So what a pair knows, its slip and the work that it dissipated,
// goes by contact and node from the old pairs to the new ones. What a node dissipated that has no pair any more is kept in
// a sum for each contact.
//
// Such a step is a loop, and it takes fewer iterations if it begins near its end. If loads go on as they did, so do bodies:
// the loop begins where the way of the step before leads on. The first step behind a turn of the loads is not gone on with: bodies
// that stick there may slide next.

#include <utility>
#include <vector>

#include "addons/steps/step_parts.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Where the nodes of a state are, of a model that has its given displacements.
Displaced displacement_of(const PathState& state, const Model& model) {
  if (state.steps == 0) return NodeArray(NodeArray::Zero(model.unknowns.held.rows(), 2));
  return displaced(model.unknowns, state.solution);
}

/// Takes what rows of slips know to those that are now: nothing is known of a new one.
void hand_on(const std::vector<PairName>& names, const Model& model, PathState& state) {
  const std::vector<Index> numbers = numbers_among(names, names_of_slips(model));
  const VectorXd slip = std::exchange(state.slip, VectorXd::Zero(static_cast<Index>(numbers.size())));
  const VectorXd dissipation = std::exchange(state.dissipation, state.slip);
  if (slip.size() == 0) return;
  std::vector<bool> stays(names.size(), false);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const Index before = numbers[k];
    if (before < 0) continue;
    stays[static_cast<std::size_t>(before)] = true;
    state.slip(static_cast<Index>(k)) = slip(before);
    state.dissipation(static_cast<Index>(k)) = dissipation(before);
  }
  VectorXd lost = VectorXd::Zero(static_cast<Index>(model.contacts.size()));
  lost.head(state.dissipated_elsewhere.size()) = state.dissipated_elsewhere;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (!stays[k]) lost(static_cast<Index>(names[k].first)) += dissipation(static_cast<Index>(k));
  if (!lost.isZero(0)) state.dissipated_elsewhere = std::move(lost);
}

}  // namespace

Step moved_step(const PathState& past, double time, Model& model, CondensedPath& path,
                Ledger ledger) {
  set_time(past.time, model);
  const Displaced before = displacement_of(past, model);
  set_time(time, model);
  model.loop->place(before, before, model);
  check_sizes(past, model);
  const std::vector<PairName> names = names_of_slips(model);
  path.condensed.free_displacement = free_displacement(time, model, path);
  SolverOptions options;
  options.start = past.contact_status;
  const double share = share_gone_on(past, time, model);
  const VectorXd expected = share > 0 ? VectorXd(share * past.way.displacement) : VectorXd();
  Step result{
      model.loop->solve(before, expected, options, model, path.condensed, std::move(ledger)), past};
  if (result.solution.contact.report.status != SolveStatus::Solved) return result;
  PathState known = past;
  hand_on(names, model, known);
  result.state = after(known, time, model, VectorXd(), result.solution);
  if (share > 0)
    result.state.way.displacement =
        result.state.solution.displacement - restricted(model.unknowns, before.high);
  return result;
}

}  // namespace signorini

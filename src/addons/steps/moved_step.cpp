// # A step of bodies that move
//
// Pairs of such a step are those of the place where it ends. So what a pair knows, its slip and the work that it dissipated,
// goes by contact and node from the old pairs to the new ones. What a node dissipated that has no pair any more is kept in
// one sum.

#include <utility>
#include <vector>

#include "addons/steps/step_parts.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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
  for (std::size_t k = 0; k < names.size(); ++k)
    if (!stays[k]) state.dissipated_elsewhere += dissipation(static_cast<Index>(k));
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
  Step result{model.loop->solve(before, options, model, path.condensed, std::move(ledger)), past};
  if (result.solution.contact.report.status != SolveStatus::Solved) return result;
  PathState known = past;
  hand_on(names, model, known);
  result.state = after(known, time, model, VectorXd(), result.solution);
  return result;
}

}  // namespace signorini

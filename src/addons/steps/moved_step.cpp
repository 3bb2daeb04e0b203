// # A step of bodies that move
//
// Pairs of such a step are those of the place where it ends. So what a pair knows, its slip and the work that it dissipated,
// goes by contact and node from the old pairs to the new ones. What a node dissipated that has no pair any more is kept in
// one sum.

#include <algorithm>

#include "addons/steps/step_parts.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Where the nodes of a state are, of a model that has its given displacements.
Displaced displacement_of(const PathState& state, const Model& model) {
  if (state.steps == 0) return NodeArray(NodeArray::Zero(model.unknowns.held.rows(), 2));
  return displaced(model.unknowns, state.solution);
}

/// Rows of slips by contact and node: where pairs change, what they have slid so far goes on with these.
using SlipNames = std::vector<std::pair<std::size_t, Index>>;

SlipNames slip_names(const Model& model) {
  SlipNames names;
  for (const Index pair : model.law.pair) {
    const auto k = static_cast<std::size_t>(pair);
    names.emplace_back(model.contact_of[k], model.pairs.node[k]);
  }
  return names;
}

/// What rows of these names know, by the names of the rows that are now: zero for a row that is new.
VectorXd handed_on(const SlipNames& names, const VectorXd& values, const SlipNames& here) {
  VectorXd all = VectorXd::Zero(static_cast<Index>(here.size()));
  for (std::size_t k = 0; k < here.size() && values.size() > 0; ++k)
    if (const auto found = std::find(names.begin(), names.end(), here[k]); found != names.end())
      all(static_cast<Index>(k)) = values(found - names.begin());
  return all;
}

/// What rows knew that are no more.
double lost(const SlipNames& names, const VectorXd& values, const SlipNames& here) {
  double sum = 0;
  for (std::size_t k = 0; k < names.size() && values.size() > 0; ++k)
    if (std::find(here.begin(), here.end(), names[k]) == here.end())
      sum += values(static_cast<Index>(k));
  return sum;
}

}  // namespace

Step moved_step(const PathState& past, double time, Model& model, CondensedPath& path,
                Ledger ledger) {
  set_time(past.time, model);
  const Displaced before = displacement_of(past, model);
  set_time(time, model);
  model.loop->place(before, before, model);
  check_sizes(past, model);
  const SlipNames names = slip_names(model);
  path.condensed.free_displacement = free_displacement(time, model, path);
  SolverOptions options;
  options.start = past.contact_status;
  Step result{model.loop->solve(before, options, model, path.condensed, std::move(ledger)), past};
  if (result.solution.contact.report.status != SolveStatus::Solved) return result;
  PathState known = past;
  known.slip = handed_on(names, past.slip, slip_names(model));
  known.dissipation = handed_on(names, past.dissipation, slip_names(model));
  known.dissipated_elsewhere += lost(names, past.dissipation, slip_names(model));
  result.state = after(known, time, model, VectorXd(), result.solution);
  return result;
}

}  // namespace signorini

// # Going on from a state
//
// A state is all that the next step has to know. Whoever goes on from one that was saved may have changed the scene
// meanwhile. So a state is only taken if it solves its own step: its certificate is computed anew.

#include <algorithm>
#include <cmath>

#include "addons/steps/step_parts.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

void check_steps(const Model& model, const char* function) {
  require_input(!model.parts.empty(), function,
                ": the scene has no load steps; give its `path` times, or use solve()");
  for (const LoadPart& part : model.parts) {
    const auto is_own = [&](const History& history) { return history.name == part.history; };
    const std::vector<History>& histories = model.path.histories;
    require_input(part.history.empty() || std::any_of(histories.begin(), histories.end(), is_own), function,
                  ": no history of the path is called '", part.history, "', which a part of the loads follows");
  }
}

namespace {

bool is_empty_or(const VectorXd& part, Index size) { return part.size() == 0 || part.size() == size; }

bool is_empty(const PrimalDual& solution) {
  return solution.displacement.size() + solution.displacement_low.size() + solution.rigid.size() +
             solution.force.size() + solution.force_low.size() ==
         0;
}

/// Whether a solution is of so many unknowns and rows. Where forces have two parts, u has two parts.
bool fits(const PrimalDual& solution, Index unknowns, Index rows) {
  const Index low = solution.displacement_low.size();
  return solution.displacement.size() == unknowns && (low == 0 || low == unknowns) &&
         is_empty_or(solution.rigid, unknowns) && solution.force.size() == rows &&
         is_empty_or(solution.force_low, rows) && (solution.force_low.size() == 0 || low == unknowns);
}

/// Whether the way to a state is none, that of u alone, of bodies that move, or has all its parts.
bool is_way(const PrimalDual& way, Index unknowns, Index rows) {
  const Index besides =
      way.displacement_low.size() + way.rigid.size() + way.force.size() + way.force_low.size();
  return besides == 0 ? is_empty_or(way.displacement, unknowns)
                      : fits(way, unknowns, rows) && way.displacement_low.size() == unknowns &&
                            way.force_low.size() == rows;
}

/// The first part of a state that is not that of a model; empty if there is none.
const char* misfit(const PathState& state, const Model& model) {
  const Index pairs = model.pairs.weight.size();
  const Index slips = static_cast<Index>(model.law.pair.size());
  const Index n = model.unknowns.count;
  if (static_cast<Index>(state.contact_status.size()) != pairs) return "motion";
  if (state.slip.size() != slips) return "slip";
  if (state.increment.size() != slips) return "increment";
  if (state.dissipation.size() != slips) return "dissipation";
  if (!fits(state.solution, n, pairs + slips)) return "displacement or force";
  if (!is_way(state.way, n, pairs + slips)) return "way";
  const Index contacts = static_cast<Index>(model.contacts.size());
  return is_empty_or(state.dissipated_elsewhere, contacts) ? nullptr : "dissipated-elsewhere";
}

bool is_finite(const PrimalDual& solution) {
  return solution.displacement.allFinite() && solution.displacement_low.allFinite() &&
         solution.rigid.allFinite() && solution.force.allFinite() && solution.force_low.allFinite();
}

bool is_finite(const PathState& state) {
  return std::isfinite(state.time) && std::isfinite(state.began) && state.slip.allFinite() &&
         state.increment.allFinite() && state.dissipation.allFinite() && is_finite(state.way) &&
         is_finite(state.solution) && state.dissipated_elsewhere.allFinite();
}

}  // namespace

/// Whether the numbers of a state are those of a model.
void check_sizes(const PathState& state, const Model& model) {
  if (state.steps == 0) {
    const Index sizes = static_cast<Index>(state.contact_status.size()) + state.slip.size() +
                        state.increment.size() + state.dissipation.size() +
                        state.solution.displacement.size() + state.solution.force.size() +
                        state.dissipated_elsewhere.size();
    require_input(
        state.time == 0 && sizes == 0 && is_empty(state.solution) && is_empty(state.way),
        "a state before the first step is empty and of time 0, but "
        "this one is of time ",
        state.time, " and has ", sizes,
        " numbers: go on from one that an observer or read_state() got, or from PathState()");
    return;
  }
  const char* const part = misfit(state, model);
  require_input(part == nullptr, "the state at time ", state.time, " is of another scene: its ", part,
                " does not fit. It has ", state.solution.displacement.size(), " unknowns, ",
                state.contact_status.size(), " pairs and ", state.slip.size(),
                " slips, and this one ", model.unknowns.count, ", ", model.pairs.weight.size(),
                " and ", model.law.pair.size());
  require_input(
      state.steps > 0 && is_finite(state), "the state after step ", state.steps, " at time ",
      state.time, " has numbers that are not finite or steps below 0: go on from one that was solved");
}

/// Lets the slips of a model count from where they were.
void forget_slip(const VectorXd& slip, Model& model) {
  if (slip.size() > 0) model.programme.initial_gap.tail(slip.size()) -= slip;
}

PathState after(const PathState& past, double time, const Model& model, const VectorXd& given,
                const Solution& solution) {
  const ContactState& contact = solution.contact;
  PathState state;
  state.steps = past.steps + 1;
  state.time = time;
  state.dissipated_elsewhere = past.dissipated_elsewhere;
  state.contact_status = contact.contact_status;
  state.solution = solution.refined;
  state.began = past.time;
  if (share_gone_on(past, time, model) > 0 && is_linear(model))
    state.way = way_between(past.solution, state.solution);
  state.increment = increment(contact);
  state.slip = state.increment;
  state.dissipation = dissipated(contact);
  if (past.steps > 0) {
    state.slip += past.slip;
    state.dissipation += past.dissipation;
  }
  // What supports give is known: a sum of rounded increments would seem to move where they stand still.
  const Index pairs = model.pairs.weight.size();
  for (Index k = 0; k < given.size(); ++k)
    if (model.programme.A.row(pairs + k).norm() == 0) state.slip(k) = given(k);
  return state;
}

void stand(const PathState& state, Model& model) {
  set_time(state.time, model);
  if (!model.loop || state.solution.displacement.size() != model.unknowns.count) return;
  const Displaced there = displaced(model.unknowns, state.solution);
  model.loop->place(there, there, model);
}

namespace {

/// Turns a row round, and what it is multiplied by.
void turn(Index row, QuadraticProgramme& programme, PrimalDual& solution) {
  programme.A.row(row) *= -1;
  programme.initial_gap(row) *= -1;
  solution.force(row) *= -1;
}

/// Pairs that never lift off are turned round where they are in tension: there the other side presses.
Certificate certify_turned(const Model& model, PrimalDual solution) {
  if (model.two_sided.empty()) return certify(model.programme, solution, model.law);
  QuadraticProgramme programme = model.programme;
  const Index pairs = model.pairs.weight.size();
  for (const Index pair : model.two_sided) {
    if (solution.force(pair) >= 0) continue;
    turn(pair, programme, solution);
    for (std::size_t k = 0; k < model.law.pair.size(); ++k)
      if (model.law.pair[k] == pair) turn(pairs + static_cast<Index>(k), programme, solution);
  }
  return certify(programme, solution, model.law);
}

/// Whether a state solves its own step. \param model  with the loads of its time, and slips that count from its last step
void check_solved(const PathState& state, const Model& model) {
  const Certificate certificate =
      model.loop ? model.loop->certify(state.solution, model) : certify_turned(model, state.solution);
  require_input(
      certificate.holds(), "the state at time ", state.time,
      " is of another scene, or what comes before time ", shortest(state.time),
      " was changed, but only what comes later may: its displacements and forces do not solve "
      "this one then (",
      certificate, "). Go on with the scene that it was saved from, or start anew");
}

/// A state of bodies that move: its pairs are those of the place where it has them. The model keeps its own, as the factor
/// knows them.
void check_moved_state(const PathState& state, Model model) {
  try {
    stand(state, model);
  } catch (const ProblemError& error) {
    throw ProblemError(text("the state at time ", state.time,
                            " is of another scene: where it has the bodies, ", error.what()));
  }
  check_sizes(state, model);
  forget_slip(-state.increment, model);  // where it stands nothing has slid yet
  check_solved(state, model);
}

}  // namespace

void check_state(const PathState& state, Model& model) {
  if (!model.loop || state.steps == 0) check_sizes(state, model);
  if (state.steps == 0) return;
  set_time(state.time, model);
  if (model.loop) return check_moved_state(state, model);
  forget_slip(state.slip - state.increment, model);
  check_solved(state, model);
}

std::optional<PathTotals> totals(const PathState* state) {
  if (state == nullptr) return {};
  return PathTotals{state->slip, state->dissipation, state->dissipated_elsewhere};
}

}  // namespace signorini

#include "addons/steps/steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "addons/steps/steps_limit.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// How far a step that ends at the limit stays away from it, where pairs that all slide would hold nothing.
constexpr double limit_margin = 1e-10;

VectorField scaled(double factor, const VectorField& field) {
  if (!field) return {};
  return [factor, field](const Eigen::Vector2d& x) { return Eigen::Vector2d(factor * field(x)); };
}

void add_scaled(double factor, const Loads& loads, Loads& sum) {
  if (loads.body_force) sum.body_force = scaled(factor, loads.body_force);
  for (EdgeLoad load : loads.edges) {
    load.pressure *= factor;
    load.traction = scaled(factor, load.traction);
    sum.edges.push_back(std::move(load));
  }
  for (PointForce load : loads.points) {
    load.force *= factor;
    sum.points.push_back(std::move(load));
  }
}

void add_scaled(double factor, const Eigenstrain& part, Eigenstrain& sum) {
  if (factor == 0 || !part) return;
  sum = [factor, part, rest = std::move(sum)](const Material& material, const Eigen::Vector2d& x) {
    const Eigen::Vector4d strain = factor * part(material, x);
    return rest ? Eigen::Vector4d(rest(material, x) + strain) : strain;
  };
}

void check_steps(const Model& model, const char* function) {
  require_input(!model.parts.empty(), function,
                ": the scene has no load steps; give its `path` times, or use solve()");
}

/// Whether the numbers of a state are those of a model.
void check_sizes(const PathState& state, const Model& model) {
  const Index pairs = model.pairs.weight.size();
  const Index slips = static_cast<Index>(model.law.pair.size());
  const PrimalDual& solution = state.solution;
  if (state.steps == 0) {
    const Index sizes = static_cast<Index>(state.contact_status.size()) + state.slip.size() +
                        state.increment.size() + state.dissipation.size() +
                        solution.displacement.size() + solution.displacement_low.size() +
                        solution.rigid.size() + solution.force.size();
    require_input(
        state.time == 0 && sizes == 0,
        "a state before the first step is empty and of time 0, but "
        "this one is of time ",
        state.time, " and has ", sizes,
        " numbers: go on from one that an observer or read_state() got, or from PathState()");
    return;
  }
  const Index n = model.unknowns.count;
  const bool fits =
      static_cast<Index>(state.contact_status.size()) == pairs && state.slip.size() == slips &&
      state.increment.size() == slips && state.dissipation.size() == slips &&
      solution.displacement.size() == n &&
      (solution.displacement_low.size() == 0 || solution.displacement_low.size() == n) &&
      (solution.rigid.size() == 0 || solution.rigid.size() == n) &&
      solution.force.size() == pairs + slips;
  require_input(fits, "the state at time ", state.time, " is of another scene: it has ",
                solution.displacement.size(), " unknowns, ", state.contact_status.size(),
                " pairs and ", state.slip.size(), " slips, but this one ", n, ", ", pairs, " and ",
                slips);
  require_input(
      state.steps > 0 && std::isfinite(state.time) && state.slip.allFinite() &&
          state.increment.allFinite() && state.dissipation.allFinite(),
      "the state after step ", state.steps, " at time ", state.time,
      " has numbers that are not finite or steps below 0: go on from one that was solved");
}

/// Lets the slips of a model count from where they were.
void forget_slip(const VectorXd& slip, Model& model) {
  if (slip.size() > 0) model.programme.initial_gap.tail(slip.size()) -= slip;
}

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

/// Says why a step failed, and until when its loads can be balanced at all.
void tell(const Model& model, const Solution& failed, double time, PathEnd& end) {
  const std::string& why = failed.contact.reason;
  end.status = failed.contact.report.status;
  end.reason = text("the step from time ", shortest(end.state.time), " to ", shortest(time),
                    " was not solved: ", to_string(end.status), why.empty() ? "" : ": ", why,
                    failed.unbounded_direction.empty() ? "" : ": ", failed.unbounded_direction);
  if (end.limit)
    end.reason += text(". Contact", model.law.pair.empty() ? " holds" : " and friction hold",
                       " the loads until time ", *end.limit, " at most");
}

PathEnd ended(PathEnd end) {
  end.reason += text("; the last good state is that of time ", shortest(end.state.time));
  return end;
}

/// \param given  slips in total if no unknown moves
PathState after(const PathState& past, double time, const Model& model, const VectorXd& given,
                const Solution& solution) {
  const ContactState& contact = solution.contact;
  PathState state = past;
  ++state.steps;
  state.time = time;
  state.contact_status = all_statuses(contact);
  state.solution = solution.refined;
  state.increment = increment(contact);
  const VectorXd lost = dissipated(contact);
  if (past.steps == 0) {
    state.slip = state.increment;
    state.dissipation = lost;
  } else {
    state.slip += state.increment;
    state.dissipation += lost;
  }
  // What supports give is known: a sum of rounded increments would seem to move where they stand still.
  const Index pairs = model.pairs.weight.size();
  for (Index k = 0; k < given.size(); ++k)
    if (model.programme.A.row(pairs + k).norm() == 0) state.slip(k) = given(k);
  return state;
}

}  // namespace

void stand(const PathState& state, Model& model) {
  set_time(state.time, model);
  if (!model.loop || state.solution.displacement.size() != model.unknowns.count) return;
  const Displaced there = displaced(model.unknowns, state.solution);
  model.loop->place(there, there, model);
}

namespace {

/// Whether a state solves its own step. \param model  with the loads of its time, and slips that count from its last step
void check_solved(const PathState& state, const Model& model) {
  const Certificate certificate = model.loop
                                      ? model.loop->certify(state.solution, model)
                                      : certify(model.programme, state.solution, model.law);
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

CondensedPath condense_path(const Model& model, Ledger& ledger) {
  check_steps(model, "condense_path");
  CondensedPath path{condense(model, ledger), {}};
  const Ledger::Phase phase(ledger, "condensation");
  for (const LoadPart& part : model.parts) {
    const bool acts = (part.load.array() != 0).any();
    path.free_displacement.push_back(acts ? path.condensed.factor.solve(part.load)
                                          : VectorXd::Zero(part.load.size()));
    ledger.count("solves", acts ? 1 : 0);
  }
  return path;
}

void set_time(double time, Model& model) {
  check_steps(model, "set_time");
  QuadraticProgramme& programme = model.programme;
  programme.load.setZero();
  for (const LoadPart& part : model.parts)
    programme.load += factor_of(model.path, part, time) * part.load;
  if (!model.loop) {  // which finds gaps by itself
    programme.initial_gap.setZero();
    for (const LoadPart& part : model.parts)
      programme.initial_gap += factor_of(model.path, part, time) * part.movement;
    model.pairs.initial_gap = programme.initial_gap.head(model.pairs.weight.size());
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    BodyModel& body = model.bodies[b];
    body.loads = {};
    body.material.eigenstrain = {};
    body.unknowns.held.setZero();
    for (const LoadPart& part : model.parts) {
      const double f = factor_of(model.path, part, time);
      add_scaled(f, part.loads[b], body.loads);
      add_scaled(f, part.eigenstrain[b], body.material.eigenstrain);
      body.unknowns.held += f * part.held[b];
    }
    model.unknowns.held.middleRows(body.first_node, body.mesh.n_nodes()) = body.unknowns.held;
  }
}

std::optional<PathTotals> totals(const PathState* state) {
  if (state == nullptr) return {};
  return PathTotals{state->slip, state->dissipation};
}

namespace {

/// u without contact forces at the time that a model was set to.
VectorXd free_displacement(double time, const Model& model, const CondensedPath& path) {
  VectorXd free = VectorXd::Zero(model.unknowns.count);
  for (std::size_t k = 0; k < model.parts.size(); ++k)
    free += factor_of(model.path, model.parts[k], time) * path.free_displacement[k];
  return free;
}

/// A step of bodies that move: its pairs come and go, and take along what they know.
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
  known.dissipated_elsewhere += past.dissipation.sum() - known.dissipation.sum();
  result.state = after(known, time, model, VectorXd(), result.solution);
  return result;
}

}  // namespace

Step step(const PathState& past, double time, Model& model, CondensedPath& path, Ledger ledger) {
  check_steps(model, "step");
  if (!model.loop) check_sizes(past, model);
  require_input(time > past.time, "load step: it must end after time ", past.time,
                ", where the last one ended, got ", time);
  if (model.loop) return moved_step(past, time, model, path, std::move(ledger));
  // [step]
  set_time(time, model);  // loads, temperatures and given displacements of that time
  const VectorXd given =
      model.programme.initial_gap.tail(static_cast<Index>(model.law.pair.size()));
  forget_slip(past.slip, model);  // slip counts from the step before
  move_freely(model, free_displacement(time, model, path), path.condensed);
  SolverOptions options;
  options.start = past.contact_status;  // begin with what the pairs did last
  Step result{solve(model, path.condensed, model.solver, std::move(ledger), options), past};
  Solution& solution = result.solution;
  if (solution.contact.report.status == SolveStatus::Solved)
    result.state = after(past, time, model, given, solution);
  // [step]
  return result;
}

namespace {

/// A path while it is walked. All that is decided here follows from the state and from the times that are given, or a
/// path that goes on from the state would take other steps.
struct Walk {
  Model& model;
  CondensedPath& path;
  Ledger ledger;
  const StepObserver& observe;
  PathEnd end;
  double before = 0;  // the given times around the step
  double target = 0;
  double held = std::numeric_limits<double>::infinity();  // how far statics lets the path go

  bool goes(double time);
  bool passes_change(double reach, bool looks_for_it);
  bool reaches(double time);
};

/// Takes one step, as long as it may be.
bool Walk::goes(double time) {
  const Step next = step(end.state, time, model, path, std::exchange(ledger, {}));
  if (next.solution.contact.report.status == SolveStatus::Solved) {
    end.state = next.state;
    if (observe) observe(model, next);
    return true;
  }
  if (next.solution.contact.unbounded_direction.size() > 0 && !end.limit && !model.loop)
    end.limit = balanced_until(before, target, model, path.condensed.problem);
  tell(model, next.solution, time, end);
  return false;
}

/// Steps just beyond, or just before, the place on the way where pairs begin to slide or to open.
bool Walk::passes_change(double reach, bool looks_for_it) {
  const double begin = end.state.time;
  const double margin = limit_margin * (target - before);
  std::optional<double> share;
  if (looks_for_it) share = first_change(end.state, path.condensed.problem);
  const double change = begin + share.value_or(0) * (reach - begin);
  const bool there = share && change - margin <= begin;
  const double next = there ? change + margin : change - margin;
  if (share && next > begin && goes(next)) return true;
  if (there) end.limit = change;
  end.reason += text(". The step to ", target, " was halved ", model.path.halvings, " times",
                     there ? text(", and nothing is found beyond time ", change,
                                  ", where pairs begin to slide or to open")
                           : "");
  return false;
}

/// Goes on to the next given time, in parts if that must be.
bool Walk::reaches(double time) {
  before = std::exchange(target, time);
  const int most = model.path.halvings;
  double reach = target;
  int foreseen = 0;  // changes of pairs
  for (int halved = 0; end.state.time < target;) {
    const double begin = end.state.time;
    const double half = begin + 0.5 * (reach - begin);  // times may have no digit for it
    const bool known = end.limit.has_value();
    if (goes(reach)) {
      if (reach >= held) return false;
      reach = std::min(target, held);
      halved = 0;
    } else if (end.status == SolveStatus::SlidTooFar || end.status == SolveStatus::TurnedTooFar) {
      return false;  // no shorter way leads there
    } else if (end.limit && !known) {
      held = *end.limit - limit_margin * (target - before);
      if (most == 0 || held <= begin) return false;
      reach = held;
    } else if (begin < half && half < reach && ++halved <= most) {
      ++end.halvings;
      reach = half;
    } else if (passes_change(reach, foreseen++ < most && !model.loop)) {
      reach = target;
      halved = 0;
    } else {
      return false;
    }
  }
  if (end.limit) return true;
  end.status = SolveStatus::Solved;
  end.reason.clear();
  return true;
}

}  // namespace

PathEnd solve_steps(const Scene& scene, const StepObserver& observe, const PathState& from) {
  require_input(scene.path.has_value(),
                "solve_steps: the scene has no load steps; give its `path` times, or use solve()");
  Ledger ledger;
  Model model = build(scene, ledger);
  check_state(from, model);
  CondensedPath path = condense_path(model, ledger);
  return solve_steps(model, path, std::move(ledger), observe, from);
}

PathEnd solve_steps(Model& model, CondensedPath& path, Ledger ledger, const StepObserver& observe,
                    const PathState& from) {
  Walk walk{model, path, std::move(ledger), observe, PathEnd{from}};
  for (const double time : model.path.times)
    if (!walk.reaches(time)) return ended(std::move(walk.end));
  return std::move(walk.end);
}

}  // namespace signorini

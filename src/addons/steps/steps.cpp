#include "addons/steps/steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "addons/certified/separate.hpp"
#include "addons/steps/step_parts.hpp"
#include "addons/steps/steps_limit.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/scaled.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

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

}  // namespace

CondensedPath condense_path(const Model& model, Ledger& ledger) {
  check_steps(model, "condense_path");
  CondensedPath path{condense(model, ledger), {}};
  if (!model.loop) path.condensed.known = known_matrices(model.programme, model.law);
  if (is_linear(model)) path.condensed.known.scaled = std::make_shared<ScaledProblem>();
  const Ledger::Phase phase(ledger, "condensation");
  for (const LoadPart& part : model.parts) {
    const bool acts = (part.load.array() != 0).any();
    path.free_displacement.push_back(acts ? path.condensed.factor.solve(part.load)
                                          : VectorXd::Zero(part.load.size()));
    ledger.count("solves", acts ? 1 : 0);
  }
  return path;
}

VectorXd free_displacement(double time, const Model& model, const CondensedPath& path) {
  VectorXd free = VectorXd::Zero(model.unknowns.count);
  for (std::size_t k = 0; k < model.parts.size(); ++k)
    free += factor_of(model.path.histories, model.parts[k].history, time) * path.free_displacement[k];
  return free;
}

void set_time(double time, Model& model) {
  check_steps(model, "set_time");
  QuadraticProgramme& programme = model.programme;
  model.time = time;
  programme.load.setZero();
  for (const LoadPart& part : model.parts)
    programme.load += factor_of(model.path.histories, part.history, time) * part.load;
  if (!model.loop) {  // which finds gaps by itself
    programme.initial_gap.setZero();
    for (const LoadPart& part : model.parts)
      programme.initial_gap += factor_of(model.path.histories, part.history, time) * part.movement;
    model.pairs.initial_gap = programme.initial_gap.head(model.pairs.weight.size());
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    BodyModel& body = model.bodies[b];
    body.loads = {};
    body.material.eigenstrain = {};
    body.unknowns.held.setZero();
    for (const LoadPart& part : model.parts) {
      const double f = factor_of(model.path.histories, part.history, time);
      add_scaled(f, part.loads[b], body.loads);
      add_scaled(f, part.eigenstrain[b], body.material.eigenstrain);
      body.unknowns.held += f * part.held[b];
    }
    model.unknowns.held.middleRows(body.first_node, body.mesh.n_nodes()) = body.unknowns.held;
  }
}

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
  path.condensed.expected = extrapolated(past, time, model);  // if no pair changes
  SolverOptions options;
  options.start = past.contact_status;  // begin with what the pairs did last
  Solution solution = solve(model, path.condensed, model.solver, std::move(ledger), options);
  const bool solved = solution.contact.report.status == SolveStatus::Solved;
  PathState state = solved ? after(past, time, model, given, solution) : past;
  // [step]
  return {std::move(solution), std::move(state)};
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
  Index begun = end.state.steps;  // steps that were done before this walk
  double before = 0;  // the given times around the step
  double target = 0;
  double held = std::numeric_limits<double>::infinity();  // how far statics lets the path go

  Step taken(double time);
  bool goes(double time);
  bool passes_change(double reach, bool looks_for_it);
  bool reaches(double time);
};

/// A step of this path. What its first one refuses is an input that is wrong. Where bodies move, what a later one cannot do is a step
/// that is not solved, and all before it stays.
Step Walk::taken(double time) {
  try {
    return step(end.state, time, model, path, std::exchange(ledger, {}));
  } catch (const ProblemError& error) {
    if (end.state.steps == begun || !model.loop) throw;
    Step none;
    none.state = end.state;
    none.solution.contact.report.status = SolveStatus::Breakdown;
    none.solution.contact.reason = error.what();
    return none;
  }
}

/// Takes one step, as long as it may be.
bool Walk::goes(double time) {
  Step next = taken(time);
  if (next.solution.contact.report.status == SolveStatus::Solved) {
    if (observe) observe(model, next);
    end.state = std::move(next.state);
    return true;
  }
  if (next.solution.contact.unbounded_direction.size() > 0 && !end.limit && !model.loop)
    end.limit = balanced_until(before, target, model, path.condensed.problem);
  tell(model, next.solution, time, end);
  ledger = std::move(next.solution.ledger);  // counts in the step that comes of the halves
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
  const int most = model.path.halvings;
  end.reason += text(
      ". The step to ", target,
      most == 0 ? text(" may not be halved (halvings = 0)") : text(" was halved ", most, " times"),
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

#include "signorini/scene/frictional.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/complementarity/friction_solvers.hpp"
#include "signorini/complementarity/refine.hpp"
#include "signorini/complementarity/rounding.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd stacked(const VectorXd& gaps, const VectorXd& slips) {
  VectorXd all(gaps.size() + slips.size());
  all << gaps, slips;
  return all;
}

/// Puts the gaps and slips that displacements give in the place of those that the condensed data gave.
void correct(FrictionProblem& problem, const VectorXd& moved, const FrictionState& state) {
  VectorXd free = moved - problem.compliance * stacked(state.force, state.friction);
  if (problem.rigid.cols() > 0) free -= problem.rigid * state.amplitude;
  const Index pairs = state.force.size();
  problem.free_gap = free.head(pairs);
  problem.free_slip = free.tail(pairs);
}

/// Puts what is left along the rigid motions in the place of the load: K u, which should do no work there, does
/// what rounding makes of it, and forces that balance the load alone would leave that at one node per motion.
void correct(FrictionProblem& problem, const QuadraticProgramme& programme, PrimalDual strained,
             const Eigen::MatrixXd& shapes) {
  if (shapes.cols() == 0) return;
  strained.force.setZero();
  problem.resultant = -shapes.transpose() * equilibrium_residual(programme, strained);
}

/// Forces and displacements that belong together, and the problem that the forces solve.
struct Settled {
  FrictionProblem problem;  ///< with gaps and slips as the displacements give them
  FrictionState state;
  Report total;        ///< of all passes
  PrimalDual refined;  ///< with the forces of all rows: gaps, then slips
};

/// One more pass of the solver.
void solve_again(const FrictionSolver& method, Settled& now) {
  now.state = method.solve(now.problem, {});
  const Report& report = now.state.report;
  now.total.iterations += report.iterations;
  now.total.factorisations += report.factorisations;
  now.total.history.insert(now.total.history.end(), report.history.begin(), report.history.end());
  now.total.status = report.status;
}

/// Displacements of the forces, and what they correct. \param strained  what strains the bodies so far, refined
/// here \return the largest change of a displacement
double refine(const QuadraticProgramme& programme, const ContactLastFactor& factor,
              const Eigen::MatrixXd& shapes, PrimalDual& strained, Settled& now) {
  strained.force = stacked(now.state.force, now.state.friction);
  // The residual without the rigid part: K does not feel it, and its rounding must not count.
  VectorXd change = factor.solve(equilibrium_residual(programme, strained));
  add_displacement(strained, change);
  now.refined = strained;
  if (shapes.cols() > 0) {
    now.refined.rigid = shapes * now.state.amplitude;
    add_displacement(now.refined, now.refined.rigid);
  }
  const VectorXd moved = gaps(programme, now.refined);
  const Index pairs = now.state.gap.size();
  now.state.gap = moved.head(pairs);
  now.state.slip = moved.tail(pairs);
  correct(now.problem, moved, now.state);
  correct(now.problem, programme, strained, shapes);
  return largest(change);
}

/// Solves and refines in turn until displacements settle.
Settled settle(const Model& model, const Condensed& condensed, const FrictionSolver& method,
               const QuadraticProgramme& programme, Ledger& ledger) {
  Settled now{*condensed.friction, {}, {}, {}};
  const Eigen::MatrixXd shapes = mode_shapes(model.modes);
  PrimalDual strained{condensed.free_displacement, VectorXd::Zero(model.unknowns.count), {}};
  double last = std::numeric_limits<double>::infinity();
  while (true) {
    {
      const Ledger::Phase phase(ledger, "contact");
      solve_again(method, now);
    }
    if (now.state.report.status != Status::Solved) return now;
    const Ledger::Phase phase(ledger, "refinement");
    ledger.count("sweeps", 1);
    const double step = refine(programme, condensed.factor, shapes, strained, now);
    const double rounding = epsilon * largest(strained.displacement);
    if (step <= rounding || !(step < 0.5 * last)) return now;
    last = step;
  }
}

/// With the friction forces as loads the rest is contact without friction.
QuadraticProgramme pushed(const Model& model, const VectorXd& friction) {
  QuadraticProgramme programme = model.programme;
  programme.load += model.friction->T.transpose() * friction;
  return programme;
}

/// Refines normal forces and displacements from the original data, with the friction forces as they are. A
/// slender body needs it, whose displacements depend on the last digits of the forces.
void refine_without_friction(const Model& model, const Condensed& condensed, Settled& now) {
  std::vector<Index> closed;
  for (Index pair = 0; pair < now.state.force.size(); ++pair)
    if (now.state.status[static_cast<std::size_t>(pair)] != PairStatus::Open)
      closed.push_back(pair);
  PrimalDual start = now.refined;
  start.force = now.state.force;
  const Eigen::MatrixXd shapes = mode_shapes(model.modes);
  Refinement better = signorini::refine(
      pushed(model, now.state.friction),
      [&](const VectorXd& load) { return condensed.factor.solve(load); },
      condensed.problem.compliance, std::move(start), closed, shapes);
  if (shapes.cols() > 0) now.state.amplitude += better.amplitude;
  now.state.force = better.solution.force;
  now.state.gap = better.gap;
  now.refined = std::move(better.solution);
}

/// Puts the friction forces of sliding pairs at the bounds that refined normal forces set.
void slide(Settled& now) {
  FrictionState& state = now.state;
  for (Index pair = 0; pair < state.force.size(); ++pair)
    if (state.status[static_cast<std::size_t>(pair)] == PairStatus::Slip)
      state.friction(pair) =
          std::copysign(now.problem.coefficient(pair) * std::max(0.0, state.force(pair)) +
                            now.problem.cohesion(pair),
                        state.friction(pair));
}

/// Refines and certifies; friction forces follow the normal ones, again and again as long as that helps.
std::pair<Certificate, FrictionCertificate> certified(const Model& model,
                                                      const Condensed& condensed,
                                                      const QuadraticProgramme& programme,
                                                      Settled& now) {
  for (double last = std::numeric_limits<double>::infinity();;) {
    refine_without_friction(model, condensed, now);
    slide(now);
    PrimalDual all = now.refined;
    all.force = stacked(now.state.force, now.state.friction);
    const VectorXd moved = gaps(programme, all);
    now.state.slip = moved.tail(now.state.slip.size());
    correct(now.problem, moved, now.state);
    const Certificate certificate = certify(pushed(model, now.state.friction), now.refined);
    FrictionCertificate friction = certify(now.problem, now.state);
    friction.penetration = certificate.penetration;
    friction.complementarity = certificate.complementarity;
    friction.equilibrium = certificate.equilibrium;
    const double worst = std::max(certificate.worst(), friction.worst());
    if (worst <= epsilon || !(worst < 0.5 * last)) return {certificate, friction};
    last = worst;
  }
}

/// What the solution has beside the outcome of the solver.
void recover(const Model& model, const std::pair<Certificate, FrictionCertificate>& certificates,
             Settled& now, Solution& solution) {
  const auto& [certificate, friction] = certificates;
  solution.certificate = certificate;
  solution.displacements = displacements_of_bodies(model, now.refined.displacement);
  solution.contact.force = now.state.force;
  solution.contact.gap = now.state.gap;
  for (Index pair = 0; pair < now.state.force.size(); ++pair)
    if (now.state.status[static_cast<std::size_t>(pair)] != PairStatus::Open)
      solution.contact.active.push_back(pair);
  solution.amplitude = now.state.amplitude;
  solution.pressure = now.state.force.cwiseQuotient(model.pairs.weight);
  if (!friction.holds() || !certificate.holds()) {
    solution.contact.report.status = Status::Breakdown;
    now.state.report.status = Status::Breakdown;
    now.state.reason = "the forces and displacements found do not fit the original data";
  }
  if (now.state.uniqueness == Uniqueness::Doubtful)
    solution.notes.emplace_back(
        "friction: there may be other solutions of the same loads, this is one of them");
  solution.refined = std::move(now.refined);
  solution.friction = FrictionOutcome{std::move(now.state), friction};
}

}  // namespace

std::vector<NodeArray> displacements_of_bodies(const Model& model, const VectorXd& displacement) {
  const NodeArray all = expand(model.unknowns, displacement);
  std::vector<NodeArray> bodies;
  for (const BodyModel& body : model.bodies)
    bodies.emplace_back(all.middleRows(body.first_node, body.mesh.n_nodes()));
  return bodies;
}

std::string escape_in_words(const Model& model, const VectorXd& escape) {
  std::string words;
  const double most = largest(escape);
  for (Index k = 0; k < escape.size(); ++k)
    if (std::abs(escape(k)) > 1e-6 * most)
      words += (words.empty() ? "" : "; ") + model.modes[static_cast<std::size_t>(k)].sentence;
  return words;
}

QuadraticProgramme with_slips(const Model& model) {
  QuadraticProgramme all = model.programme;
  all.A = below(model.programme.A, -model.friction->T);
  all.initial_gap = stacked(model.programme.initial_gap, model.friction->initial_slip);
  return all;
}

void set_friction_apart(const FrictionModel& friction, Condensed& condensed) {
  const Index pairs = friction.initial_slip.size();
  const ContactProblem& all = condensed.problem;
  condensed.friction =
      FrictionProblem{all.compliance,           all.free_gap.head(pairs), all.free_gap.tail(pairs),
                      friction.law.coefficient, friction.law.cohesion,    condensed.rigid,
                      condensed.resultant};
  condensed.problem = {condensed.friction->compliance.topLeftCorner(pairs, pairs),
                       condensed.friction->free_gap};
  condensed.rigid = condensed.friction->rigid.topRows(pairs);
}

Solution solve_frictional(const Model& model, const Condensed& condensed, const std::string& solver,
                          Ledger& ledger) {
  const QuadraticProgramme programme = with_slips(model);
  const FrictionSolver& method = find_friction_solver(solver);
  Settled now = settle(model, condensed, method, programme, ledger);
  Solution solution;
  solution.contact.report = std::move(now.total);
  if (solution.contact.report.status == Status::Solved) {
    const Ledger::Phase phase(ledger, "recovery");
    recover(model, certified(model, condensed, programme, now), now, solution);
    return solution;
  }
  solution.escape = escape_in_words(model, now.state.escape);
  constexpr double none = std::numeric_limits<double>::infinity();
  solution.friction = FrictionOutcome{std::move(now.state), {none, none, none, none, none, none}};
  return solution;
}

}  // namespace signorini

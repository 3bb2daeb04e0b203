#include "signorini/scene/frictional.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/complementarity/friction_solvers.hpp"
#include "signorini/complementarity/refine.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Normal forces, then friction forces: what belongs to the rows of the programme.
VectorXd forces_of(const FrictionState& state) {
  VectorXd force(state.force.size() + state.friction.size());
  force << state.force, state.friction;
  return force;
}

double largest(const VectorXd& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

/// Puts the gaps and slips that displacements give in the place of those that the condensed data gave.
void correct(FrictionProblem& problem, const VectorXd& moved, const FrictionState& state) {
  VectorXd free = moved - problem.compliance * forces_of(state);
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

/// The largest force that is missing at a node, over the largest load or contact force.
double missing_force(const Model& model, const PrimalDual& solution) {
  const VectorXd contact = model.programme.A.transpose() * solution.force;
  const double scale = std::max(largest(model.programme.load), largest(contact));
  const double missing = largest(equilibrium_residual(model.programme, solution));
  return missing == 0 ? 0 : missing / scale;
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

Solution solve_frictional(const Model& model, const Condensed& condensed, const std::string& solver,
                          Ledger& ledger) {
  const FrictionSolver& method = find_friction_solver(solver);
  const Index pairs = model.pairs.initial_gap.size();
  FrictionProblem problem{condensed.problem.compliance,
                          condensed.problem.free_gap.head(pairs),
                          condensed.problem.free_gap.tail(pairs),
                          model.friction->coefficient,
                          model.friction->cohesion,
                          condensed.rigid,
                          condensed.resultant};
  const Eigen::MatrixXd shapes = mode_shapes(model.modes);
  PrimalDual start{condensed.free_displacement, VectorXd::Zero(model.unknowns.count), {}};
  Solution solution;
  FrictionState state;
  Report total;
  double last = std::numeric_limits<double>::infinity();
  while (true) {
    {
      const Ledger::Phase phase(ledger, "contact");
      state = method.solve(problem, {});
      total.iterations += state.report.iterations;
      total.factorisations += state.report.factorisations;
      total.history.insert(total.history.end(), state.report.history.begin(),
                           state.report.history.end());
      total.status = state.report.status;
    }
    if (state.report.status != Status::Solved) break;
    const Ledger::Phase phase(ledger, "refinement");
    // The residual without the rigid part: K does not feel it, and its rounding must not count.
    PrimalDual now = start;
    now.force = forces_of(state);
    VectorXd change = condensed.factor.solve(equilibrium_residual(model.programme, now));
    add_displacement(now, change);
    start = now;
    ledger.count("sweeps", 1);
    if (shapes.cols() > 0) {
      now.rigid = shapes * state.amplitude;
      add_displacement(now, now.rigid);
    }
    const VectorXd moved = gaps(model.programme, now);
    state.gap = moved.head(pairs);
    state.slip = moved.tail(pairs);
    correct(problem, moved, state);
    correct(problem, model.programme, start, shapes);
    solution.refined = std::move(now);
    const double step = largest(change);
    const bool settled =
        step <= std::numeric_limits<double>::epsilon() * largest(start.displacement);
    if (settled || !(step < 0.5 * last)) break;
    last = step;
  }
  solution.contact.report = std::move(total);
  if (solution.contact.report.status == Status::Solved) {
    const Ledger::Phase phase(ledger, "recovery");
    solution.displacements = displacements_of_bodies(model, solution.refined.displacement);
    solution.contact.force = state.force;
    solution.contact.gap = state.gap;
    for (Index pair = 0; pair < pairs; ++pair)
      if (state.status[static_cast<std::size_t>(pair)] != PairStatus::Open)
        solution.contact.active.push_back(pair);
    solution.amplitude = state.amplitude;
    solution.pressure = state.force.cwiseQuotient(model.pairs.weight);
    FrictionCertificate certificate = certify(problem, state);
    certificate.equilibrium =
        std::max(certificate.equilibrium, missing_force(model, solution.refined));
    solution.certificate = {certificate.penetration, certificate.tension,
                            certificate.complementarity, certificate.equilibrium, 0};
    if (!certificate.holds()) solution.contact.report.status = Status::Breakdown;
    solution.friction = FrictionOutcome{std::move(state), certificate};
  } else {
    solution.escape = escape_in_words(model, state.escape);
  }
  return solution;
}

}  // namespace signorini

#include <set>
#include <utility>

#include "signorini/complementarity/refine.hpp"
#include "signorini/complementarity/solvers.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The first state of the condensed problem and its refinement; repeated while refinement refutes it.
Refinement solve_and_refine(const Model& model, const Condensed& condensed, const Solver& solver,
                            Ledger& ledger, ContactState& state) {
  const auto solve_stiffness = [&](const Eigen::VectorXd& load) {
    return condensed.factor.solve(load);
  };
  ContactProblem problem = condensed.problem;
  PrimalDual start{condensed.free_displacement, {}, {}};
  Refinement refined;
  std::set<std::vector<Index>> refuted;
  while (true) {
    {
      const Ledger::Phase phase(ledger, "contact");
      const Report earlier = state.report;
      state = solver.solve(problem, {});
      state.report.iterations += earlier.iterations;
      state.report.factorisations += earlier.factorisations;
      state.report.history.insert(state.report.history.begin(), earlier.history.begin(),
                                  earlier.history.end());
    }
    if (state.report.status != Status::Solved) return refined;
    const Ledger::Phase phase(ledger, "refinement");
    start.force = state.force;
    refined = refine(model.programme, solve_stiffness, problem.compliance, start, state.active);
    ledger.count("sweeps", refined.sweeps);
    if (refined.confirmed) return refined;
    // Rounding cannot decide between sets that come back; the certificate will say whether it matters.
    if (!refuted.insert(state.active).second) return refined;
    problem.free_gap = refined.gap - problem.compliance * refined.solution.force;
    start = refined.solution;
  }
}

}  // namespace

Model build(const Scene& scene, Ledger& ledger) {
  Plan now = [&] {
    const Ledger::Phase phase(ledger, "plan");
    return plan(scene);
  }();
  const Ledger::Phase phase(ledger, "assembly");
  Model model{scene.mesh, find_element(scene.element), scene.material, std::move(now.unknowns),
              {},         std::move(now.gaps)};
  LinearSystem system =
      assemble(model.mesh, model.element, model.material, model.unknowns, scene.loads);
  ledger.count("unknowns", model.unknowns.count);
  ledger.count("pairs", model.gaps.A.rows());
  model.programme.stiffness.swap(system.stiffness);
  model.programme.load.swap(system.load);
  model.programme.A = model.gaps.A;
  model.programme.initial_gap = model.gaps.initial_gap;
  return model;
}

Condensed condense(const Model& model, Ledger& ledger) {
  const QuadraticProgramme& programme = model.programme;
  const auto describe = [&model](Index unknown) {
    return model.unknowns.describe(model.mesh, unknown);
  };
  ContactLastFactor factor = [&] {
    const Ledger::Phase phase(ledger, "factor");
    const std::vector<Index> last = contact_unknowns(programme.A);
    const EliminationOrder order = [&] {
      const Ledger::Phase ordering(ledger, "ordering");
      return nested_dissection(programme.stiffness, unknown_positions(model.mesh, model.unknowns),
                               last);
    }();
    return ContactLastFactor(programme.stiffness, order, static_cast<Index>(last.size()), ledger,
                             describe);
  }();
  const Ledger::Phase phase(ledger, "condensation");
  Condensed condensed{std::move(factor), {}, {}};
  condensed.free_displacement = condensed.factor.solve(programme.load);
  condensed.problem.compliance = condensed.factor.compliance(programme.A);
  condensed.problem.free_gap =
      gaps(programme, {condensed.free_displacement, {}, Eigen::VectorXd::Zero(programme.A.rows())});
  return condensed;
}

Solution solve(const Model& model, const Condensed& condensed, const std::string& solver,
               Ledger ledger) {
  Solution solution;
  Refinement refined =
      solve_and_refine(model, condensed, find_solver(solver), ledger, solution.contact);
  if (solution.contact.report.status == Status::Solved) {
    const Ledger::Phase phase(ledger, "recovery");
    solution.displacements = expand(model.unknowns, refined.solution.displacement);
    solution.contact.force = refined.solution.force;
    solution.contact.gap = refined.gap;
    solution.pressure = solution.contact.force.cwiseQuotient(model.gaps.weight);
    solution.refined = std::move(refined.solution);
    solution.certificate = certify(model.programme, solution.refined);
    if (!solution.certificate.holds()) solution.contact.report.status = Status::Breakdown;
  }
  solution.ledger = std::move(ledger);
  return solution;
}

void require_solved(const Solution& solution, const std::string& what) {
  const Report& report = solution.contact.report;
  if (report.status != Status::Solved)
    throw NotSolved(text(what, " was not solved: ", to_string(report.status), " after ",
                         report.iterations, " iterations; certificate: ", solution.certificate));
}

Solution solve(const Scene& scene) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  return solve(model, condensed, scene.solver, std::move(ledger));
}

}  // namespace signorini

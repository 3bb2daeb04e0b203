#include <set>
#include <utility>

#include "signorini/complementarity/refine.hpp"
#include "signorini/complementarity/rigid_modes.hpp"
#include "signorini/complementarity/solvers.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/frictional.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Adds what one more pass of the solver did to what earlier ones did.
void add_up(Report& now, const Report& earlier) {
  now.iterations += earlier.iterations;
  now.factorisations += earlier.factorisations;
  now.history.insert(now.history.begin(), earlier.history.begin(), earlier.history.end());
}

/// Solves the condensed problem, with rigid modes or without.
FloatingState solve_condensed(const FloatingProblem& problem, const Solver& solver) {
  if (problem.rigid.cols() > 0) return solve(problem, solver);
  FloatingState state;
  state.contact = solver.solve(problem.contact, {});
  return state;
}

/// Moves bodies rigidly. Closed pairs that are too few to hold them say nothing about where they are.
void place(PrimalDual& solution, const Eigen::VectorXd& rigid) {
  const Index n = rigid.size();
  if (solution.displacement_low.size() == 0) solution.displacement_low.setZero(n);
  if (solution.rigid.size() == 0) solution.rigid.setZero(n);
  const Eigen::VectorXd last = solution.rigid;
  solution.rigid += rigid;
  add_displacement(solution, solution.rigid - last);
}

/// The first state of the condensed problem and its refinement; repeated while refinement refutes it.
Refinement solve_and_refine(const Model& model, const Condensed& condensed, const Solver& solver,
                            Ledger& ledger, FloatingState& state) {
  const auto solve_stiffness = [&](const Eigen::VectorXd& load) {
    return condensed.factor.solve(load);
  };
  const Eigen::MatrixXd modes = mode_shapes(model.modes);
  FloatingProblem problem{condensed.problem, condensed.rigid, condensed.resultant};
  PrimalDual start{condensed.free_displacement, {}, {}};
  Refinement refined;
  Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(modes.cols());
  std::set<std::vector<Index>> refuted;
  while (true) {
    {
      const Ledger::Phase phase(ledger, "contact");
      const Report earlier = state.contact.report;
      state = solve_condensed(problem, solver);
      add_up(state.contact.report, earlier);
    }
    if (state.contact.report.status != Status::Solved) return refined;
    const Ledger::Phase phase(ledger, "refinement");
    start.force = state.contact.force;
    if (amplitude.size() > 0) place(start, modes * (state.amplitude - amplitude));
    refined = refine(model.programme, solve_stiffness, problem.contact.compliance, start,
                     state.contact.active, modes);
    if (amplitude.size() > 0) refined.amplitude += state.amplitude;
    amplitude = refined.amplitude;
    ledger.count("sweeps", refined.sweeps);
    if (refined.confirmed) return refined;
    // Rounding cannot decide between sets that come back; the certificate will say whether it matters.
    if (!refuted.insert(state.contact.active).second) return refined;
    problem.contact.free_gap = refined.gap - problem.contact.compliance * refined.solution.force -
                               problem.rigid * refined.amplitude;
    start = refined.solution;
  }
}

/// K and p of all bodies, one block after another.
LinearSystem assemble_all(const Scene& scene, const std::vector<BodyModel>& bodies, Index count) {
  LinearSystem all;
  all.stiffness.resize(count, count);
  all.load.resize(count);
  Eigen::VectorXi lengths(count);
  std::vector<LinearSystem> systems;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyModel& body = bodies[b];
    systems.push_back(
        assemble(body.mesh, body.element, body.material, body.unknowns, scene.bodies[b].loads));
    all.load.segment(body.first_unknown, body.unknowns.count) = systems.back().load;
    for (Index k = 0; k < body.unknowns.count; ++k)
      lengths(body.first_unknown + k) =
          static_cast<int>(systems.back().stiffness.innerVector(k).nonZeros());
  }
  if (bodies.size() == 1) return std::move(systems.front());
  all.stiffness.reserve(lengths);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (Index k = 0; k < bodies[b].unknowns.count; ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator it(systems[b].stiffness, k); it; ++it)
        all.stiffness.insert(bodies[b].first_unknown + it.row(), bodies[b].first_unknown + k) =
            it.value();
  all.stiffness.makeCompressed();
  return all;
}

std::string describe_unknown(const Model& model, Index unknown) {
  std::size_t b = model.bodies.size() - 1;
  while (model.bodies[b].first_unknown > unknown) --b;
  const BodyModel& body = model.bodies[b];
  return text("body '", body.mesh.name, "', ",
              body.unknowns.describe(body.mesh, unknown - body.first_unknown));
}

}  // namespace

Model build(const Scene& scene, Ledger& ledger) {
  Plan now = [&] {
    const Ledger::Phase phase(ledger, "plan");
    return plan(scene);
  }();
  const Ledger::Phase phase(ledger, "assembly");
  Model model;
  model.unknowns = joined(now.unknowns);
  const std::vector<Index> first = first_unknowns(now.unknowns);
  Index first_node = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    model.bodies.push_back({body.mesh, find_element(body.element), body.material,
                            std::move(now.unknowns[b]), first_node, first[b]});
    first_node += body.mesh.n_nodes();
  }
  LinearSystem system = assemble_all(scene, model.bodies, model.unknowns.count);
  ledger.count("unknowns", model.unknowns.count);
  ledger.count("pairs", now.gaps.A.rows());
  if (now.friction) {
    now.gaps.A = below(now.gaps.A, -now.gaps.T);
    model.programme.initial_gap.resize(2 * now.gaps.initial_gap.size());
    model.programme.initial_gap << now.gaps.initial_gap, now.gaps.initial_slip;
  } else {
    model.programme.initial_gap = now.gaps.initial_gap;
  }
  model.friction = std::move(now.friction);
  model.programme.stiffness.swap(system.stiffness);
  model.programme.load.swap(system.load);
  model.programme.A.swap(now.gaps.A);
  model.pairs = std::move(now.gaps);
  model.modes = std::move(now.modes);
  return model;
}

Condensed condense(const Model& model, Ledger& ledger) {
  const QuadraticProgramme& programme = model.programme;
  const bool floats = !model.modes.empty();
  const Eigen::SparseMatrix<double> held =
      floats ? grounded_stiffness(model) : Eigen::SparseMatrix<double>();
  const Eigen::SparseMatrix<double>& K = floats ? held : programme.stiffness;
  const auto describe = [&model](Index unknown) { return describe_unknown(model, unknown); };
  ContactLastFactor factor = [&] {
    const Ledger::Phase phase(ledger, "factor");
    const std::vector<Index> last = contact_unknowns(programme.A);
    const EliminationOrder order = [&] {
      const Ledger::Phase ordering(ledger, "ordering");
      return nested_dissection(K, unknown_positions(model), last);
    }();
    return ContactLastFactor(K, order, static_cast<Index>(last.size()), ledger, describe);
  }();
  const Ledger::Phase phase(ledger, "condensation");
  Condensed condensed{std::move(factor), {}, {}, {}, {}};
  condensed.free_displacement = condensed.factor.solve(programme.load);
  condensed.problem.compliance = condensed.factor.compliance(programme.A);
  condensed.problem.free_gap =
      gaps(programme, {condensed.free_displacement, {}, Eigen::VectorXd::Zero(programme.A.rows())});
  condensed.rigid.resize(programme.A.rows(), 0);
  if (floats) {
    FloatingProblem floating =
        floating_problem(programme, condensed.problem, mode_shapes(model.modes));
    condensed.rigid = std::move(floating.rigid);
    condensed.resultant = std::move(floating.resultant);
  }
  return condensed;
}

Solution solve(const Model& model, const Condensed& condensed, const std::string& solver,
               Ledger ledger) {
  Solution solution;
  if (model.friction) {
    solution = solve_frictional(model, condensed, solver, ledger);
    solution.ledger = std::move(ledger);
    return solution;
  }
  FloatingState state;
  Refinement refined = solve_and_refine(model, condensed, find_solver(solver), ledger, state);
  solution.contact = std::move(state.contact);
  if (solution.contact.report.status == Status::Solved) {
    const Ledger::Phase phase(ledger, "recovery");
    solution.displacements = displacements_of_bodies(model, refined.solution.displacement);
    solution.contact.force = refined.solution.force;
    solution.contact.gap = refined.gap;
    solution.amplitude = refined.amplitude;
    solution.pressure = solution.contact.force.cwiseQuotient(model.pairs.weight);
    solution.refined = std::move(refined.solution);
    solution.certificate = certify(model.programme, solution.refined);
    if (!solution.certificate.holds()) solution.contact.report.status = Status::Breakdown;
  } else {
    solution.escape = escape_in_words(model, state.escape);
  }
  solution.ledger = std::move(ledger);
  return solution;
}

const std::string& solver_name(const Scene& scene, const Model& model) {
  return model.friction ? scene.friction_solver : scene.solver;
}

void require_solved(const Solution& solution, const std::string& what) {
  const Report& report = solution.contact.report;
  if (!solution.escape.empty())
    throw NotSolved(text(what,
                         " was not solved: the load pulls a body away from all it could rest "
                         "on: ",
                         solution.escape, ". Turn the load round or add a support"));
  if (report.status != Status::Solved)
    throw NotSolved(text(what, " was not solved: ", to_string(report.status), " after ",
                         report.iterations, " iterations; certificate: ", solution.certificate));
}

Solution solve(const Scene& scene) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  return solve(model, condensed, solver_name(scene, model), std::move(ledger));
}

}  // namespace signorini

#include "addons/certified/many_bodies.hpp"

#include <cmath>
#include <utility>

#include "addons/many_bodies/sparse_contact.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// The statuses to begin with, if there are any.
std::vector<ContactStatus> start_of(const SolverOptions& options, Index pairs) {
  return static_cast<Index>(options.start.size()) == pairs ? options.start
                                                           : std::vector<ContactStatus>();
}

/// What a run says of itself.
Report report_of(const SparseContactSolution& found) {
  Report report;
  report.status = SolveStatus::Solved;
  report.iterations = found.sets + found.steps + found.sweeps;
  report.factorisations = found.sets + found.steps;
  return report;
}

/// a of u = K_g^-1 (p - A^T f) + N a, by the normal equations: they have few entries, for a body has three motions at most.
VectorXd amplitudes(const VectorXd& strained, const SparseMatrix& N,
                    const SparseContactSolution& found) {
  SparseLuFactor factor;
  if (!factor.factorise(SparseMatrix(N.transpose() * N))) return VectorXd::Zero(N.cols());
  return factor.solve(N.transpose() * (found.position - strained));
}

/// What the entries lead to, which a certificate has not seen.
std::optional<SparseContactSolution> claim_of(const QuadraticProgramme& programme,
                                              const ManyBodies& bodies) {
  if (!(bodies.scale.array() > 0).all()) return std::nullopt;
  const Index rows = programme.A.rows();
  return solve_sparse_contact({programme.stiffness, programme.load, programme.A,
                               SparseMatrix(rows, rows), programme.initial_gap, bodies.law,
                               bodies.scale},
                              bodies.start);
}

/// The unknowns and forces of a claim, as a certificate wants them.
PrimalDual numbers_of(const SparseContactSolution& found) {
  return {found.position, found.position_low, found.force};
}

}  // namespace

bool many_bodies(Index motions, const Solver& solver, const SolverOptions& options) {
  return motions >= many_motions && !solver.others.empty() && options.iteration_limit == 0;
}

bool solved_whole(const Plan& plan) {
  return many_bodies(static_cast<Index>(plan.modes.size()), plan.solver, {}) &&
         plan.path.times.empty() && !plan.equations && !plan.loop && plan.backend.team == nullptr;
}

std::optional<CertifiedSolution> whole_solution(const Model& model, const Condensed& condensed,
                                                Ledger& ledger, Index most_rows) {
  std::optional<CertifiedSolution> end = many_bodies_solution(
      model.programme, {model.law, entry_scales(model.programme)},
      condensed_programme(condensed, ledger).solve_stiffness, mode_entries(model.modes), ledger);
  const Index rows = model.programme.A.rows();
  if (end || rows <= most_rows) return end;
  CertifiedSolution lost;
  lost.state.report.status = SolveStatus::Breakdown;
  lost.state.reason =
      text("no set of closed pairs was found that holds all bodies, and ", rows,
           " rows of gaps and slips are too many for the methods that could say why: solve a part "
           "of the bodies alone, or hold some of them by a support or a soft spring");
  return lost;
}

bool few_entries(const ContactProblem& problem) {
  const MatrixXd& F = problem.compliance;
  return !problem.law.pair.empty() && problem.resultant.size() == 0 &&
         64 * (F.array() != 0).count() <= F.size();
}

VectorXd entry_scales(const QuadraticProgramme& programme) {
  const VectorXd diagonal = programme.stiffness.diagonal();
  VectorXd scale = VectorXd::Zero(programme.A.rows());
  for (Index row = 0; row < scale.size(); ++row) {
    double square = 0;  // of what a unit of force moves the row by, if each unknown were alone
    for (decltype(programme.A)::InnerIterator it(programme.A, row); it; ++it)
      if (it.value() != 0) square += it.value() * it.value() / diagonal(it.col());
    if (square > 0) scale(row) = 1 / std::sqrt(square);
  }
  return scale;
}

std::optional<CertifiedSolution> many_bodies_solution(
    const QuadraticProgramme& programme, const ManyBodies& bodies,
    const std::function<VectorXd(const VectorXd&)>& solve_stiffness,
    const SparseMatrix& null_vectors, Ledger& ledger) {
  std::optional<SparseContactSolution> found;
  {
    const Ledger::Phase phase(ledger, "contact");
    found = claim_of(programme, bodies);
    if (!found) return std::nullopt;
    ledger.count("iterations", found->sets);
    ledger.count("factorisations", found->sets);
  }
  const Ledger::Phase phase(ledger, "refinement");
  CertifiedSolution end;
  end.solution = numbers_of(*found);
  end.certificate = certify(programme, end.solution, bodies.law);
  if (!end.certificate.holds()) return std::nullopt;
  end.state.report = report_of(*found);
  end.state.amplitude =
      amplitudes(solve_stiffness(programme.load - programme.A.transpose() * found->force),
                 null_vectors, *found);
  ledger.count("sets", 1);
  ledger.count("solves", 1);
  fill_state(bodies.law, found->statuses, found->force, found->movement, end.state);
  drop_tension(programme, bodies.law, end);
  return end;
}

std::optional<CertifiedSolution> many_bodies_solution(const QuadraticProgramme& programme,
                                                      const CondensedProgramme& condensed,
                                                      const MatrixXd& null_vectors,
                                                      const SolverOptions& options,
                                                      Ledger& ledger) {
  const ContactProblem& problem = condensed.problem;
  return many_bodies_solution(
      programme,
      {problem.law, row_scales(problem.compliance, problem.rigid, free_movement(problem)),
       start_of(options, problem.free_gap.size())},
      condensed.solve_stiffness, null_vectors.sparseView(), ledger);
}

std::optional<ContactState> many_bodies_state(const QuadraticProgramme& programme,
                                              const ManyBodies& bodies) {
  const std::optional<SparseContactSolution> found = claim_of(programme, bodies);
  if (!found || !certify(programme, numbers_of(*found), bodies.law).holds()) return std::nullopt;
  ContactState state;
  state.report = report_of(*found);
  fill_state(bodies.law, found->statuses, found->force, found->movement, state);
  state.force = state.force.cwiseMax(0.0);
  return state;
}

std::optional<ContactState> many_bodies_state(const ContactProblem& problem,
                                              const SolverOptions& options) {
  const Index motions = problem.resultant.size();
  const VectorXd free = free_movement(problem);
  const MatrixXd moves = motions > 0 ? MatrixXd(-problem.rigid) : MatrixXd(free.size(), 0);
  std::optional<SparseContactSolution> found = solve_sparse_contact(
      {SparseMatrix(motions, motions), -problem.resultant, moves.sparseView(),
       problem.compliance.sparseView(0, 0), free, problem.law,
       row_scales(problem.compliance, problem.rigid, free)},
      start_of(options, problem.free_gap.size()));
  if (!found) return std::nullopt;
  ContactState state;
  state.report = report_of(*found);
  state.amplitude = found->position;
  fill_state(problem.law, found->statuses, found->force, found->movement, state);
  state.force = state.force.cwiseMax(0.0);
  state.gap = state.gap.cwiseMax(0.0);
  if (!certify(problem, state).holds(0.25 * certificate_tolerance)) return std::nullopt;
  return state;
}

}  // namespace signorini

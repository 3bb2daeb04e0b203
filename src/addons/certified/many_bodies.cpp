#include "addons/certified/many_bodies.hpp"

#include <utility>

#include "addons/certified/sparse_contact.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
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
VectorXd amplitudes(const QuadraticProgramme& programme, const CondensedProgramme& condensed,
                    const MatrixXd& null_vectors, const SparseContactSolution& found) {
  const SparseMatrix N = null_vectors.sparseView();
  const VectorXd strained =
      condensed.solve_stiffness(programme.load - programme.A.transpose() * found.force);
  SparseLuFactor factor;
  if (!factor.factorise(SparseMatrix(N.transpose() * N))) return VectorXd::Zero(N.cols());
  return factor.solve(N.transpose() * (found.position - strained));
}

}  // namespace

bool many_bodies(Index motions, const Solver& solver, const SolverOptions& options) {
  return motions >= many_motions && !solver.others.empty() && options.iteration_limit == 0;
}

bool few_entries(const ContactProblem& problem) {
  const MatrixXd& F = problem.compliance;
  return !problem.law.pair.empty() && problem.resultant.size() == 0 &&
         64 * (F.array() != 0).count() <= F.size();
}

std::optional<CertifiedSolution> many_bodies_solution(const QuadraticProgramme& programme,
                                                      const CondensedProgramme& condensed,
                                                      const MatrixXd& null_vectors,
                                                      const SolverOptions& options,
                                                      Ledger& ledger) {
  const ContactProblem& problem = condensed.problem;
  const Index rows = programme.A.rows();
  std::optional<SparseContactSolution> found;
  {
    const Ledger::Phase phase(ledger, "contact");
    found = solve_sparse_contact(
        {programme.stiffness, programme.load, programme.A, SparseMatrix(rows, rows),
         programme.initial_gap, problem.law,
         row_scales(problem.compliance, problem.rigid, free_movement(problem))},
        start_of(options, problem.free_gap.size()));
    if (!found) return std::nullopt;
    ledger.count("iterations", found->sets);
    ledger.count("factorisations", found->sets);
  }
  const Ledger::Phase phase(ledger, "refinement");
  CertifiedSolution end;
  end.solution = {found->position, found->position_low, found->force};
  end.certificate = certify(programme, end.solution, problem.law);
  if (!end.certificate.holds()) return std::nullopt;
  end.state.report = report_of(*found);
  end.state.amplitude = amplitudes(programme, condensed, null_vectors, *found);
  ledger.count("sets", 1);
  ledger.count("solves", 1);
  fill_state(problem.law, found->statuses, found->force, found->movement, end.state);
  drop_tension(programme, problem.law, end);
  return end;
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

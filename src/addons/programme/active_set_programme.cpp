#include "addons/programme/active_set_programme.hpp"

#include <algorithm>
#include <utility>

#include "addons/programme/programme_rows.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

ConstraintRows rows_of(ProgrammeRows& programme) {
  ConstraintRows rows;
  rows.count = programme.count();
  rows.equations = programme.equations();
  rows.rank = std::min(programme.unknowns(), rows.count);
  rows.weight = &programme.weights();
  rows.gaps = [&programme](const ActiveSetFactor& basis, VectorXd& gap, VectorXd& rounding) {
    programme.gaps(basis, gap, rounding);
  };
  rows.fetch = [&programme](const ActiveSetFactor& /*basis*/, const VectorXd& gap,
                            const VectorXd& rounding, ActiveSetFactor::Candidates& candidates) {
    programme.fetch(gap, rounding, candidates);
  };
  return rows;
}

/// What the method says of a row that cannot be closed, of the rows as they were posed.
VectorXd proof_of(const DualActiveSet& method, const ProgrammeRows& data) {
  VectorXd proof = VectorXd::Zero(data.count());
  for (Index i = 0; i < proof.size(); ++i)
    if (method.proof()(i) != 0) proof(i) = method.proof()(i) / data.norms()(i);
  return proof;
}

/// Goes on until no row overlaps, or until a proof holds that one cannot be closed.
SolveStatus run(DualActiveSet& method, const DenseProgramme& programme, const ProgrammeRows& data) {
  for (Index passed = 0;; ++passed) {
    const SolveStatus status = method.run();
    if (status != SolveStatus::Infeasible || passed == data.count() ||
        proves_infeasible(programme, proof_of(method, data), data.displacement()))
      return status;
    method.pass_over();
  }
}

/// The inequalities that a start closes.
std::vector<Index> closed_rows(const std::vector<ContactStatus>& start, Index equations) {
  std::vector<Index> rows;
  for (std::size_t i = 0; i < start.size(); ++i)
    if (start[i] != ContactStatus::Open) rows.push_back(equations + static_cast<Index>(i));
  return rows;
}

DenseSolution grow_active_set(const DenseProgramme& programme, Index limit,
                              DualActiveSet::Step kind,
                              const std::vector<ContactStatus>& start = {}) {
  ProgrammeRows data(programme);
  const ConstraintRows rows = rows_of(data);
  DenseSolution solution;
  const bool warm = !start.empty();
  DualActiveSet method(
      rows, warm ? data.basis_of(closed_rows(start, rows.equations)) : data.empty_basis(),
      solution.report, limit, kind);
  SolveStatus status = SolveStatus::Solved;
  if (warm)
    method.release({});
  else if (rows.equations > 0)
    status = method.close_equations();
  if (status != SolveStatus::Solved) {  // contradictory equations: where the others are closed
    solution.refined.displacement = data.displacement();
    solution.refined.force.setZero(rows.count);
    solution.gap = programme.initial_gap - programme.A * solution.refined.displacement;
  }
  for (Index round = 0; status == SolveStatus::Solved; ++round) {
    status = run(method, programme, data);
    ProgrammeRows::Refined refined = data.refine(method.basis());
    solution.refined = std::move(refined.solution);
    solution.gap = std::move(refined.gap);
    if (status != SolveStatus::Solved) break;
    if (refined.confirmed()) break;
    if (round == rows.count + 10) status = SolveStatus::Breakdown;
    method.release(refined.tension);
  }
  solution.active = sorted_rows(method.basis(), rows.equations);
  solution.report.status = status;
  if (status == SolveStatus::Infeasible) {
    solution.farkas_certificate = proof_of(method, data);
  } else if (status == SolveStatus::Solved) {  // what is negative is of rounding size
    for (Index i = rows.equations; i < rows.count; ++i)
      solution.refined.force(i) = std::max(0.0, solution.refined.force(i));
  }
  return solution;
}

}  // namespace

DenseSolution quasi_active_set(const DenseProgramme& programme, const SolverOptions& options) {
  const Index own = 10 * programme.initial_gap.size() + 100;
  return grow_active_set(programme, options.iteration_limit > 0 ? options.iteration_limit : own,
                         DualActiveSet::Step::Block);
}

DenseSolution goldfarb_idnani(const DenseProgramme& programme, const SolverOptions& options) {
  const Index own = 100 * programme.initial_gap.size() + 100;
  return grow_active_set(programme, options.iteration_limit > 0 ? options.iteration_limit : own,
                         DualActiveSet::Step::Single, options.start);
}

ProgrammeMethod on_programmes(const Solver& solver) {
  using Method = decltype(Solver::solve);
  if (solver.solve == Method{quasi_active_set}) return quasi_active_set;
  if (solver.solve == Method{goldfarb_idnani}) return goldfarb_idnani;
  return nullptr;
}

}  // namespace signorini

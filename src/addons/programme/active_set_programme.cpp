#include "addons/programme/active_set_programme.hpp"

#include <algorithm>
#include <utility>

#include "addons/programme/programme_rows.hpp"
#include "signorini/solvers/dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

DenseSolution grow_active_set(const DenseProgramme& programme, Index limit,
                              DualActiveSet::Step kind) {
  ProgrammeRows data(programme);
  const ConstraintRows rows = rows_of(data);
  DenseSolution solution;
  DualActiveSet method(rows, data.empty_basis(), solution.report, limit, kind);
  SolveStatus status = rows.equations > 0 ? method.close_equations() : SolveStatus::Solved;
  if (status != SolveStatus::Solved) {  // contradictory equations: where the others are closed
    solution.refined.displacement = data.displacement();
    solution.refined.force.setZero(rows.count);
    solution.gap = programme.initial_gap - programme.A * solution.refined.displacement;
  }
  for (Index round = 0; status == SolveStatus::Solved; ++round) {
    status = method.run();
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
    solution.farkas_certificate.setZero(rows.count);
    for (Index i = 0; i < rows.count; ++i)
      if (method.proof()(i) != 0)
        solution.farkas_certificate(i) = method.proof()(i) / data.norms()(i);
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
                         DualActiveSet::Step::Single);
}

ProgrammeMethod on_programmes(const Solver& solver) {
  using Method = decltype(Solver::solve);
  if (solver.solve == Method{quasi_active_set}) return quasi_active_set;
  if (solver.solve == Method{goldfarb_idnani}) return goldfarb_idnani;
  return nullptr;
}

}  // namespace signorini

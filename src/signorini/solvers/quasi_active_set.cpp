#include "signorini/solvers/quasi_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/certified/proofs.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/solvers/dual_active_set.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<Index> sorted_rows(const ActiveSetFactor& basis, Index equations) {
  std::vector<Index> active;
  active.reserve(basis.rows().size());
  for (const Index row : basis.rows())
    if (row >= equations) active.push_back(row);
  std::sort(active.begin(), active.end());
  return active;
}

ContactState grow_active_set(const ContactProblem& problem, Index limit, DualActiveSet::Step kind) {
  const ScaledProblem scaled = equilibrate(problem);
  const VectorXd ones = VectorXd::Ones(scaled.free.size());
  const ConstraintRows rows = rows_of(scaled, ones);
  Report report;
  DualActiveSet method(rows, ActiveSetFactor(0, rows.count), report, limit, kind);
  ActiveSetSolution closed;
  VectorXd proof;
  const auto close_rows = [&] {
    closed = solve_active_set(scaled, ActiveSet{sorted_rows(method.basis())});
    if (kind == DualActiveSet::Step::Single && method.basis().size() > 0) ++report.factorisations;
    return closed.solvable && static_cast<Index>(closed.rows.size()) == method.basis().size();
  };
  for (Index round = 0;; ++round) {
    report.status = method.run();
    if (report.status == SolveStatus::Infeasible) {
      proof = farkas_certificate(scaled, method.basis().rows(), method.pressed());
      if (proof.size() == 0 && verify_farkas(as_posed(scaled), method.proof()))
        proof = scaled.scale.cwiseProduct(method.proof());
      if (proof.size() > 0) break;
      method.pass_over();
      continue;
    }
    if (!close_rows() && report.status == SolveStatus::Solved)
      report.status = SolveStatus::Breakdown;
    if (report.status != SolveStatus::Solved) break;
    const VectorXd force = closed.force(method.basis().rows());
    const VectorXd tension = (-force.array() - closed.force_rounding).max(0.0);
    const double trusted = std::pow(epsilon, -0.2);  // as in ActiveSetFactor::smallest_distance()
    const bool overlap =
        (closed.movement.array() < -trusted * closed.movement_rounding.array()).any();
    if (!overlap && (tension.size() == 0 || tension.maxCoeff() == 0)) break;
    if (round >= rows.count) break;  // sets come back: the certificate will say whether it matters
    method.basis().set_force(force);
    method.release(tension);
  }
  if (report.status == SolveStatus::Infeasible)
    static_cast<void>(close_rows());  // where the method stood
  return finished(problem, scaled, closed, statuses_of(sorted_rows(method.basis()), rows.count),
                  std::move(report), std::move(proof));
}

ContactState quasi_active_set(const ContactProblem& problem, const SolverOptions& options) {
  check_plain(problem, "quasi_active_set");
  const Index limit =
      options.iteration_limit > 0 ? options.iteration_limit : 10 * problem.free_gap.size() + 100;
  return grow_active_set(problem, limit, DualActiveSet::Step::Block);
}

ContactState goldfarb_idnani(const ContactProblem& problem, const SolverOptions& options) {
  check_plain(problem, "goldfarb_idnani");
  const Index limit =
      options.iteration_limit > 0 ? options.iteration_limit : 100 * problem.free_gap.size() + 100;
  return grow_active_set(problem, limit, DualActiveSet::Step::Single);
}

}  // namespace signorini

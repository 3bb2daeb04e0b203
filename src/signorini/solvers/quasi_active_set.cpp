#include "signorini/solvers/quasi_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/farkas.hpp"
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

namespace {

/// The proof that a row cannot be closed, from the set or from what the method says of it; or nothing.
VectorXd proof_of(const ScaledProblem& scaled, const DualActiveSet& method) {
  VectorXd proof = farkas_certificate(scaled, method.basis().rows(), method.pressed());
  if (proof.size() == 0 && verify_farkas(as_posed(scaled), method.proof()))
    proof = scaled.scale.cwiseProduct(method.proof());
  return proof;
}

/// Whether an open pair overlaps by more than the method can see.
bool overlaps(const ActiveSetSolution& closed) {
  const double trusted = std::pow(epsilon, -0.2);  // as in ActiveSetFactor::smallest_distance()
  return (closed.movement.array() < -trusted * closed.movement_rounding.array()).any();
}

}  // namespace

ContactState grow_active_set(const ContactProblem& problem, Index limit, DualActiveSet::Step kind) {
  const ScaledProblem scaled = equilibrate(problem);
  const VectorXd ones = VectorXd::Ones(scaled.free.size());
  const ConstraintRows rows = rows_of(scaled, ones);
  Report report;
  DualActiveSet method(rows, ActiveSetFactor(0, rows.count), report, limit, kind);
  ActiveSetSolution closed;
  VectorXd proof;
  for (Index round = 0;; ++round) {
    report.status = method.run();
    if (report.status == SolveStatus::Infeasible) {
      proof = proof_of(scaled, method);
      if (proof.size() == 0) {
        method.pass_over();
        continue;
      }
    }
    closed = solve_active_set(scaled, ActiveSet{sorted_rows(method.basis())});
    if (kind == DualActiveSet::Step::Single && method.basis().size() > 0) ++report.factorisations;
    const bool all = static_cast<Index>(closed.rows.size()) == method.basis().size();
    if (report.status == SolveStatus::Solved && !(closed.solvable && all))
      report.status = SolveStatus::Breakdown;
    if (report.status != SolveStatus::Solved) break;
    const VectorXd force = closed.force(method.basis().rows());
    const VectorXd tension = (-force.array() - closed.force_rounding).max(0.0);
    if (!overlaps(closed) && (tension.size() == 0 || tension.maxCoeff() == 0)) break;
    if (round >= rows.count) break;  // sets come back: the certificate will say whether it matters
    method.basis().set_force(force);
    method.release(tension);
  }
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

Solver quasi_active_set() {
  return Solver{"quasi_active_set",
                "whole groups of violated pairs join while the dual energy rises: finite and exact",
                quasi_active_set}
      .may_fail_on({Trait::Asymmetric});
}

}  // namespace signorini

// # Quasi-active sets that end at the solution
//
// Xuan and Li (2002) let pairs that overlap, with independent rows, propose what to close next: the
// *quasi-active set*. Whole groups then close in one step, where pivoting closes pairs one by one.
// Chapter 4 shows what is printed and what goes wrong. A step works with violated pairs only, so the
// loop may never end. And it moves the minimum of the energy and forgets the forces before it, so the
// loop may end with too much energy.
//
// Two changes make the idea finite and exact. Forces are kept from step to step and may vanish
// again. And a group counts only if the dual energy rises,
// \f[ -d^T\lambda - \tfrac12\lambda^TG\lambda. \f]
// That is a dual active set method, [dual_active_set.cpp](dual_active_set.cpp), which closes
// blocks. With one pair at a time the same loop is the method of Goldfarb and Idnani (1983).
//
// Chapter 4 has a zigzag that never ends: the rows (0, 1) and (1, -1), g = 0, from (1, 2). In the
// numbers of this file it is G = [1 -1; -1 2] with d = (-2, 1). The first block closes pair 1 with
// the force 2, and pair 2 then overlaps by 1. The second block closes pair 2 with the force 1, and
// the force of pair 1 grows to 3. No pair overlaps any more: two blocks.

#include "signorini/solvers/quasi_active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/farkas.hpp"
#include "signorini/solvers/dual_active_set.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// The factor has the pairs in the order in which they joined. A state lists them by number.
std::vector<Index> sorted_rows(const ActiveSetFactor& basis, Index equations) {
  std::vector<Index> active;
  active.reserve(basis.rows().size());
  for (const Index row : basis.rows())
    if (row >= equations) active.push_back(row);
  std::sort(active.begin(), active.end());
  return active;
}

namespace {

// The proof that a row cannot be closed, from the set or from what the method says of it; or
// nothing. The numbers of the set are refined and come first. They fail if rows of the set nearly
// repeat each other.
VectorXd proof_of(const ScaledProblem& scaled, const DualActiveSet& method) {
  VectorXd proof = farkas_certificate(scaled, method.basis().rows(), method.pressed());
  if (proof.size() == 0 && verify_farkas(as_posed(scaled), method.proof()))
    proof = scaled.scale.cwiseProduct(method.proof());
  return proof;
}

// Whether an open pair overlaps by more than the method can see. The factor is made from products
// of rows and trusts four fifths of their digits. So an overlap below \f$ \epsilon^{-1/5} \f$ times
// its rounding, which is about 1350 times, is no reason to go on.
bool overlaps(const ActiveSetSolution& closed) {
  const double trusted = std::pow(epsilon, -0.2);  // as in ActiveSetFactor::smallest_distance()
  return (closed.movement.array() < -trusted * closed.movement_rounding.array()).any();
}

// Runs the method, then solves the system of its last set from the data. The updated factor has
// collected rounding, so the exact solution may have pairs that pull or overlap. Pairs that pull
// are released, and the method goes on. Sets that come back between the two are cut off after as
// many rounds as there are pairs; the certificate then decides.
//
// A proof that does not hold is no proof. Its pair is passed over, and the method goes on as well.
//
// A block may close many pairs, so few blocks are needed. A single step changes one pair, and ten
// times as many are allowed.
ContactState grow_active_set(const ContactProblem& problem, const SolverOptions& options,
                             DualActiveSet::Step kind, const char* name) {
  check_plain(problem, name);
  const ScaledProblem scaled = equilibrate(problem);
  const Index own = (kind == DualActiveSet::Step::Block ? 10 : 100) * scaled.pairs() + 100;
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : own;
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

}  // namespace

ContactState quasi_active_set(const ContactProblem& problem, const SolverOptions& options) {
  return grow_active_set(problem, options, DualActiveSet::Step::Block, "quasi_active_set");
}

ContactState goldfarb_idnani(const ContactProblem& problem, const SolverOptions& options) {
  return grow_active_set(problem, options, DualActiveSet::Step::Single, "goldfarb_idnani");
}

}  // namespace signorini

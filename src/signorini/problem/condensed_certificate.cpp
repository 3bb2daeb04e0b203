// # The certificate without displacements
//
// A condensed problem knows forces and movements, and no displacements. A claim is right if its
// movements are those that its forces make,
// \f[ w = w^0 + Ff + Ra, \qquad R^Tf = r, \f]
// and if gaps and forces are complementary. The spring of [certificate.cpp](certificate.cpp) has
// \f$ d = -2 \f$ and \f$ G = 1 \f$, and the force 2 closes its gap. Claimed are the force
// \f$ 2 + 10^{-10} \f$ and the gap 0. The forces make the gap 1e-10, so the claimed one is wrong by
// 5e-11 of the length 2. The product of force and gap is 5e-11 of the length 2 times the force 2.
//
// The second part of this file checks a claim of another kind: that there is no solution.

#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// \f$ A^Ty \f$ in twice the working precision: what cancels must cancel exactly.
VectorXd combined(const MatrixXd& A, const VectorXd& y) {
  ExactVector sums(VectorXd::Zero(A.cols()));
  sums.add_products(A, y);
  return sums.value();
}

// Each part by its own whole. Nothing over nothing is 0.
double largest_ratio(const VectorXd& parts, const VectorXd& wholes) {
  double most = 0;
  for (Index i = 0; i < parts.size(); ++i)
    most = std::max(most, ratio(std::abs(parts(i)), wholes(i)));
  return most;
}

// What the unit of force can do along each mode at most, \f$ \max_i |R_{ij}|/s_i \f$. Of a rotation
// that is its longest lever.
VectorXd levers(const MatrixXd& rigid, const VectorXd& unit, Index modes) {
  VectorXd lever(modes);
  for (Index j = 0; j < modes; ++j) lever(j) = largest(rigid.col(j).cwiseQuotient(unit));
  return lever;
}

// The length \f$ \ell \f$ that movements are measured by: the largest overlap, the largest given
// slip, or what all forces or all rigid motions do to a row. The gap of a pair that is far away
// does not count, because errors could hide behind it. Sums count and not their terms, because
// terms may be huge and cancel.
//
// If bodies are rigid, nothing may overlap and nothing may move, and these numbers are all
// rounding. Only the terms \f$ F_{ij}f_j \f$ are left to measure by. They are taken, but not beyond
// what forces of the size of the load make.
double length_of(const ProblemBlocks& problem, const Claim& claim, const VectorXd& moved,
                 const VectorXd& unit, const VectorXd& lever) {
  // A positive gap asks for nothing, a slip asks for friction in both directions.
  VectorXd given = problem.free.cwiseAbs();
  const Index pairs = given.size() - static_cast<Index>(problem.law.pair.size());
  given.head(pairs) = (-problem.free.head(pairs)).cwiseMax(0.0);
  const VectorXd rigid = combined(problem.rigid.transpose(), claim.amplitude);
  double length = std::max(largest(given.cwiseQuotient(unit)), largest(moved.cwiseQuotient(unit)));
  if (rigid.size() > 0) length = std::max(length, largest(rigid.cwiseQuotient(unit)));
  double term = 0;
  for (Index j = 0; j < claim.force.size(); ++j)
    if (const double force = claim.force(j); force != 0)
      term = std::max(term, largest((problem.compliance.col(j) * force).cwiseQuotient(unit)));
  if (length > static_cast<double>(claim.force.size()) * epsilon * term) return length;
  double load = 0;
  for (Index j = 0; j < lever.size(); ++j)
    load = std::max(load, ratio(std::abs(problem.resultant(j)), lever(j)));
  return std::max(length, std::min(term, load));
}

// All that the certificate looks at. The movements are computed again from the forces. Two things
// are judged as equilibrium: the balance of each rigid mode, and the difference of claimed and
// computed movements.
//
// The balance is measured by the load or by what the largest force could add to it. The forces that
// are there would not do: a pair on the axis of a rotation has no lever, and the others may all but
// vanish.
ClaimResiduals residuals_of(const ProblemBlocks& problem, const Claim& claim) {
  ClaimResiduals left{claim.force, {}, {}};
  left.unit = row_scales(problem.compliance, problem.rigid, problem.free).cwiseInverse();
  const Index modes = problem.resultant.size();
  ExactVector sum(VectorXd::Zero(problem.free.size()));
  for (Index j = 0; j < claim.force.size(); ++j)
    if (claim.force(j) != 0) sum.add_product(problem.compliance.col(j), claim.force(j));
  const VectorXd moved = sum.value();
  for (Index j = 0; j < modes; ++j) sum.add_product(problem.rigid.col(j), claim.amplitude(j));
  sum.add_product(problem.free, 1);
  left.movement = sum.value();
  const VectorXd lever = levers(problem.rigid, left.unit, modes);
  left.force_size = largest(claim.force.cwiseProduct(left.unit));
  left.length = length_of(problem, claim, moved, left.unit, lever);
  ExactVector unbalanced(-problem.resultant);
  if (modes > 0) unbalanced.add_products(problem.rigid, claim.force);
  left.imbalance = unbalanced.value();
  const VectorXd balanced = problem.resultant.cwiseAbs().cwiseMax(left.force_size * lever);
  const VectorXd size = left.movement.cwiseQuotient(left.unit).cwiseAbs().cwiseMax(left.length);
  left.equilibrium =
      std::max(largest_ratio(left.imbalance, balanced),
               largest_ratio((left.movement - claim.movement).cwiseQuotient(left.unit), size));
  if (!problem.law.pair.empty()) return left;
  left.free = problem.free;
  left.load = problem.resultant;
  left.position = claim.amplitude;
  return left;
}

}  // namespace

// A comparison with NaN is false, and infinity over infinity is NaN. So such numbers are refused
// before anything is computed.
Certificate certify(const ProblemBlocks& problem, const Claim& claim) {
  if (!problem.compliance.allFinite() || !problem.free.allFinite() || !problem.rigid.allFinite() ||
      !problem.resultant.allFinite() || !claim.force.allFinite() || !claim.movement.allFinite() ||
      !claim.amplitude.allFinite())
    return uncertified();
  return certify(residuals_of(problem, claim), problem.law);
}

// A state comes from any solver, or from a user. So its sizes are checked.
Certificate certify(const ContactProblem& problem, const ContactState& state) {
  const Index pairs = problem.free_gap.size();
  const Index slips = problem.free_slip.size();
  const Index modes = problem.resultant.size();
  check_sizes(problem);
  require_argument(
      state.force.size() == pairs && state.gap.size() == pairs && state.friction.size() == slips &&
          state.slip.size() == slips && state.amplitude.size() == modes,
      "certify: need ", pairs, " forces and gaps, ", slips, " friction forces and slips and ",
      modes, " amplitudes, got ", state.force.size(), ", ", state.gap.size(), ", ",
      state.friction.size(), ", ", state.slip.size(), " and ", state.amplitude.size());
  return certify(
      ProblemBlocks{problem.compliance, free_movement(problem), problem.law, problem.rigid,
                    problem.resultant},
      Claim{all_forces(state), all_movements(state), state.amplitude});
}

// The proof is y >= 0 with \f$ F^Ty = 0 \f$ (or at most 0, if F is not symmetric), \f$ R^Ty = 0 \f$
// and \f$ d^Ty < 0 \f$. Between the two walls of [farkas.cpp](farkas.cpp) it is y = (1, 1).
//
// Computed numbers never give 0, and the question is how much may remain. Let one wall yield by
// \f$ \delta \f$ per unit of force. Then \f$ Fy = (0, \delta) \f$, and the force \f$ 1/\delta \f$
// on both walls makes room. For \f$ \delta = 10^{-9} \f$ that is a solution with the force 1e9, and
// y proves nothing. So two things are asked of what remains: it is rounding of the terms, and
// forces that live on it exceed \f$ 1/\sqrt{\varepsilon} \f$, which is 6.7e7, times the one that
// closes the deepest overlap.
bool verify_farkas(const ContactProblem& problem, const VectorXd& y) {
  const VectorXd& d = problem.free_gap;
  if (y.size() != d.size() || y.size() == 0 || !y.allFinite() || (y.array() < 0).any())
    return false;
  ExactSum overlap;
  for (Index i = 0; i < y.size(); ++i) overlap.add_product(-d(i), y(i));
  // Rounding of d alone must not make the sum negative.
  const double lost = static_cast<double>(y.size()) * proof_rounding * d.cwiseAbs().dot(y);
  if (!(overlap.value() > lost)) return false;
  const VectorXd scale = row_scales(problem.compliance, problem.rigid, free_movement(problem));
  const VectorXd scaled = y.cwiseQuotient(scale.head(y.size()));
  if (problem.rigid.cols() > 0) {
    const VectorXd terms = problem.rigid.topRows(y.size()).cwiseAbs().transpose() * y;
    const VectorXd moved = combined(problem.rigid, y).cwiseAbs();
    if ((moved.array() > proof_rounding * terms.array()).any()) return false;
  }
  const double deepest = -d.cwiseProduct(scale.head(y.size())).minCoeff();
  VectorXd moved = combined(problem.compliance, y).cwiseProduct(scale);
  // Friction pushes either way, contact only one; but what is symmetric is semidefinite, to
  // rounding.
  const Index signless = is_symmetric(problem) ? moved.size() : moved.size() - y.size();
  moved.tail(signless) = moved.tail(signless).cwiseAbs();
  const double most = std::max(0.0, moved.maxCoeff());
  return most <= proof_rounding * scaled.sum() &&
         most * deepest < overlap.value() * std::sqrt(epsilon);
}

}  // namespace signorini

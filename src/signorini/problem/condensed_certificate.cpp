// What a solution of a condensed problem leaves, and what that is measured by; and the check of a proof that there is none.
#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/exact_sum.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A^T y.
VectorXd combined(const MatrixXd& A, const VectorXd& y) {
  ExactVector sums(VectorXd::Zero(A.cols()));
  sums.add_products(A, y);
  return sums.value();
}

double largest_ratio(const VectorXd& parts, const VectorXd& wholes) {
  double most = 0;
  for (Index i = 0; i < parts.size(); ++i)
    most = std::max(most, ratio(std::abs(parts(i)), wholes(i)));
  return most;
}

/// \f$ \max_i |R_{ij}| / s_i \f$ of each mode: what it can do per unit of force, at most.
VectorXd levers(const MatrixXd& rigid, const VectorXd& unit, Index modes) {
  VectorXd lever(modes);
  for (Index j = 0; j < modes; ++j) lever(j) = largest(rigid.col(j).cwiseQuotient(unit));
  return lever;
}

/// The length l: the largest overlap, given slip, and what all forces or all rigid motions do to a row. Neither the gaps
/// of pairs that are far apart count nor terms that cancel. With rigid modes, whose load fixes the size of
/// forces, all may cancel and nothing move but by rounding: then the terms F_ij f_j are all there is to measure by, but no
/// more than forces of the size \f$ |r_j| / lever_j \f$ make; one on a row of F alone moves it by as much, scaled.
double length_of(const ProblemBlocks& problem, const Claim& claim, const VectorXd& moved,
                 const VectorXd& unit, const VectorXd& lever) {
  VectorXd given = problem.free.cwiseAbs();
  const Index pairs = given.size() - static_cast<Index>(problem.law.pair.size());
  given.head(pairs) = (-problem.free.head(pairs)).cwiseMax(0.0);
  const VectorXd rigid = combined(problem.rigid.transpose(), claim.amplitude);
  double length = std::max(largest(given.cwiseQuotient(unit)), largest(moved.cwiseQuotient(unit)));
  if (rigid.size() > 0) length = std::max(length, largest(rigid.cwiseQuotient(unit)));
  double term = 0;
  for (Index j = 0; j < claim.force.size(); ++j)
    term =
        std::max(term, largest((problem.compliance.col(j) * claim.force(j)).cwiseQuotient(unit)));
  if (length > static_cast<double>(claim.force.size()) * epsilon * term) return length;
  double load = 0;
  for (Index j = 0; j < lever.size(); ++j)
    load = std::max(load, ratio(std::abs(problem.resultant(j)), lever(j)));
  return std::max(length, std::min(term, load));
}

/// What is claimed, with movements summed anew. The equilibrium is the largest \f$ |R^T f - r|_j \f$ over r_j or what the
/// largest force could add to it, since a pair on the axis of a rotation has no part in it, and forces elsewhere may all but
/// vanish; or the largest difference of a claimed movement from w_i, over the length or w_i.
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

VectorXd stacked(const VectorXd& top, const VectorXd& bottom) {
  VectorXd both(top.size() + bottom.size());
  both << top, bottom;
  return both;
}

}  // namespace

Certificate certify(const ProblemBlocks& problem, const Claim& claim) {
  if (!problem.compliance.allFinite() || !problem.free.allFinite() || !problem.rigid.allFinite() ||
      !problem.resultant.allFinite() || !claim.force.allFinite() || !claim.movement.allFinite() ||
      !claim.amplitude.allFinite())
    return uncertified();
  return certify(residuals_of(problem, claim), problem.law);
}

Certificate certify(const ContactProblem& problem, const ContactState& state) {
  const Index pairs = problem.free_gap.size();
  const Index slips = problem.free_slip.size();
  const Index rows = pairs + slips;
  const Index modes = problem.resultant.size();
  check_law(problem.law, pairs, slips);
  require_argument(problem.compliance.rows() == rows && problem.compliance.cols() == rows,
                   "certify: compliance must be ", rows, " x ", rows, ", got ",
                   problem.compliance.rows(), " x ", problem.compliance.cols());
  require_argument(problem.rigid.cols() == modes && (modes == 0 || problem.rigid.rows() == rows),
                   "certify: rigid must be ", rows, " x ", modes, ", got ", problem.rigid.rows(),
                   " x ", problem.rigid.cols());
  require_argument(
      state.force.size() == pairs && state.gap.size() == pairs && state.friction.size() == slips &&
          state.slip.size() == slips && state.amplitude.size() == modes,
      "certify: need ", pairs, " forces and gaps, ", slips, " friction forces and slips and ",
      modes, " amplitudes, got ", state.force.size(), ", ", state.gap.size(), ", ",
      state.friction.size(), ", ", state.slip.size(), " and ", state.amplitude.size());
  return certify(
      ProblemBlocks{problem.compliance, free_movement(problem), problem.law, problem.rigid,
                    problem.resultant},
      Claim{stacked(state.force, state.friction), stacked(state.gap, state.slip), state.amplitude});
}

bool verify_farkas(const ContactProblem& problem, const VectorXd& y) {
  const VectorXd& d = problem.free_gap;
  if (y.size() != d.size() || y.size() == 0 || !y.allFinite() || (y.array() < 0).any())
    return false;
  ExactSum overlap;
  for (Index i = 0; i < y.size(); ++i) overlap.add_product(-d(i), y(i));
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
  // Friction pushes either way, contact only one; but what is symmetric is semidefinite, to rounding.
  const Index signless = is_symmetric(problem) ? moved.size() : moved.size() - y.size();
  moved.tail(signless) = moved.tail(signless).cwiseAbs();
  const double most = std::max(0.0, moved.maxCoeff());
  return most <= proof_rounding * scaled.sum() &&
         most * deepest < overlap.value() * std::sqrt(epsilon);
}

}  // namespace signorini

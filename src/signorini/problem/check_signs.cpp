// # What refined numbers say
//
// Refined forces and movements belong to a set that somebody guessed. Whether the set was right is read off their
// signs: closed pairs press, open pairs do not overlap, friction keeps its bound and resists sliding.
//
// A number near 0 has no sign. Forces are measured by the largest force and movements by the largest
// displacement and initial gap: what is smaller than their rounding decides nothing. For 10 closed pairs, a
// largest force of 1000 N and \f$ \epsilon = 2.2\cdot10^{-16} \f$ a tension up to \f$ 11\,\epsilon\cdot 1000 =
// 2.4\cdot10^{-12} \f$ N is none.
//
// The file also has what the refinement and its users share: how a rigid motion is added to u, and what
// is left out of balance along rigid modes.

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/iterative_refinement.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// What movements are measured by: gaps are differences of positions, so their rounding has the size of
// initial gaps and displacements, however small the gap is.
double length_of(const RefinementData& data, const PrimalDual& solution) {
  return largest(data.programme.initial_gap) + largest(solution.displacement);
}

}  // namespace

// A part that shrinks, because motions cancel, keeps the rounding of what it was. That rounding is no motion and
// would strain the bodies, so the motion nearest to it is taken.
//
// A body that forces out of balance took far away on its springs came back: K, whose entries are rounded, would
// strain it by the way, once as rigid and once as not. What is left is rigid as far as a motion comes near to it.
void add_rigid(PrimalDual& solution, const MatrixXd& null_vectors, const VectorXd& amplitude,
               bool home) {
  const Index n = null_vectors.rows();
  if (solution.displacement_low.size() == 0) solution.displacement_low.setZero(n);
  if (solution.rigid.size() == 0) solution.rigid.setZero(n);
  const VectorXd last = solution.rigid;
  solution.rigid += null_vectors * amplitude;
  const VectorXd added = solution.rigid - last;
  if (2 * largest(solution.rigid) < largest(last))
    solution.rigid = null_vectors * least_norm_solution(null_vectors, solution.rigid);
  add_displacement(solution, added);
  if (home && largest(solution.rigid) > 2 * largest(solution.displacement))
    solution.rigid = null_vectors * least_norm_solution(null_vectors, solution.displacement);
}

// K u does no work along rigid modes, but its entries are rounded. So what is left counts only beyond the
// rounding of its terms, of which a row of K has as many as it has entries.
VectorXd resultant_left(const QuadraticProgramme& programme, const PrimalDual& solution,
                        const MatrixXd& null_vectors, double rounding) {
  if (null_vectors.cols() == 0) return {};
  const double row = static_cast<double>(programme.stiffness.nonZeros()) /
                     static_cast<double>(programme.stiffness.rows());
  const VectorXd left = null_vectors.transpose() * equilibrium_residual(programme, solution);
  const VectorXd size = null_vectors.cwiseAbs().transpose() *
                        VectorXd(programme.load.cwiseAbs() +
                                 programme.stiffness.cwiseAbs() * strained(solution).cwiseAbs() +
                                 programme.A.cwiseAbs().transpose() * solution.force.cwiseAbs());
  return (left.array().abs() > (rounding + row * epsilon) * size.array()).select(left, 0.0);
}

// Forces are divided by the scale of their row and movements are multiplied by it, as equilibrate() does.
// predict() compares forces and movements in the units of the equilibrated problem.
ActiveSetSolution scaled_numbers(const RefinementData& data, const PrimalDual& solution,
                                 const VectorXd& movement, double part) {
  const VectorXd& scale = data.scaled.scale;
  ActiveSetSolution numbers;
  numbers.force = solution.force.cwiseQuotient(scale);
  numbers.movement = movement.cwiseProduct(scale);
  numbers.force_rounding = part * largest(numbers.force);
  numbers.movement_rounding = part * length_of(data, solution) * scale;
  return numbers;
}

// Closed rows that depend on each other may contradict each other. They must then be closed to what a
// certificate lets pass, or the set has no solution.
SignCheck check_signs(const RefinementData& data, const RefinedSolution& refined,
                      const std::vector<ContactStatus>& statuses) {
  const double rounding = epsilon * static_cast<double>(closed_pairs(statuses).size() + 1);
  // Closed rows that depend on each other may contradict each other, by more than a certificate lets pass.
  const double contradicted =
      std::max(rounding, certificate_tolerance) * length_of(data, refined.solution);
  ActiveSetSolution numbers = scaled_numbers(data, refined.solution, refined.movement, rounding);
  bool closes = true;
  for (const Index row : active_set(statuses, data.condensed.law).closed) {
    if (std::abs(refined.movement(row)) > contradicted) closes = false;
    numbers.movement(row) = 0;
  }
  SignCheck result{statuses, 0, false};
  result.wrong = predict(data.scaled, numbers, 1, result.statuses);
  const PrimalDual& solution = refined.solution;
  const bool finite = solution.displacement.allFinite() && solution.force.allFinite();
  result.confirmed =
      refined.settled && result.wrong == 0 && finite && closes &&
      largest(resultant_left(data.programme, solution, data.null_vectors, rounding)) == 0;
  return result;
}

}  // namespace signorini

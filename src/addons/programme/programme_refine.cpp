#include <algorithm>
#include <cmath>
#include <limits>

#include "addons/programme/programme_rows.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"
#include "signorini/problem/corrections.hpp"
#include "signorini/problem/exact_vector.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

/// What one refinement works with.
struct ProgrammeRows::Work {
  Eigen::MatrixXd closed;  // A_W `k x n`
  VectorXd norm;           // `k` |h_i|
  VectorXd initial;        // `k` g_W
  VectorXd force;          // `k` of normalised rows
  VectorXd raw;            // `k` lambda_W
  VectorXd z;
  VectorXd a;
  VectorXd along;
};

/// What forces are measured by, those that springs have had among them.
double ProgrammeRows::force_size(const VectorXd& force) const {
  return std::max(largest(force), spring_ * largest(displacement_));
}

/// One sweep: [K A^T; A 0] [du; dlambda] = residuals, with K = L_K L_K^T and L_K^-1 A^T = Q L^T.
void ProgrammeRows::correct(const ActiveSetFactor& basis, Refined& refined, Work& work) {
  PrimalDual& solution = refined.solution;
  const Index n = unknowns();
  const auto L = basis.factor().triangularView<Eigen::Lower>();
  ExactVector unbalanced(programme_.load);
  ExactVector open(work.initial);
  for (Index j = 0; j < n; ++j) {
    unbalanced.add_product(programme_.stiffness.col(j), -solution.displacement(j));
    open.add_product(work.closed.col(j), -solution.displacement(j));
  }
  unbalanced.add_products(work.closed, -work.raw);
  if (refined.sweeps > 0) {
    unbalanced.add_small(-(programme_.stiffness * solution.displacement_low));
    open.add_small(-(work.closed * solution.displacement_low));
  }
  work.z = unbalanced.value();
  solve_lower(factor_.lower(), work.z);
  const VectorXd gap = open.value();
  work.a = gap.cwiseQuotient(work.norm);
  L.solveInPlace(work.a);
  work.along.noalias() = basis.directions().transpose() * work.z;
  work.along -= work.a;
  work.z.noalias() -= basis.directions() * work.along;
  solve_lower_transposed(factor_.lower(), work.z);
  L.transpose().solveInPlace(work.along);
  // What rho A_e^T A_e in the factor carried of the rest of a gap is a force of its equation.
  for (Index i = 0; i < basis.size(); ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    if (row < equations()) work.along(i) += rho_(row) * gap(i) * work.norm(i);
  }
  add_displacement(solution, work.z);
  work.force += work.along;
  work.raw += work.along.cwiseQuotient(work.norm);
  ++refined.sweeps;
}

VectorXd ProgrammeRows::carried(const ActiveSetFactor& basis, VectorXd load) const {
  solve_lower(factor_.lower(), load);
  VectorXd force = basis.directions().transpose() * load;
  solve_lower_transposed(basis.factor(), force);
  VectorXd all = VectorXd::Zero(count());
  for (Index i = 0; i < basis.size(); ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    all(row) = force(i) / norm_(row);
  }
  return all;
}

ProgrammeRows::Refined ProgrammeRows::refine(ActiveSetFactor& basis) {
  const Index k = basis.size();
  Refined refined;
  Work work;
  basis.solve(work.force);
  refined.solution.displacement = displacement();
  if (certain(basis, refined, work.force)) return refined;
  work.force.conservativeResize(k);
  work.raw.resize(k);
  work.closed.resize(k, unknowns());
  work.initial.resize(k);
  work.norm.resize(k);
  for (Index i = 0; i < k; ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    work.closed.row(i) = programme_.A.row(row);
    work.initial(i) = programme_.initial_gap(row);
    work.norm(i) = norm_(row);
    work.raw(i) = work.force(i) / work.norm(i);
  }
  refined.solution.displacement_low.setZero(unknowns());
  for (Corrections corrections; corrections.foreseen > 0.25 * epsilon;) {
    correct(basis, refined, work);
    const bool shrinks =
        corrections.next(std::max(relative(work.z, refined.solution.displacement),
                                  ratio(largest(work.along), force_size(work.force))));
    refined.settled = corrections.foreseen <= 0.25 * epsilon;
    refined.change = work.z;
    if (!shrinks) break;
  }
  displacement_ = refined.solution.displacement;
  basis.set_force(work.force);
  check_signs(basis, refined, work);
  return refined;
}

/// Rounding of one term of the gap of a row, when the unknowns have moved so far.
double ProgrammeRows::one_rounding(Index row, double stretch) const {
  const double moved = weight_(row) > 0 ? stretch / weight_(row) : 0;
  return 4 * epsilon * (std::abs(programme_.initial_gap(row)) + moved);
}

/// Whether the closed rows press and are closed, beyond rounding. Takes over their forces.
bool ProgrammeRows::presses(const ActiveSetFactor& basis, Refined& refined,
                            const VectorXd& force) const {
  const Index k = basis.size();
  const double pull = static_cast<double>(k + 1) * epsilon * largest(force.head(k));
  const VectorXd size = refined.solution.displacement.cwiseAbs();
  refined.solution.force.setZero(count());
  for (Index i = 0; i < k; ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    // A closed row is measured by its own terms: what others move by must not hide its gap.
    const double own =
        std::abs(programme_.initial_gap(row)) + programme_.A.row(row).cwiseAbs().dot(size);
    if (std::abs(refined.gap(row)) > static_cast<double>(unknowns()) * epsilon * own) return false;
    if (row >= equations() && force(i) <= pull) return false;
    refined.solution.force(row) = force(i) / norm_(row);
  }
  return true;
}

/// Whether forces balance but for rounding. \param size  |D^1/2 u|
bool ProgrammeRows::balances(const ActiveSetFactor& basis, const PrimalDual& solution,
                             double size) {
  const VectorXd& displacement = solution.displacement;
  const double rounding = static_cast<double>(unknowns()) * epsilon;
  moved_ = programme_.load;
  moved_.noalias() -= programme_.stiffness * displacement;
  for (const Index row : basis.rows())
    moved_ -= solution.force(row) * programme_.A.row(row).transpose();
  // |K_ij| <= root_i root_j bounds what the residual may have lost in its own rounding.
  const double load = largest(programme_.load);
  const double lost = largest(root_) * root_.dot(displacement.cwiseAbs()) * epsilon;
  if (largest(moved_) > rounding * load || (load > 0 && lost > 0.25 * certificate_tolerance * load))
    return false;
  for (Index j = 0; j < unknowns(); ++j) {  // as a certificate does, by what the unknown itself has
    double own = std::abs(programme_.load(j)) + (equations() > 0 ? 0 : root_(j) * size);
    if (std::abs(moved_(j)) <= rounding * own) continue;
    own += programme_.A.col(j).cwiseAbs().dot(solution.force.cwiseAbs());
    if (std::abs(moved_(j)) > rounding * own) return false;
  }
  return true;
}

/// Whether the solution satisfies all conditions so well, and all rows are so far from the wrong side,
/// that twice the working precision could not change anything but the last digits.
bool ProgrammeRows::certain(const ActiveSetFactor& basis, Refined& refined,
                                 const VectorXd& force) {
  const VectorXd& displacement = refined.solution.displacement;
  const double size = displacement.cwiseProduct(root_).norm();
  refined.gap = programme_.initial_gap;
  refined.gap.noalias() -= programme_.A * displacement;
  if (!presses(basis, refined, force) || !balances(basis, refined.solution, size)) return false;
  for (const Index row : basis.rows()) refined.gap(row) = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < count(); ++i)
    if (refined.gap(i) <
        static_cast<double>(unknowns()) * one_rounding(i, std::max(stretch_, size)))
      return false;
  for (const Index row : basis.rows()) refined.gap(row) = 0;
  return true;
}

/// All gaps of the refined solution, and which rows are on the wrong side beyond rounding.
void ProgrammeRows::check_signs(const ActiveSetFactor& basis, Refined& refined, const Work& work) {
  const Index k = basis.size();
  base_.noalias() = basis.directions() * basis.coordinates();
  gap_ = programme_.initial_gap;
  gap_.noalias() -= programme_.A * displacement_;
  // What the row moves is at most |D^-1/2 a_i| |D^1/2 u|; how far u went before contact pushed back is in no digit
  // of a refined u. Where nothing moves, a certificate measures by how forces would move the stiffest unknown.
  const double stiffest = largest(VectorXd(programme_.stiffness.diagonal()));
  const double most =
      std::max(largest(programme_.load), largest(work.closed.transpose() * work.raw));
  stretch_ = std::max(displacement_.cwiseProduct(root_).norm(), ratio(most, std::sqrt(stiffest)));
  for (Index i = 0; i < count(); ++i) floor_(i) = one_rounding(i, stretch_);
  refined.tension.setZero(k);
  refined.solution.force.setZero(count());
  const double pull = static_cast<double>(k + 1) * epsilon * force_size(work.force);
  for (Index i = 0; i < k; ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    gap_(row) = 0;
    floor_(row) = 0;
    refined.solution.force(row) = work.raw(i);
    if (row >= equations() && work.force(i) < -pull) refined.tension(i) = -work.force(i);
  }
  const double terms = static_cast<double>(unknowns());
  for (Index i = equations(); i < count(); ++i) {
    if (std::abs(gap_(i)) < terms * floor_(i)) {
      ExactSum sum(programme_.initial_gap(i));
      double size = std::abs(programme_.initial_gap(i)) +  // of its own terms, or of the same
                    ratio(most, stiffest) * programme_.A.row(i).norm();
      for (Index j = 0; j < unknowns(); ++j) {
        sum.add_product(-programme_.A(i, j), displacement_(j));
        sum.add(-programme_.A(i, j) * refined.solution.displacement_low(j));
        size += std::abs(programme_.A(i, j) * displacement_(j));
      }
      gap_(i) = sum.value();
      floor_(i) = 4 * epsilon * size;
    }
    if (gap_(i) < -floor_(i)) ++refined.violated;
  }
  refined.gap = gap_;
}

}  // namespace signorini

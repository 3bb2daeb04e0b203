/// \file
/// Equilibration: one unit for all forces and movements, so that nothing depends on the units of a problem.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// A contact problem with row i scaled by \f$ s_i = 1 / \sqrt{F_{ii}} \f$ and its rigid modes made orthonormal:
/// unit diagonal, one unit for forces, friction forces, gaps, slips and amplitudes.
///
/// A change of units, of the stiffness of a body or of the scale of one row leaves it as it is. The friction
/// coefficients change with it, \f$ \mu s_i / s_j \f$, because the gap i and the slip j of a pair have
/// different scales.
struct ScaledProblem {
  Eigen::MatrixXd compliance;  ///< `n_c + n_s` square, s_i F_ij s_j [-]
  Eigen::VectorXd free;        ///< s_i d_i, gaps first, then slips [sqrt(energy)]
  Eigen::VectorXd scale;       ///< s; force = s * scaled force, gap = scaled gap / s
  bool symmetric = true;       ///< whether F may be factored as such: symmetric, no diagonal < 0
  FrictionLaw law = {};        ///< coefficients [-] and cohesion [sqrt(energy)] of scaled forces
  /// U `n_c + n_s` x `k`, orthonormal with the span of s R; no columns if held
  Eigen::MatrixXd rigid = {};
  Eigen::VectorXd resultant = {};  ///< t `k` that U^T f must be [sqrt(energy)]
  Eigen::MatrixXd inverse = {};    ///< `n_r x k`: amplitude = inverse * scaled amplitude
  /// Minus the part of r along a motion that moves no pair, as amplitudes `n_r`, or empty
  Eigen::VectorXd unconstrained_resultant = {};
  /// F once more where pairs have friction and at most one entry in 64 is not 0, as in piles of rigid bodies; else empty
  Eigen::SparseMatrix<double> sparse = {};
  /// The system of a set, from F and U as they are here: active_set_system() takes it for that set. Null: none is factored yet
  std::shared_ptr<const ActiveSetSystem> factored = {};
  /// Whether F and the coefficients alone leave one solution at most, see uniqueness(); nothing: nobody has asked
  std::optional<bool> excludes_others = {};

  /// \return n_c
  [[nodiscard]] Eigen::Index pairs() const {
    return free.size() - static_cast<Eigen::Index>(law.pair.size());
  }
};

/// Equilibrates a problem by its row_scales().
/// \param problem  any
/// \return the scaled problem; dependent modes make k < n_r
/// \throws std::invalid_argument as check_problem()
[[nodiscard]] ScaledProblem equilibrate(const ContactProblem& problem);

/// Equilibrates w = M z + q with any matrix by its row_scales(): a symmetric problem as equilibrate().
/// \param problem  M and q
/// \return the scaled problem
/// \throws std::invalid_argument as check_finite()
[[nodiscard]] ScaledProblem equilibrate_any(const ContactProblem& problem);

/// \param problem  scaled
/// \return the same numbers as a problem of their own
[[nodiscard]] ContactProblem as_posed(const ScaledProblem& problem);

/// What a unit of force counts against gaps and slips: the largest row sum of |F|, what such forces on all
/// pairs open a gap by.
/// \param compliance  F of a scaled problem
/// \return the sum, 1 if that is 0 [-]
[[nodiscard]] double force_scale(const Eigen::MatrixXd& compliance);

/// What forces in balance move, \f$ PFP \f$ with \f$ P = I - UU^T \f$: the springs that ground a body in F are not in it.
/// \param problem  scaled
/// \return the matrix; F without rigid modes, 0 where nothing but rounding is left
[[nodiscard]] Eigen::MatrixXd balanced_compliance(const ScaledProblem& problem);

/// force_scale() of a matrix, or of F where that matrix is 0.
/// \param problem     scaled
/// \param compliance  as F, or balanced_compliance()
/// \return the sum
[[nodiscard]] double force_scale(const ScaledProblem& problem, const Eigen::MatrixXd& compliance);

}  // namespace signorini

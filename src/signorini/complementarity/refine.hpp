/// \file
/// The last step of every exact method: the KKT system of the final set, from the original data.
#pragma once
#include <functional>

#include "signorini/complementarity/certificate.hpp"
#include "signorini/complementarity/floating.hpp"

namespace signorini {

/// u += change, keeping in `displacement_low` what does not fit into the leading double.
/// \param solution  whose displacement grows; both parts `n`
/// \param change    `n` [length]
void add_displacement(PrimalDual& solution, const Eigen::VectorXd& change);

/// What refine() did.
struct Refinement {
  PrimalDual solution;        ///< u in two parts, and lambda
  Eigen::VectorXd gap;        ///< g - A u `n_c` [length]
  Eigen::VectorXd amplitude;  ///< how much of each rigid mode went into u `n_r`
  Eigen::Index sweeps = 0;    ///< solves with K
  bool confirmed = false;     ///< no force of the set is tensile and no other pair overlaps
};

/// Refines \f$ K u + A^T \lambda = p,\ A_W u = g_W \f$ for a set W of closed pairs.
///
/// Each sweep corrects u by K^-1 times the residual of equilibrium, then lambda by the gaps left in
/// W; both residuals come from K, p, A and g in twice the working precision, so the factor and the
/// compliance may carry relative errors up to about 1/cond. u is kept as a sum of two doubles.
/// Sweeps end when lambda has settled and the next correction of u will be of rounding size, or
/// when neither correction shrinks any more.
///
/// With rigid modes K is singular, and `solve_stiffness` and `compliance` belong to the grounded K_g of
/// floating_problem(). Residuals are still those of K. A sweep adds K_g^-1 times the residual r_u, then
/// forces and amplitudes that close the gaps left and take up what of r_u only a rigid motion feels,
///
/// \f[ \begin{pmatrix} G_{WW} & R_W \\ R_W^T & 0 \end{pmatrix}
///     \begin{pmatrix} \Delta\lambda \\ \Delta a \end{pmatrix} =
///     \begin{pmatrix} A_W u - g_W \\ -N^T r_u \end{pmatrix}, \f]
///
/// and the next residual is in balance, so that no spring takes part in it. K N may differ from 0 by
/// rounding: then the forces are those of the K that was posed, in which a motion N a strains the body,
/// by about epsilon |K| |a|.
/// \param programme        K, p, A, g as they were posed
/// \param solve_stiffness  K^-1 applied to a vector [force] -> [length]; need not be accurate
/// \param compliance       `n_c x n_c` G = A K^-1 A^T [length/force]; need not be accurate
/// \param start            a solution to start from, forces 0 outside of W; its displacement may
///                         still be that without contact
/// \param active           W, in increasing order; its block of G must be regular
/// \param null_vectors     N, or nothing if K is regular
/// \return the refined solution; another set is needed unless it is `confirmed`. It is not if pairs of W
///   repeat each other, or if the load has a part along a mode that W does not hold
/// \throws std::invalid_argument if the sizes of `programme`, `start` and N do not fit
[[nodiscard]] Refinement refine(
    const QuadraticProgramme& programme,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve_stiffness,
    const Eigen::MatrixXd& compliance, PrimalDual start, const std::vector<Eigen::Index>& active,
    const Eigen::MatrixXd& null_vectors = {});

}  // namespace signorini

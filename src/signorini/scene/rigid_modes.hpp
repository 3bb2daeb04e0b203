// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Rigid modes of a sparse programme: from K, p, A and g to the floating problem.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// What rigid modes open the gaps by.
///
/// A mode that opens no gap, like a slide along a plane, must get zeros and not their rounding, or this
/// would be taken for a hold: an entry counts as zero if the rounding of its terms can make it. Factors
/// are taken to be right to some sixty roundings, as normals and modes are that a few steps computed. Where coordinates
/// are rounded, directions are: no digit need be right of what is across a normal, or across the way that a node goes.
/// Then what a row does to all unknowns between the first and the last that the mode moves counts, times the largest
/// that it moves.
/// \param A             `n_c x n`, gap = g - A u
/// \param null_vectors  N `n x n_r`, rigid modes
/// \param directions    one rounding of the directions that A and N were made from [-]; 0 if each entry has its own
/// \return R = -A N `n_c x n_r`, the one test of this library of whether a mode moves a pair
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Eigen::SparseMatrix<double> rigid_gaps(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
    const Eigen::SparseMatrix<double>& null_vectors, double directions = 0);

/// What a load does along rigid modes.
/// \param load          p `n`
/// \param null_vectors  N `n x n_r`
/// \param directions    as of rigid_gaps()
/// \return r = -N^T p `n_r`; an entry counts as zero if the rounding of its terms can make it
[[nodiscard]] Eigen::VectorXd rigid_resultant(const Eigen::VectorXd& load,
                                              const Eigen::MatrixXd& null_vectors,
                                              double directions = 0);

/// Adds the rigid modes to the condensed problem of a programme whose bodies contact alone holds.
///
/// K is singular, so the caller grounds it: K_g = K + C C^T with one spring per mode, N^T C regular.
/// For forces f in balance, N^T f = 0, the springs carry nothing and K (K_g^-1 f) = f; so
/// \f$ u = K_g^{-1}(p - A^T\lambda) + N a \f$ holds wherever the springs are, and with \f$ gap = g - A u \f$
///
/// \f[ d = g - A K_g^{-1} p,\quad G = A K_g^{-1} A^T,\quad R = -A N,\quad r = -N^T p. \f]
///
/// R is that of rigid_gaps(), and r that of rigid_resultant().
///
/// A rotation should turn its body about a point inside: about a far one it is mostly a shift, and what
/// remains of the two when they cancel is rounded as they are.
/// \param programme     p and A; K and g have gone into `problem`
/// \param null_vectors  N `n x n_r`, independent columns with K N = 0; none if it is empty
/// \param[in,out] problem  condensed with K_g in the place of K; gets R and r
/// \param directions    as of rigid_gaps()
/// \throws std::invalid_argument if sizes do not fit
void add_rigid_modes(const QuadraticProgramme& programme, const Eigen::MatrixXd& null_vectors,
                     ContactProblem& problem, double directions = 0);

}  // namespace signorini

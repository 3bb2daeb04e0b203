/// \file
/// Rigid modes of a sparse programme: from K, p, A and g to the floating problem.
#pragma once
#include "signorini/complementarity/floating.hpp"
#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// How the bodies of a programme can move without being strained.
///
/// A rotation should turn its body about a point inside: about a far one it is mostly a shift, and what
/// remains of the two when they cancel is rounded as they are.
struct RigidModes {
  Eigen::MatrixXd shape;  ///< N `n x n_r`, independent columns with K N = 0; none if it is empty
};

/// The floating problem of a programme whose bodies contact alone holds.
///
/// K is singular, so the caller grounds it: K_g = K + C C^T with one spring per mode, N^T C regular.
/// For forces f in balance, N^T f = 0, the springs carry nothing and K (K_g^-1 f) = f; so
/// \f$ u = K_g^{-1}(p - A^T\lambda) + N a \f$ holds wherever the springs are, and with \f$ gap = g - A u \f$
///
/// \f[ d = g - A K_g^{-1} p,\quad G = A K_g^{-1} A^T,\quad R = -A N,\quad r = -N^T p. \f]
///
/// A mode that opens no gap, like a slide along a plane, must get the column 0 and not its rounding, or
/// this would be taken for a hold: an entry of R or r counts as zero if the rounding of its terms can
/// make it.
/// \param programme  p and A; K and g have gone into `grounded`
/// \param grounded   G and d with K_g in the place of K
/// \param modes      N
/// \return G, d, R and r
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] FloatingProblem floating_problem(const QuadraticProgramme& programme,
                                               ContactProblem grounded, const RigidModes& modes);

}  // namespace signorini

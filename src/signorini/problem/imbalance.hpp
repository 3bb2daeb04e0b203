// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What forces out of balance amount to, unknown by unknown.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/certificate.hpp"

namespace signorini {

/// The largest residual over what its own row has: its load, its contact forces, and what the displacements could make
/// there, sqrt(K_jj) max_i sqrt(K_ii) |u_i|, of which no term K_ji u_i is more than one. A stable factor leaves no more than
/// rounding of that, so a larger residual is an error, however large the forces on other unknowns are. Where contact
/// holds everything, rounding of how far loads and contact forces would move their own unknowns takes the place of u.
///
/// Forces of equations have any sign, and are no part of u: EquationRows says how they come in. As equations also join soft unknowns
/// with stiff ones, the displacements u_i are then only those that K joins with u_j, and rounding of the others.
/// \param programme  K, p, A, g
/// \param solution   u and lambda
/// \param residual   of the equilibrium `n` [force]
/// \param diagonal   of K `n` [force/length]
/// \param equations  the first rows, as far as they are some
/// \return the figure [-]
[[nodiscard]] double own_imbalance(const QuadraticProgramme& programme, const PrimalDual& solution,
                                   const Eigen::VectorXd& residual, const Eigen::VectorXd& diagonal,
                                   const EquationRows& equations);

}  // namespace signorini

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What of a K lies along the equations, and what across them: where it is negative across, equations can hold it.
#pragma once
#include <Eigen/Core>
#include <optional>

#include "signorini/core/dense.hpp"
#include "signorini/problem/problem.hpp"
#include "signorini/problem/residual.hpp"

namespace signorini {

/// K and equations in units in which the diagonal of K is 1 or -1 and each equation has the length 1: u = unit * v, and
/// \f$ E = U S V^T \f$.
struct EquationSplit {
  Eigen::VectorXd unit;  ///< `n`
  Eigen::VectorXd
      length;         ///< `m_e` of the equations as they were posed, in these units of the unknowns
  Eigen::MatrixXd K;  ///< `n x n`
  Eigen::MatrixXd along;   ///< Z, orthonormal, E Z = 0
  Eigen::MatrixXd across;  ///< V, orthonormal, `n x rank`
  Eigen::MatrixXd U;       ///< `m_e x rank`
  Eigen::VectorXd values;  ///< S `rank`, > 0
};

/// \param programme  K, A and its equations
/// \param spring     stiffness on each unknown besides K
/// \return the parts; nothing if there are no equations, or they have no entries, or numbers are not finite
[[nodiscard]] std::optional<EquationSplit> split_by_equations(const DenseProgramme& programme,
                                                              double spring);

/// What each equation must add to K where K is positive definite along the equations and has a negative eigenvalue across them.
///
/// With \f$ K_{zz} = Z^T K Z > 0 \f$, \f$ K_{vz} = V^T K Z \f$ and so on, the Schur complement says:
/// \f$ K + \rho E^T E \f$ is positive definite if and only if
/// \f$ \rho > \rho_0 \f$, the largest eigenvalue of \f$ -S^{-1} (K_{vv} - K_{vz} K_{zz}^{-1} K_{zv}) S^{-1} \f$.
/// Of \f$ 2 \rho_0 + 1 \f$ more than half is left for what rounding takes.
/// \param programme  K, A and its equations
/// \param spring     stiffness on each unknown besides K
/// \return `m_e`; nothing if \f$ K_{zz} \f$ is not positive definite: then no stiffness is enough
[[nodiscard]] std::optional<Eigen::VectorXd> sufficient_stiffness(const DenseProgramme& programme,
                                                                  double spring);

/// A programme with the same solutions u, and the same forces but for those of the equations, whose K is positive semidefinite
/// wherever the K of the first is so along the equations.
///
/// All u that satisfy the equations are c along V, whatever they are along Z. So only \f$ K_{zz} \f$ and the load
/// \f$ Z^T (p - K c) \f$ decide; across, any K does, here 1 in these units, and a load that gives c.
/// \param programme  K, p, A, g and its equations
/// \return it; nothing if split_by_equations() has nothing, or \f$ K_{zz} \f$ has a negative eigenvalue beyond rounding
[[nodiscard]] std::optional<DenseProgramme> convex_form(const DenseProgramme& programme);

/// Forces of the equations that balance what all else does to the unknowns, as far as they can.
/// \param programme  K, p, A and its equations
/// \param solution   u and lambda `m`; those of the equations are not read
/// \return `m_e`, of several the least
[[nodiscard]] Eigen::VectorXd equation_forces(const DenseProgramme& programme,
                                              const PrimalDual& solution);

}  // namespace signorini

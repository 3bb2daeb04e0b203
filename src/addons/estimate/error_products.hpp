// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What elements and recovered stresses differ by, weighed by a dual solution.
#pragma once
#include <Eigen/Core>

#include "addons/estimate/recovery.hpp"

namespace signorini {

/// What the stresses that the mesh has no room for do to the product of two fields, cell by cell:
///
/// \f[ E_K = \int_K (\sigma^*_u - \sigma_u)^T D^{-1} (\sigma^*_z - \sigma_z) + \sigma^*_u{}^T m_z + \sigma^*_z{}^T m_u, \f]
///
/// with the recovered stresses \f$ \sigma^* \f$ and the part m of the strain of an element that is not that of its
/// displacements: internal modes, or the mean volume of B-bar. It is what \f$ a(u, z) - a_h(u_h, z_h) \f$ is if the
/// recovered stresses are the true ones and those of u_h and z_h are in equilibrium with their loads. Of a field
/// with itself, without m, it is the square of the estimated error of the energy.
/// \param fields  u, then one or more z
/// \param stress  recovered() of them
/// \param counted  `n_cells`, how much of the first term counts, from 0 to 1; all of it without one
/// \return `n_cells x n_z` [force*length]
[[nodiscard]] Eigen::MatrixXd error_products(const PrimalAndDuals& fields,
                                             const SmoothStress& stress,
                                             const Eigen::VectorXd& counted = {});

}  // namespace signorini

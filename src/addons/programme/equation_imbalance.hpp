// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What forces out of balance amount to where equations may have any force.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// The largest residual over what its own unknown has, behind a change of the forces of equations, see EquationRows: it takes
/// what they leave out of balance from unknowns that have little to others of their equation that have more. An unknown that
/// an equation defines, z = a x without stiffness and load, has nothing but the force of that equation, which is 0 but for
/// rounding: what is left there belongs to x, and is measured by what x has.
/// \param E         coefficients of the equations `n x m`, by columns [-]
/// \param own       what every unknown has itself `n` > 0 [force]
/// \param residual  of the equilibrium `n` [force]
/// \return the figure [-], never more than without any change
[[nodiscard]] double equation_imbalance(Eigen::MatrixXd E, const Eigen::VectorXd& own,
                                        Eigen::VectorXd residual);

}  // namespace signorini

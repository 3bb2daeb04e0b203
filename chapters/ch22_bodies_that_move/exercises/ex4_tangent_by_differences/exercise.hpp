/// \file
/// Exercise 22.4 - a law for finite strain, and its tangent in two ways. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <functional>

namespace ex22_4 {

using Eigen::Matrix2d;

/// Of a neo-Hooke material, with the energy mu/2 (F : F - 2 - 2 ln J) + lambda/2 (ln J)^2 in plane strain.
struct Material {
  double mu;      ///< > 0 [force/length^2]
  double lambda;  ///< >= 0 [force/length^2]
};

/// Force per area before strain: the derivative of the energy with respect to F.
/// \param material  any
/// \param F         gradient of the places after strain, det F > 0 [-]
/// \return P [force/length^2]
[[nodiscard]] Matrix2d stress(const Material& material, const Matrix2d& F);

/// How P changes along a direction, by hand.
/// \param material   any
/// \param F          det F > 0 [-]
/// \param direction  D [-]
/// \return dP/dt of F + t D at t = 0 [force/length^2]
[[nodiscard]] Matrix2d tangent(const Material& material, const Matrix2d& F, const Matrix2d& direction);

/// The same of any function by a central difference.
/// \param of         a smooth function of F
/// \param F          of size 1 [-]
/// \param direction  of any size > 0 [-]
/// \return the derivative, to some 1e-9 of the size of the function times that of the direction
[[nodiscard]] Matrix2d by_differences(const std::function<Matrix2d(const Matrix2d&)>& of,
                                      const Matrix2d& F, const Matrix2d& direction);

}  // namespace ex22_4

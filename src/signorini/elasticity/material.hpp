/// \file
/// Isotropic linear elasticity in the plane.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// What does not happen across the plane.
enum class PlaneState {
  Stress,  ///< thin sheet: no stress across, sigma_zz = 0
  Strain,  ///< long body: no strain across, epsilon_zz = 0
  Axial  ///< body of revolution about x = 0: x is the radius, y the height, the hoop strain is u_x / x
};

/// Isotropic material and the body's extent across the plane.
struct Material {
  double youngs_modulus = 1;              ///< E [force/length^2], positive
  double poisson_ratio = 0;               ///< nu [-], above -1; at most 1/2 (below in plane strain)
  PlaneState state = PlaneState::Strain;  ///< what does not happen across the plane
  double thickness = 1;                   ///< across the plane [length], positive
  double expansion = 0;                   ///< alpha, thermal strain per temperature [1/temperature]
};

/// Checks a material.
/// \param material  any
/// \throws ProblemError naming the constant that is out of range and what to use instead
void check_material(const Material& material);

/// D of sigma = D epsilon, with epsilon = (xx, yy, 2 xy) [-] and sigma = (xx, yy, xy).
///
/// \PaperEq{XuanLi2002, 3}, second line, reduced to the plane.
/// \param material  within its bounds
/// \return `3 x 3`, symmetric positive definite [force/length^2]
/// \throws ProblemError as check_material()
[[nodiscard]] Eigen::Matrix3d elasticity_matrix(const Material& material);

/// Stress across the plane from the stress in it.
/// \param material  whose state and Poisson's ratio count
/// \param stress    (xx, yy, xy) [force/length^2], tension positive
/// \return nu (xx + yy) in plane strain, 0 in plane stress [force/length^2]
[[nodiscard]] double stress_across(const Material& material, const Eigen::Vector3d& stress);

}  // namespace signorini

/// \file
/// Isotropic elasticity in the plane: linear, unless a material has a law of finite strain.
///
/// Two constants are enough for a linear, isotropic body: Young's modulus \f$E\f$, and Poisson's
/// ratio \f$\nu\f$: a bar that is stretched by \f$\varepsilon\f$ becomes thinner by
/// \f$\nu\varepsilon\f$. How a body is thought to go on across the plane decides which matrix
/// \f$D\f$ follows, and nothing else in the library depends on it but the depth of integrals.
#pragma once
#include <Eigen/Core>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// D of sigma = D epsilon: a row per strain component, 3 in the plane and 4 in axial symmetry; never on the heap.
using Elasticity = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, 4>;

/// What does not happen across the plane.
enum class PlaneState {
  Stress,  ///< thin sheet: no stress across, sigma_zz = 0
  Strain,  ///< long body: no strain across, epsilon_zz = 0
  Axial  ///< body of revolution about x = 0: x is the radius, y the height, the hoop strain is u_x / x
};

/// \param state  any
/// \return "plane stress", "plane strain" or "axial symmetry"
[[nodiscard]] const char* to_string(PlaneState state);

struct StrainLaw;

/// Isotropic material and the body's extent across the plane.
struct Material {
  double youngs_modulus = 1;  ///< E [force/length^2], positive
  double poisson_ratio = 0;   ///< nu [-], above -1; at most 1/2 (in plane stress; else below)
  PlaneState state = PlaneState::Strain;  ///< what does not happen across the plane
  double thickness = 1;  ///< across the plane [length], positive; 1 in axial symmetry
  double expansion = 0;  ///< alpha, thermal strain per temperature [1/temperature]
  const StrainLaw* law = nullptr;  ///< see find_strain_law(); null: strains are small
};

/// How far a body reaches across the plane at a place. Whatever is integrated over the plane, or along a line in it,
/// is multiplied by it there, once.
struct Depth {
  double factor = 1;   ///< thickness [length], in axial symmetry 2 pi [-]; positive
  bool axial = false;  ///< whether what is there reaches around the axis x = 0

  /// \param x  coordinate of a place, in axial symmetry its radius [length]
  /// \return what the factor stands before: 1 [-], in axial symmetry the radius [length]
  [[nodiscard]] double part(double x) const { return axial ? x : 1; }
  /// \param x  coordinate of a place, in axial symmetry its radius [length]
  /// \return the depth there: thickness, in axial symmetry length of the circle [length]
  [[nodiscard]] double at(double x) const { return factor * part(x); }
};

/// \param material  of a body
/// \return its thickness, or in axial symmetry the circle
[[nodiscard]] Depth depth_of(const Material& material);

/// Where small displacements end, and linear elasticity with them: notes begin there.
struct SmallLimits {
  double strain = 0.05;   ///< largest principal strain, mean of a cell [-]
  double rotation = 5;    ///< mean of a cell [degrees]
  double pressure = 0.1;  ///< of contact over Young's modulus of the softer body [-]
};

/// Checks a material.
/// \param material  any
/// \throws ProblemError naming the constant that is out of range and what to use instead
void check_material(const Material& material);

/// D of sigma = D epsilon, with epsilon = (xx, yy, 2 xy) [-] and sigma = (xx, yy, xy); in axial symmetry
/// the hoop component is the fourth.
///
/// \PaperEq{XuanLi2002, 3}, second line, reduced to the plane.
/// \param material  within its bounds
/// \return `3 x 3`, in axial symmetry `4 x 4`, symmetric positive definite [force/length^2]
/// \throws ProblemError as check_material()
[[nodiscard]] Elasticity elasticity_matrix(const Material& material);

/// Stress across the plane from the stress in it.
/// \param material  whose state and Poisson's ratio count
/// \param stress    (xx, yy, xy) [force/length^2], tension positive
/// \param free      eigenstrain across the plane [-]
/// \return nu (xx + yy) - E times that in plane strain, 0 in plane stress [force/length^2]
/// \throws std::invalid_argument in axial symmetry, where it is a component of its own
[[nodiscard]] double stress_across(const Material& material, const Eigen::Vector3d& stress,
                                   double free = 0);

}  // namespace signorini

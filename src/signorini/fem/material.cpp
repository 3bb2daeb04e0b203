// # Hooke's law in the plane
//
// In three dimensions \f$\varepsilon_{xx} = (\sigma_{xx} - \nu(\sigma_{yy}+\sigma_{zz}))/E\f$, and
// likewise for the others. One of the two numbers across the plane is taken to be 0:
// \f$\sigma_{zz}\f$ in a thin sheet (plane stress), \f$\varepsilon_{zz}\f$ in a long body (plane
// strain). The other one follows, and
//
// \f[ D = \frac{E}{1-\nu^2}\begin{pmatrix}1&\nu&\\ \nu&1&\\ &&\frac{1-\nu}{2}\end{pmatrix}
//     \quad\text{or}\quad
//     \frac{E}{(1+\nu)(1-2\nu)}\begin{pmatrix}1-\nu&\nu&\\ \nu&1-\nu&\\ &&\frac{1-2\nu}{2}\end{pmatrix}. \f]
//
// For \f$E = 1\f$ and \f$\nu = 0.3\f$ the first entry is 1.099 or 1.346: what is held across the
// plane is stiffer. Both give the modulus of shear \f$G = E/(2(1+\nu)) = 0.385\f$, since shear in
// the plane changes no thickness. A body of revolution has all four strains, and the second matrix
// with one more row.

#include "signorini/fem/material.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

const char* to_string(PlaneState state) {
  return state == PlaneState::Stress   ? "plane stress"
         : state == PlaneState::Strain ? "plane strain"
                                       : "axial symmetry";
}

/// What is wrong here would show much later, as a factor that breaks down or as a body that grows
/// under pressure. So each constant is checked before the first integral, and the message says what
/// to do.
void check_material(const Material& material) {
  const double E = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  require_input(E > 0 && std::isfinite(E), "material: Young's modulus must be positive, got ", E);
  require_input(material.thickness > 0 && std::isfinite(material.thickness),
                "material: thickness must be positive, got ", material.thickness);
  require_input(std::isfinite(material.expansion),
                "material: the thermal expansion must be a number, got ", material.expansion);
  require_input(nu > -1 && nu <= 0.5, "material: Poisson's ratio must lie between -1 and 0.5, got ",
                nu);
  require_input(
      nu < 0.5 || material.state == PlaneState::Stress, "material: Poisson's ratio 0.5 in ",
      to_string(material.state),
      " makes the body incompressible and its stiffness infinite. Use 0.4999 with the element "
      "q4_bbar (q4 would lock: it bears far too much load)");
  require_input(
      material.thickness == 1 || material.state != PlaneState::Axial,
      "material: a body of revolution has no thickness, forces are those of the whole circle; "
      "leave it at 1, got ",
      material.thickness);
}

/// Forces are forces, not forces per length: every integral is multiplied by the depth. On a body
/// of revolution that is the length \f$2\pi x\f$ of the circle.
Depth depth_of(const Material& material) {
  if (material.state == PlaneState::Axial) return {2 * pi, true};
  return {material.thickness, false};
}

Elasticity elasticity_matrix(const Material& material) {
  check_material(material);
  const double E = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  const bool axial = material.state == PlaneState::Axial;
  Elasticity D = Elasticity::Zero(axial ? 4 : 3, axial ? 4 : 3);
  if (material.state == PlaneState::Stress) {
    D.topLeftCorner<2, 2>() << 1, nu, nu, 1;
    D *= E / (1 - nu * nu);
  } else {
    D.topLeftCorner<2, 2>() << 1 - nu, nu, nu, 1 - nu;
    if (axial) D.row(3) << nu, nu, 0, 1 - nu;
    if (axial) D.col(3).head<3>() << nu, nu, 0;
    D *= E / ((1 + nu) * (1 - 2 * nu));
  }
  D(2, 2) = E / (2 * (1 + nu));
  return D;
}

/// What plane strain holds across the plane pushes back:
/// \f$\sigma_{zz} = \nu(\sigma_{xx}+\sigma_{yy})\f$, less \f$E\f$ times the strain that the
/// material would have taken freely. Von Mises stress needs it.
double stress_across(const Material& material, const Eigen::Vector3d& stress, double free) {
  require_argument(
      material.state != PlaneState::Axial,
      "stress_across: in axial symmetry the hoop stress does not follow from the others");
  return material.state == PlaneState::Stress
             ? 0.0
             : material.poisson_ratio * (stress(0) + stress(1)) - material.youngs_modulus * free;
}

}  // namespace signorini

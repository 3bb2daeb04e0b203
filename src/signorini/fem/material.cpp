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

double stress_across(const Material& material, const Eigen::Vector3d& stress, double free) {
  require_argument(
      material.state != PlaneState::Axial,
      "stress_across: in axial symmetry the hoop stress does not follow from the others");
  return material.state == PlaneState::Stress
             ? 0.0
             : material.poisson_ratio * (stress(0) + stress(1)) - material.youngs_modulus * free;
}

}  // namespace signorini

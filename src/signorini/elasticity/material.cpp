#include "signorini/elasticity/material.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {

void check_material(const Material& material) {
  const double E = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  pose(E > 0 && std::isfinite(E), "material: Young's modulus must be positive, got ", E);
  pose(material.thickness > 0 && std::isfinite(material.thickness),
       "material: thickness must be positive, got ", material.thickness);
  pose(nu > -1 && nu <= 0.5, "material: Poisson's ratio must lie between -1 and 0.5, got ", nu);
  pose(nu < 0.5 || material.state == PlaneState::Stress,
       "material: Poisson's ratio 0.5 in plane strain makes the body incompressible and its "
       "stiffness "
       "infinite. Use 0.4999 with the element q4_bbar (q4 would lock: it bears far too much load)");
}

Elasticity elasticity_matrix(const Material& material) {
  check_material(material);
  const double E = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  Elasticity D = Elasticity::Zero(3, 3);
  if (material.state == PlaneState::Stress) {
    D.topLeftCorner<2, 2>() << 1, nu, nu, 1;
    D *= E / (1 - nu * nu);
  } else {
    D.topLeftCorner<2, 2>() << 1 - nu, nu, nu, 1 - nu;
    D *= E / ((1 + nu) * (1 - 2 * nu));
  }
  D(2, 2) = E / (2 * (1 + nu));
  return D;
}

double stress_across(const Material& material, const Eigen::Vector3d& stress) {
  return material.state == PlaneState::Stress ? 0.0
                                              : material.poisson_ratio * (stress(0) + stress(1));
}

}  // namespace signorini

// # St Venant and Kirchhoff
//
// Hooke's law with Green's strain \f$ E = \tfrac12(H + H^T + H^T H) \f$ in the place of the small one. A turn makes no E,
// so that large turns at small strains are right: this is the law for slender bodies. A bar that is pressed to the stretch s
// has the force \f$ \tfrac12 s(s^2 - 1) E_Y \f$. That is largest at \f$ s = 1/\sqrt3 \f$, and beyond it the bar gives way.

#include "addons/motion/finite_strain.hpp"

namespace signorini {
namespace {

void green_strain_stress(const Lame& lame, const Components& H, StressResponse& response) {
  const Components F = deformation(H);
  const Eigen::Vector4d E(H(0) + (H(0) * H(0) + H(2) * H(2)) / 2,
                          H(3) + (H(1) * H(1) + H(3) * H(3)) / 2,
                          H(1) + H(2) + (H(0) * H(1) + H(2) * H(3)), H(4) + H(4) * H(4) / 2);
  const Eigen::Vector4d volume(1, 1, 0, 1);
  Eigen::Matrix4d D = lame.lambda * volume * volume.transpose();
  D.diagonal() += lame.mu * Eigen::Vector4d(2, 2, 1, 2);
  // What E changes by when H does; the third component of E is twice the shear.
  Eigen::Matrix<double, 4, 5> B;
  B << F(0), 0, F(2), 0, 0, 0, F(1), 0, F(3), 0, F(1), F(0), F(3), F(2), 0, 0, 0, 0, 0, F(4);
  const Eigen::Vector4d S = D * E;
  response.energy = E.dot(S) / 2;
  response.piola = B.transpose() * S;
  response.tangent = B.transpose() * D * B;
  for (const int row : {0, 2}) {
    response.tangent(row, row) += S(0);
    response.tangent(row + 1, row + 1) += S(1);
    response.tangent(row, row + 1) += S(2);
    response.tangent(row + 1, row) += S(2);
  }
  response.tangent(4, 4) += S(3);
}

}  // namespace

StrainLaw st_venant_kirchhoff() {
  return hyperelastic<green_strain_stress>("st_venant_kirchhoff", "Hooke's law with Green's strain: large turns, small strains");
}

}  // namespace signorini

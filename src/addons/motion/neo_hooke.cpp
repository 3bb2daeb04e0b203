// # Neo-Hooke, compressible
//
// The simplest law for rubber, \f$ W = \tfrac\mu2 (F : F - 3 - 2\ln J) + \tfrac\lambda2 (\ln J)^2 \f$, with
// \f[ P = \mu(F - F^{-T}) + \lambda \ln J\,F^{-T}. \f]
// Written like this the first bracket loses all digits of a small strain: F and its inverse are both near 1. So it is written
// with H = F - 1. In the plane, with the area change a of area_change(),
// \f[ F_{11} - F^{-T}_{11} = \frac{H_{11} - H_{22} + F_{11}\,a}{1 + a}, \qquad
//     F_{12} - F^{-T}_{12} = \frac{F_{12}(1 + a) + F_{21}}{1 + a}, \f]
// which is right to rounding for strains of 1e-12 as well.

#include <cmath>

#include "addons/motion/finite_strain.hpp"

namespace signorini {
namespace {

void rubber_stress(const Lame& lame, const Components& H, StressResponse& response) {
  const double a = area_change(H);
  const double area = 1 + a;
  const double log_J = std::log1p(a) + std::log1p(H(4));
  const Components F = deformation(H);
  Components inverse;  // F^-T
  inverse << F(3) / area, -F(2) / area, -F(1) / area, F(0) / area, 1 / F(4);
  Components difference;  // F - F^-T
  difference << (H(0) - H(3) + F(0) * a) / area, (F(1) * area + F(2)) / area,
      (F(2) * area + F(1)) / area, (H(3) - H(0) + F(3) * a) / area, H(4) * (1 + F(4)) / F(4);
  response.piola = lame.mu * difference + lame.lambda * log_J * inverse;
  const double p = lame.lambda * log_J - lame.mu;  // times the derivative of F^-T
  response.tangent = (lame.lambda - p) * inverse * inverse.transpose();
  response.tangent.block<4, 1>(0, 4) += p * inverse(4) * inverse.head<4>();
  response.tangent.block<1, 4>(4, 0) += p * inverse(4) * inverse.head<4>().transpose();
  response.tangent.diagonal().array() += lame.mu;
  response.tangent(0, 3) += p / area;
  response.tangent(3, 0) += p / area;
  response.tangent(1, 2) -= p / area;
  response.tangent(2, 1) -= p / area;
  response.energy =
      lame.mu * (H(0) + H(3) + H(4) + H.squaredNorm() / 2 - log_J) + lame.lambda / 2 * log_J * log_J;
}

}  // namespace

StrainLaw neo_hooke() {
  return hyperelastic<rubber_stress>("neo_hooke", "rubber-like, resists any compression");
}

}  // namespace signorini

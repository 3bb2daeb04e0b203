#include <cmath>

#include "exercise.hpp"

namespace ex22_5 {

void stress(const Lame& lame, const Components& H, StressResponse& response) {
  const double a = signorini::area_change(H), area = 1 + a;
  const double growth = a + H(4) + a * H(4);  // J - 1
  const double J = 1 + growth;
  const double log_J = std::log1p(growth);
  const double squared = growth * (2 + growth);  // J^2 - 1
  const Components F = signorini::deformation(H);
  Components inverse;  // F^-T
  inverse << F(3) / area, -F(2) / area, -F(1) / area, F(0) / area, 1 / F(4);
  Components difference;  // F - F^-T, without the 1 that both have
  difference << (H(0) - H(3) + F(0) * a) / area, (F(1) * area + F(2)) / area,
      (F(2) * area + F(1)) / area, (H(3) - H(0) + F(3) * a) / area, H(4) * (1 + F(4)) / F(4);
  response.piola = lame.mu * difference + lame.lambda / 2 * squared * inverse;
  const double p = lame.lambda / 2 * squared - lame.mu;  // what F^-T is multiplied with
  for (int column = 0; column < 5; ++column) {
    const Components D = Components::Unit(column);
    Components turned = -inverse(4) * inverse(4) * D;  // of F^-T: across the plane
    turned.head<4>() << D(3) / area, -D(2) / area, -D(1) / area, D(0) / area;
    turned.head<4>() -= inverse.head<4>().dot(D.head<4>()) * inverse.head<4>();
    response.tangent.col(column) =
        lame.mu * D + lame.lambda * J * J * inverse(column) * inverse + p * turned;
  }
  response.energy = lame.mu * (H(0) + H(3) + H(4) + H.squaredNorm() / 2 - log_J) +
                    lame.lambda / 4 * (squared - 2 * log_J);
}

signorini::StrainLaw quadratic_volume() {
  return signorini::hyperelastic<stress>("quadratic_volume", "exercise 22.5");
}

}  // namespace ex22_5

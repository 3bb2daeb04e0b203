// # Von Mises stress
//
// One number for a state of stress, to compare with the yield stress of a tension test. It leaves
// out the mean of the three direct stresses, and counts shear with the factor 3,
// \f[ \sigma_v^2 = \tfrac12\bigl((\sigma_{xx} - \sigma_{yy})^2 + (\sigma_{yy} - \sigma_{zz})^2
//    + (\sigma_{zz} - \sigma_{xx})^2\bigr) + 3\,\sigma_{xy}^2. \f]
// A shear of 2 alone gives \f$ 2\sqrt3 = 3.46 \f$.

#include "signorini/fem/von_mises.hpp"

#include <cmath>

namespace signorini {

/// What is left when the mean of the three direct stresses is taken out. For tension \f$\sigma\f$
/// in one direction it is \f$\sigma\f$, for the same pressure from all sides it is 0. The square of
/// \f$10^{160}\f$ is no double, and that of \f$10^{-170}\f$ is 0. Where squares may have come to
/// that, the stresses are divided by a power of two first, which rounds nothing.
double von_mises(const Eigen::Vector4d& stress) {
  const auto plain = [](const Eigen::Vector4d& s) {
    const double xy = s(0) - s(1);
    const double yz = s(1) - s(3);
    const double zx = s(3) - s(0);
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * s(2) * s(2));
  };
  const double value = plain(stress);
  if (value > 0x1p-480 && std::isfinite(value)) return value;
  const double largest = stress.cwiseAbs().maxCoeff();
  if (largest == 0 || !std::isfinite(largest)) return value;
  const int power = std::ilogb(largest);
  return std::ldexp(
      plain(stress.unaryExpr([=](double x) { return std::ldexp(x, -power); })), power);
}

}  // namespace signorini

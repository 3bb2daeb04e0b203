/// \file
/// Exercise 14.1 - two rings with a gap between them. Do not change this file.
#pragma once

namespace ex14_1 {

/// A ring a < r < b in a ring c < d of the same material, in plane strain.
struct TwoRings {
  double a, b;            ///< radii of the inner ring [length], 0 < a < b
  double c, d;            ///< radii of the outer ring [length], b <= c < d
  double youngs_modulus;  ///< E [force/length^2]
  double poisson_ratio;   ///< nu [-]
};

/// What a pressure inside the inner ring does.
struct Closure {
  double closing_pressure;  ///< that just closes the gap, whatever the load [force/length^2]
  double contact_pressure;  ///< on the outer rim of the inner ring [force/length^2]; 0 if open
  double rim_displacement;  ///< of the inner rim a, outwards [length]
};

/// Two thick rings without friction under the pressure p inside the inner one.
///
/// A ring a < r < b under pressures p_i inside and p_o outside moves outwards by
/// u(r) = [(1 - nu') A r + (1 + nu') B / r] / E' with A = (p_i a^2 - p_o b^2) / (b^2 - a^2),
/// B = (p_i - p_o) a^2 b^2 / (b^2 - a^2), E' = E / (1 - nu^2), nu' = nu / (1 - nu). Where the rings touch,
/// both rims bear the same force per angle: p_c on b is p_c b / c on c.
/// \param rings     the two rings
/// \param pressure  p inside the inner ring [force/length^2], not negative
/// \throws std::invalid_argument unless the radii grow from a to d, a > 0 and p >= 0
[[nodiscard]] Closure press_lining(const TwoRings& rings, double pressure);

}  // namespace ex14_1

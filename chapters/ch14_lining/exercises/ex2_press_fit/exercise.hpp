/// \file
/// Exercise 14.2 - a hub on a shaft. Do not change this file.
#pragma once

namespace ex14_2 {

/// A hub on a shaft in plane stress; both have the radius b where they meet, up to the interference.
struct Fit {
  double bore;          ///< a, inner radius of the shaft [length]; 0 if it is solid
  double radius;        ///< b, where they meet [length]
  double outside;       ///< d, outer radius of the hub [length]
  double interference;  ///< radius of the shaft less that of the hub [length]; < 0 is a clearance
  double shaft_modulus, shaft_ratio;  ///< E [force/length^2] and nu of the shaft
  double hub_modulus, hub_ratio;      ///< E [force/length^2] and nu of the hub
};

/// What the interference does, tension > 0.
struct FitStress {
  double pressure;    ///< between shaft and hub [force/length^2]; 0 with a clearance
  double hub_hoop;    ///< hoop stress of the hub where it meets the shaft [force/length^2]
  double shaft_hoop;  ///< hoop stress of the shaft at its bore, or in its middle if it is solid
};

/// Pressure and stresses of a press fit.
///
/// A ring from s to t under the pressure q has at its loaded rim the displacement
/// q s [(t^2 + s^2) / (t^2 - s^2) + nu] / E, outwards, if q acts inside, and
/// q t [(t^2 + s^2) / (t^2 - s^2) - nu] / E, inwards, if q acts outside.
/// \param fit  a hub on a shaft
/// \throws std::invalid_argument unless 0 <= a < b < d and both moduli are positive
[[nodiscard]] FitStress press_fit(const Fit& fit);

}  // namespace ex14_2

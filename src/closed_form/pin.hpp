/// \file
/// A pin pressed against the edge of a hole in an infinite plate, without friction: closed form.
#pragma once

namespace signorini {

/// A pin with clearance in a hole of an infinite plate; forces are per thickness.
///
/// The closed form is exact if (1 - 2 nu) / G is the same in pin and plate (plane strain): for
/// equal materials, and for a rigid pin in an incompressible plate. Else the pressure for a given
/// contact angle is off by about 1 %, the relation of load and angle by much more.
struct PinInPlate {
  double hole_radius;      ///< a [length]
  double clearance;        ///< Delta R, radius of the hole less radius of the pin [length], >= 0
  double force;            ///< P of the pin [force/length], > 0
  double plate_modulus;    ///< E_h, E / (1 - nu^2) of the plate in plane strain [force/length^2]
  double contact_modulus;  ///< E*, 1/E* = 1/E_h + 1/E_pin; E_h if the pin is rigid [force/length^2]
};

/// Load relation of Persson [\ref Persson1964] and of Ciavarella and Decuzzi
/// [\ref CiavarellaDecuzzi2001], with \f$ b = \tan(\alpha / 2) \f$:
/// \f[ \frac{E^{*} \Delta R}{P} =
/// \frac{1 - (E^{*} / E_h)(\ln(1 + b^2) + 2 b^4)}{\pi b^2 (1 + b^2)}. \f]
/// \param half_angle      alpha, half of the arc in contact [rad], between 0 and pi
/// \param stiffness_ratio E* / E_h [-]: 1 for a rigid pin, 1/2 for equal materials
/// \return E* Delta R / P [-]; falls with the angle towards -2/pi of the ratio, and is negative where
///   only a pin that is thicker than the hole could touch so far
/// \throws std::invalid_argument if the angle is out of range or the ratio not positive
[[nodiscard]] double pin_clearance_over_load(double half_angle, double stiffness_ratio);

/// Half of the arc in contact: the root of the load relation, by bisection to rounding.
/// \param pin  with its load
/// \return alpha [rad]
/// \throws std::invalid_argument unless radius, force and moduli are positive and the clearance is
///   not negative
[[nodiscard]] double pin_contact_angle(const PinInPlate& pin);

/// Contact pressure, with \f$ y = \tan(\theta / 2) \f$:
/// \f[ \frac{p a}{P} = \frac{2}{\pi} \frac{\sqrt{b^2 - y^2}}{\sqrt{1 + b^2}\,(1 + y^2)} +
///     \frac{1}{2 \pi b^2 (1 + b^2)}
///     \ln\frac{\sqrt{1 + b^2} + \sqrt{b^2 - y^2}}{\sqrt{1 + b^2} - \sqrt{b^2 - y^2}}. \f]
/// \param pin    with its load
/// \param theta  angle from the middle of the contact [rad]
/// \return pressure [force/length^2], 0 outside of the contact
/// \throws std::invalid_argument as pin_contact_angle()
[[nodiscard]] double pin_pressure(const PinInPlate& pin, double theta);

}  // namespace signorini

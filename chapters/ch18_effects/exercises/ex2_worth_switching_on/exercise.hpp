/// \file
/// Exercise 18.2 - which effects a shrink fit calls for. Do not change this file.
#pragma once
#include <string>
#include <vector>

namespace ex18_2 {

/// A hub shrunk onto a hollow shaft of the same E and nu, in plane stress; they meet on one radius.
struct Fit {
  double bore;          ///< a, inner radius of the shaft [length]
  double radius;        ///< b, where they meet [length]
  double outside;       ///< c, outer radius of the hub [length]
  double modulus;       ///< E of both [force/length^2]
  double ratio;         ///< nu of both [-]
  double interference;  ///< delta > 0, by so much more the radii overlap [length]

  double density = 0;          ///< of both [mass/length^3]
  double speed = 0;            ///< omega, at which both turn about their centre [1/time]
  double pressure = 0;         ///< on the outer rim of the hub [force/length^2]
  double shaft_expansion = 0;  ///< alpha of the shaft [1/temperature]
  double hub_expansion = 0;    ///< alpha of the hub [1/temperature]
  double shaft_warmer = 0;     ///< than when the interference was measured [temperature]
  double hub_warmer = 0;       ///< the same of the hub [temperature]
  double friction = 0;         ///< mu between them [-]
};

/// What an effect does to the fit.
struct Change {
  std::string effect;  ///< as in signorini::Plan::off
  double share;        ///< of p0: by so much of it the contact pressure grows; never below -1 [-]
};

/// What each effect does when it alone is switched on, before anything is computed.
///
/// p0 is the pressure between shaft and hub by the interference alone,
/// \f[ p_0 = \frac{E\delta\,(b^2 - a^2)(c^2 - b^2)}{2 b^3 (c^2 - a^2)}. \f]
/// As long as they touch, shaft and hub of one material are one ring from a to c as far as loads go, and
/// what loads do adds to p0. What is left of the pressure cannot be less than nothing.
/// \param fit  with all effects
/// \return `body force` (of the speed), `edge loads` (the pressure outside), `temperature` and `friction`, the largest
///   |share| first; equal ones in this order
/// \throws std::invalid_argument unless 0 < a < b < c, and E and delta are positive
[[nodiscard]] std::vector<Change> changes(const Fit& fit);

/// The effects without which a pressure of given accuracy cannot be had.
///
/// The effects are switched on from the largest |share| down, until those that are left add up to no more than
/// the accuracy, sum |share| <= accuracy: one small effect may be left out, many small ones may not.
/// \param fit       with all effects
/// \param accuracy  of the pressure over p0 [-], positive
/// \return their names, the largest first; none if all may be left out
/// \throws std::invalid_argument as changes(), or unless the accuracy is positive
[[nodiscard]] std::vector<std::string> worth_switching_on(const Fit& fit, double accuracy);

}  // namespace ex18_2

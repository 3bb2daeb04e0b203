/// \file
/// Exercise 6.3 - reading a pressure. Do not change this file.
#pragma once

namespace ex6_3 {

/// What the foundation and the clamp hold, in cm and kN.
struct Answers {
  double first_closed = 0;  ///< x of the first node with a pressure [cm]
  double peak = 0;          ///< largest pressure [kN/cm^2], to 0.01
  double peak_at = 0;       ///< x of that node [cm]
  double force = 0;         ///< of the foundation [kN], to 0.01
  double place = 0;         ///< x where one force of that size would do the same [cm], to 0.01
  double clamp_force = 0;   ///< that the clamp bears, upwards [kN], to 0.01
  double clamp_moment =
      0;  ///< that the clamp bears: load times lever less foundation times lever [kN cm], to 1
};

/// \return your answers
[[nodiscard]] Answers answers();

}  // namespace ex6_3

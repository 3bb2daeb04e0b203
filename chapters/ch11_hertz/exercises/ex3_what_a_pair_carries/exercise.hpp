/// \file
/// Exercise 11.3 - what a printed pair carries. Do not change this file.
#pragma once

namespace ex11_3 {

/// Half-width and largest pressure of a contact, as somebody printed them.
struct Printed {
  double half_width;  ///< b [length]
  int b_digits;       ///< printed behind its point, 0 or more
  double peak;        ///< q_0 [force/length^2]
  int q_digits;       ///< printed behind its point, 0 or more
};

/// The contact that they were computed for.
struct Contact {
  double load;     ///< P [force/length]
  double radius;   ///< R [length]
  double modulus;  ///< E* [force/length^2]
};

/// Load of an ellipse of pressure of this half-width and height.
/// \param row  as printed
/// \return load [force/length]
/// \throws std::invalid_argument if half-width or peak is not positive and finite, or digits are negative
[[nodiscard]] double carried(const Printed& row);

/// Whether there are numbers that print like these and carry a load together.
/// \param row   as printed: each number may be off by half a unit of its last digit
/// \param load  [force/length]
/// \return true if rounding explains the difference
/// \throws std::invalid_argument as carried(), or if the load is not positive and finite
[[nodiscard]] bool is_rounding(const Printed& row, double load);

/// With which number in the place of pi the first line of (43) gives the half-width. \PaperEq{LinEtAl, 43}
/// \param row      as printed
/// \param contact  positive numbers
/// \return pi, if all is right [-]
/// \throws std::invalid_argument as carried(), or if a number of the contact is not positive and finite
[[nodiscard]] double pi_in_half_width(const Printed& row, const Contact& contact);

/// The same for the second line of (43) and the peak. \PaperEq{LinEtAl, 43}
/// \param row      as printed
/// \param contact  positive numbers
/// \return pi, if all is right [-]
/// \throws std::invalid_argument as carried(), or if a number of the contact is not positive and finite
[[nodiscard]] double pi_in_peak(const Printed& row, const Contact& contact);

}  // namespace ex11_3

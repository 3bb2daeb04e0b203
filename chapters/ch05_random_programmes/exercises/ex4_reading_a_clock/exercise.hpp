/// \file
/// Exercise 5.4 - reading a clock. Do not change this file.
#pragma once

namespace ex5_4 {

/// What table 1 of Xuan & Li 2002 says.
struct Answers {
  int lemke_ticks = 0;  ///< of the clock in the time of Lemke's method, first line
  int paper_ticks = 0;  ///< and in that of the paper's method
  int undecided =
      0;  ///< lines whose two times differ by less than two ticks: either method may be the quicker one
  double uncertainty = 0;  ///< a tick over the time of Lemke's method at n = m = 20 [-], to 0.002
  int best_n = 0;  ///< n of the line where the paper's method gains most, as a ratio of the times
  int best_m = 0;  ///< and its m
  double exponent =
      0;  ///< of Lemke's times between n = m = 10 and n = m = 50, as a power of n, to 0.02
  int above_one = 0;  ///< lines whose ratio of energies is above 1
};

/// \return your answers
[[nodiscard]] Answers answers();

}  // namespace ex5_4

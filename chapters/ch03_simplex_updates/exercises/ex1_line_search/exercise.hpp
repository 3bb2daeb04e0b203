/// \file
/// Exercise 3.1 - a step in closed form. Do not change this file.
#pragma once

namespace ex3_1 {

/// How s varies along a line of weights.
struct Line {
  double b0;  ///< b.xi, positive
  double b1;  ///< b.delta
  double c0;  ///< xi.G xi, positive
  double c1;  ///< xi.G delta
  double c2;  ///< delta.G delta >= 0, with c1^2 <= c0 c2
};

/// The step with the largest \f$ s(t) = \tfrac12 (b_0 + b_1 t)_+^2 / (c_0 + 2 c_1 t + c_2 t^2) \f$.
/// \param line     five numbers
/// \param largest  bound of the step, not negative
/// \return t in [0, largest]; 0 if s does not rise at t = 0
[[nodiscard]] double best_step(const Line& line, double largest);

}  // namespace ex3_1

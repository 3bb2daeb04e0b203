/// \file
/// How far to go along a step.
#pragma once
#include "signorini/core/rounding.hpp"

namespace signorini {

/// Armijo's rule: halves a step until a merit falls by a part of what its slope promises,
/// \f$ m(t) \le m(0) + 10^{-4}\, t\, m'(0) \f$ and \f$ m(t) < m(0) \f$.
///
/// Any part below 1/2 lets the full Newton step pass near a solution.
/// \param merit  m(0) where the step begins
/// \param slope  m'(0) < 0 along the step
/// \param at     moves to a length t of the step and returns m(t)
/// \return the length t, where `at` was called last; 0 if the merit falls no more
template <typename At>
double armijo(double merit, double slope, At&& at) {
  constexpr double enough = 1e-4;
  for (double length = 1; length > epsilon; length /= 2) {
    const double now = at(length);
    if (now < merit && now <= merit + enough * length * slope) return length;
  }
  return 0;
}

}  // namespace signorini

/// \file
/// A rigid cylinder on a half-plane, whose forces two programs ask for.
#pragma once
#include "papers/examples.hpp"

namespace signorini {

/// A rigid cylinder, R = 50 mm, pressed into a half-plane until 2.16 mm of it touch: 40 pairs on 3.6 mm, in
/// mm and N per mm of thickness.
inline ContactProblem pressed_cylinder() {
  const double stiffness = 4000 / (1 - 0.35 * 0.35);  // E / (1 - nu^2) [N/mm^2]
  ContactProblem problem = half_plane_indentation(40).problem;
  problem.compliance /= stiffness;
  problem.free_gap *= 1.8 * 1.8 / 50;
  return problem;
}

}  // namespace signorini

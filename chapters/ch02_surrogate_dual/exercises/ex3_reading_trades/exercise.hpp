/// \file
/// Exercise 2.3 - reading trades. Do not change this file.
#pragma once
#include <array>

namespace ex2_3 {

/// What the table of trades says of the three candidates left, middle and right.
struct Answers {
  std::array<double, 3> yield = {};  ///< how far a newton pushes each of them back [mm/N], to 1 %
  double coupling = 0;  ///< mean of the six entries of G beside its diagonal [mm/N], to 0.001
  int best_pair = 0;    ///< the single pair whose trade is worth most: 0 left, 1 middle, 2 right
  double share = 0;     ///< what that trade is worth, as a share of the best one [-], to 0.005
  double at_least =
      0;  ///< the trade of equal weights alone: the energy of the solution is not below this [N mm], to 0.01
  double missing = 0;  ///< by how much that bound misses the energy of the solution [N mm], to 0.01
};

/// \return your answers
[[nodiscard]] Answers answers();

}  // namespace ex2_3

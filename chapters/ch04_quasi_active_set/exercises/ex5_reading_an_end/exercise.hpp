/// \file
/// Exercise 4.5 - reading an end. Do not change this file.
#pragma once
#include <vector>

namespace ex4_5 {

/// What the tables say. Rows are counted from 1.
struct Answers {
  // The four walls.
  std::vector<int> overlapping;  ///< rows that the point of (33) violates, increasing
  double largest_overlap = 0;    ///< the largest of their overlaps, to 1e-3
  int pulling = 0;               ///< the row that would have to pull for (35) to be an optimum
  int missing = 0;               ///< the row that bears a force at the optimum and none at (35)
  double at_least =
      0;  ///< without the last line of the table: the least energy is not below this, to 1e-3
  double at_most = 0;  ///< and not above this, to 1e-3
  double lost = 0;     ///< with it: what (35) has more than the least energy, to 1e-3
  // The zigzag.
  double eta_20 = 0;  ///< eta at k = 20, to 1e-9
};

/// \return your answers
[[nodiscard]] Answers answers();

}  // namespace ex4_5

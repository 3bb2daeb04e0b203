/// \file
/// Exercise 21.2 - what a front costs. Do not change this file.
#pragma once
#include <vector>

namespace ex21_2 {

/// A front: the dense matrix of some unknowns and of those further up that they are joined with.
struct Front {
  int own = 0;   ///< unknowns that it eliminates
  int rim = 0;   ///< unknowns further up
  int rows = 0;  ///< rows of A that it carries
};

/// Multiplications and divisions.
struct Price {
  double factor = 0;      ///< of the elimination: a division for each row below an unknown, and the lower triangle of its update
  double compliance = 0;  ///< of its part of H, of what the rows hand to the rim, and of the lower triangle of H^T H
};

/// \param front  any, counts not negative
/// \return its price; roots do not count, nor do additions
/// \throws std::invalid_argument if a count is negative
[[nodiscard]] Price price(const Front& front);

/// \param fronts  of a body
/// \return operations of all rows over those of the factor [-]; 0 if there is no factor
[[nodiscard]] double share_of_contact(const std::vector<Front>& fronts);

}  // namespace ex21_2

/// \file
/// Exercise 21.1 - a tree by hand. Do not change this file.
#pragma once
#include <vector>

namespace ex21_1 {

/// What an order of elimination makes of a chain.
struct Tree {
  std::vector<int> parent;  ///< of each place of the order the place of its parent, -1 for the root
  int height = 0;           ///< columns on the longest way to the root, both ends counted
  long long entries = 0;    ///< of L, with its diagonal
};

/// Eliminates the unknowns of a chain 0 - 1 - ... - n-1, each joined to the one before and the one after.
/// \param order  the unknown at each place, each of 0 to n-1 once
/// \return the tree
[[nodiscard]] Tree eliminate(const std::vector<int>& order);

/// The order of separators: a part without its middle, the two halves first, the left one before the right.
/// \param n  unknowns of the chain
/// \return the unknown at each place; the middle of first to last is (first + last) / 2
[[nodiscard]] std::vector<int> separators(int n);

}  // namespace ex21_1

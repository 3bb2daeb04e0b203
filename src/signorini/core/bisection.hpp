// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Where a condition changes, to the last digit.
#pragma once
#include <utility>

namespace signorini {

/// Halves an interval until rounding leaves nothing between its ends.
/// \param low    where the condition holds, or would just above
/// \param high   larger; where it fails
/// \param holds  condition on a number, which changes once in between
/// \return neighbours: the last number found where it holds, and the first where it fails
template <typename Condition>
std::pair<double, double> bisected(double low, double high, const Condition& holds) {
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high))
    (holds(middle) ? low : high) = middle;
  return {low, high};
}

}  // namespace signorini

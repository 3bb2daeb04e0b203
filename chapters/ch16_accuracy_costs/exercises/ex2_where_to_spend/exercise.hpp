/// \file
/// Exercise 16.2 - where to spend. Do not change this file.
#pragma once
#include <string>
#include <vector>

namespace ex16_2 {

/// A line of an error budget.
struct Cause {
  std::string name;   ///< of the cause
  double error = 0;   ///< its part of the error, 0 or above
  double cost = 0;    ///< what it costs to have it as small as that [s]
  double growth = 0;  ///< by which the cost is multiplied when the error is halved; 0: it cannot be
};

/// What to do.
struct Spending {
  std::vector<Cause> budget;        ///< after the last halving
  std::vector<std::string> halved;  ///< names, in order, as often as it was done
  bool reached = false;             ///< whether the sum of the errors is at most the target
  std::string obstacle;             ///< if not: the largest cause that cannot be halved; else empty
};

/// Halves the largest error that can be halved until the sum is at most the target. Nothing is halved if the errors
/// that cannot be are the target or more by themselves, and others come on top. Of equal errors the first counts.
/// \param budget  any
/// \param target  of the sum of errors, above 0
/// \return what to do
/// \throws std::invalid_argument if the target is not above 0
[[nodiscard]] Spending spend(std::vector<Cause> budget, double target);

}  // namespace ex16_2

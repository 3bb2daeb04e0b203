/// \file
/// Exercise 16.4 - find the fault. Do not change this file.
#pragma once
#include <string>
#include <vector>

namespace ex16_4 {

/// A phase of a forecast.
struct Phase {
  std::string name;      ///< as in the ledger
  double predicted = 0;  ///< seconds, above 0
  double measured = 0;   ///< seconds, above 0
};

/// What became of a forecast.
struct Verdict {
  double slowness = 1;  ///< of the machine: the median of measured / predicted
  std::vector<std::string>
      faulty;  ///< phases that are off although the machine is taken into account, in order
};

/// Looks for phases whose law of growth is wrong.
/// \param phases     of one run
/// \param share      phases with at most this share of the measured seconds do not count [-]
/// \param tolerance  a phase is faulty if predicted * slowness / measured is off 1 by more [-]
/// \return the verdict; slowness 1 and nothing at fault if no phase counts
[[nodiscard]] Verdict find_fault(const std::vector<Phase>& phases, double share = 0.05,
                                 double tolerance = 0.25);

}  // namespace ex16_4

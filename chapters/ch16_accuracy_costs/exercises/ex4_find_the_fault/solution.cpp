#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace ex16_4 {

Verdict find_fault(const std::vector<Phase>& phases, double share, double tolerance) {
  Verdict verdict;
  double all = 0;
  for (const Phase& phase : phases) all += phase.measured;
  std::vector<double> ratios;
  for (const Phase& phase : phases)
    if (phase.measured > share * all) ratios.push_back(phase.measured / phase.predicted);
  if (ratios.empty()) return verdict;
  std::sort(ratios.begin(), ratios.end());
  const std::size_t half = ratios.size() / 2;
  verdict.slowness =
      ratios.size() % 2 == 1 ? ratios[half] : 0.5 * (ratios[half - 1] + ratios[half]);
  for (const Phase& phase : phases)
    if (phase.measured > share * all &&
        std::abs(phase.predicted * verdict.slowness / phase.measured - 1) > tolerance)
      verdict.faulty.push_back(phase.name);
  return verdict;
}

}  // namespace ex16_4

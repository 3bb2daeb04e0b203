#include <cmath>

#include "exercise.hpp"

namespace ex16_4 {

Verdict find_fault(const std::vector<Phase>& phases, double /*share*/, double tolerance) {
  Verdict verdict;
  for (const Phase& phase : phases)  // your code here: the machine, and what does not count
    if (std::abs(phase.predicted / phase.measured - 1) > tolerance)
      verdict.faulty.push_back(phase.name);
  return verdict;
}

}  // namespace ex16_4

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "exercise.hpp"

namespace ex16_2 {

Spending spend(std::vector<Cause> budget, double target) {
  if (!(target > 0)) throw std::invalid_argument("spend: the target must be above 0");
  Spending out;
  out.budget = std::move(budget);
  while (true) {
    double sum = 0;
    for (const Cause& cause : out.budget) sum += cause.error;
    out.reached = sum <= target;
    if (out.reached) return out;
    const auto largest =
        std::max_element(out.budget.begin(), out.budget.end(),
                         [](const Cause& a, const Cause& b) { return a.error < b.error; });
    if (largest->growth == 0) {
      out.obstacle = largest->name;
      return out;
    }
    largest->error /= 2;
    largest->cost *= largest->growth;
    out.halved.push_back(largest->name);
  }
}

}  // namespace ex16_2

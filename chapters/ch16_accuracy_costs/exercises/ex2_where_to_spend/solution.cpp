#include <algorithm>
#include <stdexcept>
#include <utility>

#include "exercise.hpp"

namespace ex16_2 {

static double sum_of(const std::vector<Cause>& budget, bool fixed_only) {
  double sum = 0;
  for (const Cause& cause : budget)
    if (!fixed_only || cause.growth == 0) sum += cause.error;
  return sum;
}

static Cause& largest(std::vector<Cause>& budget, bool fixed) {
  return *std::max_element(budget.begin(), budget.end(), [&](const Cause& a, const Cause& b) {
    const bool a_counts = (a.growth == 0) == fixed, b_counts = (b.growth == 0) == fixed;
    return a_counts == b_counts ? a.error < b.error : b_counts;
  });
}

Spending spend(std::vector<Cause> budget, double target) {
  if (!(target > 0)) throw std::invalid_argument("spend: the target must be above 0");
  Spending out;
  out.budget = std::move(budget);
  out.reached = sum_of(out.budget, false) <= target;
  if (!out.reached && sum_of(out.budget, true) >= target) {
    out.obstacle = largest(out.budget, true).name;
    return out;
  }
  while (!out.reached) {
    Cause& cause = largest(out.budget, false);
    cause.error /= 2;
    cause.cost *= cause.growth;
    out.halved.push_back(cause.name);
    out.reached = sum_of(out.budget, false) <= target;
  }
  return out;
}

}  // namespace ex16_2

#include <cmath>
#include <limits>

#include "exercise.hpp"

namespace ex17_4 {

double smallest_lie(const signorini::ContactProblem& problem, const signorini::ContactState& state,
                    Eigen::Index pair, double accepted) {
  const auto seen = [&](double share) {
    signorini::ContactState lie = state;
    lie.force(pair) += share * state.force(pair);
    return !certify(problem, lie).holds(accepted);
  };
  if (state.force(pair) == 0 || !seen(1)) return std::numeric_limits<double>::infinity();
  double small = 1e-16, large = small;
  while (!seen(large)) {
    small = large;
    large *= 2;
  }
  while (large / small > 1 + 1e-7) {  // the mean of two powers
    const double middle = std::sqrt(small * large);
    (seen(middle) ? large : small) = middle;
  }
  return large;
}

}  // namespace ex17_4

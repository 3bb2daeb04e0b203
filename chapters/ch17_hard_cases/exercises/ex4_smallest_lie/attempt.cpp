#include "exercise.hpp"

namespace ex17_4 {

double smallest_lie(const signorini::ContactProblem& /*problem*/,
                    const signorini::ContactState& /*state*/, Eigen::Index /*pair*/,
                    double accepted) {
  return accepted;  // your code here
}

}  // namespace ex17_4

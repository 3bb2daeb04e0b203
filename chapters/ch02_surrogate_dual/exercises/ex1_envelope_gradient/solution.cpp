#include <algorithm>

#include "exercise.hpp"

namespace ex2_1 {

Eigen::VectorXd gradient(const Eigen::MatrixXd& compliance, const Eigen::VectorXd& free_gap,
                         const Eigen::VectorXd& weights) {
  const Eigen::VectorXd yield = compliance * weights;  // of all pairs to a unit of total force
  const double force = std::max(0.0, -free_gap.dot(weights)) / weights.dot(yield);
  return -force * (free_gap + force * yield);
}

}  // namespace ex2_1

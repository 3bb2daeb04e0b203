#include <limits>

#include "exercise.hpp"

namespace ex2_2 {

Gain dual_energy(const Eigen::MatrixXd& compliance, const Eigen::VectorXd& free_gap,
                 const Eigen::VectorXd& weights) {
  const double overlap = -free_gap.dot(weights);
  if (overlap <= 0) return {0, 0};  // open or grazing: pressing gains nothing
  const double yield = weights.dot(compliance * weights);
  const double infinity = std::numeric_limits<double>::infinity();
  if (yield <= 0) return {infinity, infinity};  // nothing gives way: the line rises for ever
  const double force = overlap / yield;
  return {force, 0.5 * force * overlap};
}

}  // namespace ex2_2

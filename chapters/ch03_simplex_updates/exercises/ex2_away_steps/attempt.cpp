#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"

namespace ex3_2 {

Eigen::VectorXd away_step(const Eigen::MatrixXd& compliance, const Eigen::VectorXd& free_gap,
                          const Eigen::VectorXd& weights) {
  // The plain line search; your code here: the second direction and its largest step.
  const Eigen::VectorXd overlap =
      signorini::surrogate_dual_gradient({compliance, free_gap}, weights);  // times eta > 0
  Eigen::Index best = 0;
  overlap.maxCoeff(&best);
  const Eigen::VectorXd delta = Eigen::VectorXd::Unit(weights.size(), best) - weights;
  const Eigen::VectorXd yield = compliance * delta;
  const double step = signorini::best_step(
      {-free_gap.dot(weights), -free_gap.dot(delta), weights.dot(compliance * weights),
       weights.dot(yield), delta.dot(yield)},
      1);
  return weights + step * delta;
}

}  // namespace ex3_2

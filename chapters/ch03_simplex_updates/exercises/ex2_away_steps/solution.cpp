#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"

namespace ex3_2 {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd away_step(const Eigen::MatrixXd& compliance, const VectorXd& free_gap,
                   const VectorXd& weights) {
  const VectorXd overlap =
      signorini::surrogate_dual_gradient({compliance, free_gap}, weights);  // times eta > 0
  Index best = 0;
  overlap.maxCoeff(&best);
  Index worst = best;
  for (Index i = 0; i < weights.size(); ++i)
    if (weights(i) > 0 && (weights(worst) == 0 || overlap(i) < overlap(worst))) worst = i;

  const bool away = weights(worst) < 1 && -overlap(worst) > overlap(best);
  const double largest = away ? weights(worst) / (1 - weights(worst)) : 1;
  const VectorXd delta = away ? VectorXd(weights - VectorXd::Unit(weights.size(), worst))
                              : VectorXd(VectorXd::Unit(weights.size(), best) - weights);
  const VectorXd yield = compliance * delta;
  const double step = signorini::best_step(
      {-free_gap.dot(weights), -free_gap.dot(delta), weights.dot(compliance * weights),
       weights.dot(yield), delta.dot(yield)},
      largest);
  VectorXd next = weights + step * delta;
  if (away && step == largest) next(worst) = 0;  // no crumb
  return next;
}

}  // namespace ex3_2

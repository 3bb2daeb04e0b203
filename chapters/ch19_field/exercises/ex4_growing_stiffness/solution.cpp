#include "exercise.hpp"

namespace ex19_4 {

Ending augmented_lagrangian(const signorini::ContactProblem& problem, double stiffness,
                            double accuracy, Eigen::Index most) {
  Ending now{Eigen::VectorXd::Zero(problem.free_gap.size())};
  const double without = (-problem.free_gap).cwiseMax(0).maxCoeff();
  double last = without;
  while (!now.ended && now.passes < most) {
    now.force = on_springs(problem, now.force, stiffness);
    const Eigen::VectorXd gap = problem.free_gap + problem.compliance * now.force;
    const double overlap = (-gap).cwiseMax(0).maxCoeff();
    ++now.passes;
    now.ended = overlap <= accuracy * without;
    if (overlap > 0.1 * last) stiffness *= 10;
    last = overlap;
  }
  return now;
}

}  // namespace ex19_4

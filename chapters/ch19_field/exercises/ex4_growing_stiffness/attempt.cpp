#include "exercise.hpp"

namespace ex19_4 {

Ending augmented_lagrangian(const signorini::ContactProblem& problem, double stiffness,
                            double accuracy, Eigen::Index most) {
  Ending now{Eigen::VectorXd::Zero(problem.free_gap.size())};
  const double without = (-problem.free_gap).cwiseMax(0).maxCoeff();
  while (!now.ended && now.passes < most) {
    now.force = on_springs(problem, now.force, stiffness);  // change what follows
    const Eigen::VectorXd gap = problem.free_gap + problem.compliance * now.force;
    ++now.passes;
    now.ended = -gap.minCoeff() <= accuracy * without;
  }
  return now;
}

}  // namespace ex19_4

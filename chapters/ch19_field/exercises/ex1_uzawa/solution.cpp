#include "exercise.hpp"

namespace ex19_1 {

Ending uzawa(const Eigen::MatrixXd& G, const Eigen::VectorXd& free_gap, double accuracy,
             Eigen::Index most) {
  const Eigen::VectorXd step = G.cwiseAbs().rowwise().sum().cwiseInverse();
  const Eigen::VectorXd s = G.diagonal().cwiseSqrt();
  const double size = (-free_gap).cwiseMax(0).cwiseQuotient(s).maxCoeff();
  Ending now{Eigen::VectorXd::Zero(free_gap.size())};
  while (!now.ended && now.passes < most) {
    const Eigen::VectorXd gap = free_gap + G * now.force;
    const Eigen::VectorXd next = (now.force - step.cwiseProduct(gap)).cwiseMax(0);
    now.ended = s.cwiseProduct(next - now.force).cwiseAbs().maxCoeff() <= accuracy * size;
    now.force = next;
    ++now.passes;
  }
  return now;
}

}  // namespace ex19_1

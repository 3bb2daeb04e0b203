#include <algorithm>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex9_2 {

Penalised penalty(const signorini::DenseProgramme& programme, double k) {
  const Eigen::MatrixXd& A = programme.A;
  Penalised result;
  Eigen::ArrayXd pushes = Eigen::ArrayXd::Zero(A.rows());  // 1 where there is a spring
  Eigen::MatrixXd system;
  for (int step = 0; step < 100 && !result.settled; ++step) {
    const Eigen::MatrixXd springs = k * A.transpose() * pushes.matrix().asDiagonal();
    system = programme.stiffness + springs * A;
    result.displacement =
        signorini::CholeskyFactor(system).solve(programme.load + springs * programme.initial_gap);
    const Eigen::ArrayXd gap = programme.initial_gap - A * result.displacement;
    const Eigen::ArrayXd next = (gap < 0).cast<double>();
    result.settled = (next == pushes).all();
    result.force = (k * (-gap).max(0)).matrix();
    result.overlap = std::max(0.0, -gap.minCoeff());
    pushes = next;
  }
  const Eigen::VectorXd values = signorini::symmetric_eigenvalues(system);
  result.condition = values.maxCoeff() / values.minCoeff();
  return result;
}

}  // namespace ex9_2

#include "support/problems.hpp"

#include <algorithm>
#include <cmath>

namespace signorini_test {

signorini::ContactProblem random_problem(Random& random, Eigen::Index n) {
  Eigen::MatrixXd M(n, n);
  Eigen::VectorXd d(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    d(i) = random.uniform(-1, 1);
    for (Eigen::Index j = 0; j < n; ++j) M(i, j) = random.uniform(-1, 1);
  }
  return {M * M.transpose() + 0.05 * Eigen::MatrixXd::Identity(n, n), d};
}

signorini::ContactProblem with_rows(const signorini::ContactProblem& problem,
                                    const Eigen::VectorXd& row) {
  signorini::ContactProblem other = problem;
  Eigen::VectorXd all(
      problem.compliance.rows());  // the slip of a pair is measured in the unit of its gap
  all << row, Eigen::VectorXd(row(problem.law.pair));
  other.compliance = all.asDiagonal() * problem.compliance * all.asDiagonal();
  other.free_gap.array() *= row.array();
  other.free_slip.array() *= row(problem.law.pair).array();
  other.law.cohesion.array() /= row(problem.law.pair).array();
  if (problem.rigid.cols() > 0) other.rigid = all.asDiagonal() * problem.rigid;
  return other;
}

signorini::ContactProblem in_units(const signorini::ContactProblem& problem, double length,
                                   double force) {
  signorini::ContactProblem other = problem;
  other.compliance *= length / force;
  other.free_gap *= length;
  other.free_slip *= length;
  other.law.cohesion *= force;
  other.resultant *= force;
  return other;
}

signorini::ContactProblem cycling_problem() {
  Eigen::Matrix3d G;
  G << 4, -6, -4, -6, 10, 8, -4, 8, 9;
  return {G, Eigen::Vector3d(3, -4, -1)};
}

signorini::ContactProblem string_problem(Eigen::Index n) {
  Eigen::MatrixXd G(n, n);
  Eigen::VectorXd d(n);
  const auto x = [n](Eigen::Index i) {
    return static_cast<double>(i + 1) / static_cast<double>(n + 1);
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    d(i) = std::cos(9 * x(i)) - 0.2;
    for (Eigen::Index j = 0; j < n; ++j)
      G(i, j) = std::min(x(i), x(j)) * (1 - std::max(x(i), x(j)));
  }
  return {G, d};
}

}  // namespace signorini_test

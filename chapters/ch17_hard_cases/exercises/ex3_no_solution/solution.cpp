#include <cmath>

#include "exercise.hpp"

namespace ex17_3 {

bool proves(const signorini::ContactProblem& problem, const Eigen::VectorXd& y) {
  if (!y.allFinite() || (y.array() < 0).any()) return false;
  const Eigen::VectorXd moved = problem.compliance * y;
  const Eigen::VectorXd terms = problem.compliance.cwiseAbs() * y;
  if ((moved.array().abs() > 1e-12 * terms.array()).any()) return false;
  return problem.free_gap.dot(y) < -1e-12 * problem.free_gap.cwiseAbs().dot(y);
}

Eigen::VectorXd find_proof(const signorini::ContactProblem& problem) {
  const Eigen::Index n = problem.free_gap.size();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i + 1; j < n; ++j) {
      Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
      y(i) = 1 / std::sqrt(problem.compliance(i, i));
      y(j) = 1 / std::sqrt(problem.compliance(j, j));
      if (proves(problem, y)) return y;
    }
  return {};
}

}  // namespace ex17_3

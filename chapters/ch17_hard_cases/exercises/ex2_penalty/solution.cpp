#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex17_2 {

Eigen::VectorXd forces_of(const signorini::ContactProblem& problem, double stiffness) {
  const Eigen::Index n = problem.free_gap.size();
  Eigen::MatrixXd G = problem.compliance;
  G.diagonal().array() += 1 / stiffness;
  std::vector<Eigen::Index> closed;
  for (int step = 0; step < 100; ++step) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
    if (!closed.empty()) {
      const Eigen::MatrixXd part = G(closed, closed);
      const Eigen::VectorXd overlap = -problem.free_gap(closed);
      force(closed) = Eigen::LLT<Eigen::MatrixXd>(part).solve(overlap).eval();
    }
    const Eigen::VectorXd gap = problem.free_gap + problem.compliance * force;
    std::vector<Eigen::Index> next;
    for (Eigen::Index i = 0; i < n; ++i)
      if (force(i) > 0 || (force(i) == 0 && gap(i) < 0)) next.push_back(i);
    if (next == closed) return force;
    closed = next;
  }
  throw signorini::NotSolved("forces_of: a hundred sets of closed pairs do not suffice");
}

double stiffness_for(const signorini::ContactProblem& problem, double share) {
  const double wanted = -share * problem.free_gap.minCoeff();
  if (!(wanted > 0)) return 0;
  const auto overlap = [&](double k) { return forces_of(problem, k).maxCoeff() / k; };
  double soft = 1 / problem.compliance(0, 0), stiff = soft;
  while (overlap(soft) <= wanted) soft /= 2;
  while (overlap(stiff) > wanted) stiff *= 2;
  while (stiff / soft > 1 + 1e-10) {  // a mean without a unit
    const double middle = std::sqrt(soft) * std::sqrt(stiff);
    (overlap(middle) > wanted ? soft : stiff) = middle;
  }
  return stiff;
}

}  // namespace ex17_2

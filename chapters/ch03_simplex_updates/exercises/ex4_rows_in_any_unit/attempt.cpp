#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"

namespace ex3_4 {

using Eigen::VectorXd;

VectorXd update(const signorini::ContactProblem& problem, const VectorXd& xi) {
  // Right if all rows are in one unit: your changes here
  const VectorXd slope = signorini::surrogate_dual_gradient(problem, xi);  // eta (A u - g)
  Eigen::Index vertex = 0;
  slope.maxCoeff(&vertex);
  const VectorXd delta = VectorXd::Unit(xi.size(), vertex) - xi;
  const VectorXd moved = problem.compliance * delta;
  const signorini::WeightLine line{-problem.free_gap.dot(xi), -problem.free_gap.dot(delta),
                                   xi.dot(problem.compliance * xi), xi.dot(moved),
                                   delta.dot(moved)};
  return xi + signorini::best_step(line, 1) * delta;
}

}  // namespace ex3_4

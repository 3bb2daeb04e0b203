#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"

namespace ex3_4 {

using Eigen::VectorXd;

namespace {

VectorXd shares(const VectorXd& force) { return force / force.sum(); }

}  // namespace

VectorXd update(const signorini::ContactProblem& problem, const VectorXd& xi) {
  const VectorXd root = problem.compliance.diagonal().cwiseSqrt();
  const VectorXd scale = root.cwiseInverse();
  const signorini::ContactProblem scaled{
      scale.asDiagonal() * problem.compliance * scale.asDiagonal(),
      scale.cwiseProduct(problem.free_gap)};
  const VectorXd weights = shares(root.cwiseProduct(xi));
  const VectorXd slope = signorini::surrogate_dual_gradient(scaled, weights);
  Eigen::Index vertex = 0;
  slope.maxCoeff(&vertex);
  const VectorXd delta = VectorXd::Unit(xi.size(), vertex) - weights;
  const VectorXd moved = scaled.compliance * delta;
  const signorini::WeightLine line{-scaled.free_gap.dot(weights), -scaled.free_gap.dot(delta),
                                   weights.dot(scaled.compliance * weights), weights.dot(moved),
                                   delta.dot(moved)};
  const VectorXd next = weights + signorini::best_step(line, 1) * delta;
  return shares(scale.cwiseProduct(next));
}

}  // namespace ex3_4

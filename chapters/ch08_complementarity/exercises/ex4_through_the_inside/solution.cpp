#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"

namespace ex8_4 {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ContactProblem;

static void require_square(const ContactProblem& problem) {
  const Index n = problem.free_gap.size();
  if (problem.compliance.rows() != n || problem.compliance.cols() != n)
    throw std::invalid_argument("through the inside: G must have a row and a column per pair");
}

Inner central(const ContactProblem& problem, double epsilon) {
  require_square(problem);
  if (!(epsilon > 0) || !std::isfinite(epsilon))
    throw std::invalid_argument("central: epsilon must be positive and finite");
  const Index n = problem.free_gap.size();
  if (n == 0) return {};
  // All pairs in one unit, for gaps and forces.
  const VectorXd root = problem.compliance.diagonal().cwiseSqrt();
  const VectorXd d = problem.free_gap.cwiseQuotient(root);
  const MatrixXd G =
      root.cwiseInverse().asDiagonal() * problem.compliance * root.cwiseInverse().asDiagonal();
  const double size = std::max(d.cwiseAbs().maxCoeff(), std::sqrt(epsilon));
  ArrayXd force = ArrayXd::Constant(n, size), gap = force;
  for (int step = 0; step < 200; ++step) {
    const ArrayXd made = (d + G * force.matrix()).array();  // what the gaps should be
    const bool balanced = ((made - gap).abs() <= 1e-13 * (size + force.maxCoeff())).all();
    if (balanced && ((gap * force - epsilon).abs() <= 1e-11 * epsilon).all())
      return {(force / root.array()).matrix(), (gap * root.array()).matrix()};
    const double product = std::max(epsilon, 0.1 * (gap * force).mean());
    MatrixXd J = force.matrix().asDiagonal() * G;
    J.diagonal() += gap.matrix();
    const ArrayXd by = signorini::LuFactor(J).solve((product - force * made).matrix()).array();
    const ArrayXd opens = made - gap + (G * by.matrix()).array();
    double part = 1;
    for (Index i = 0; i < n; ++i) {
      if (by(i) < 0) part = std::min(part, -0.9 * force(i) / by(i));
      if (opens(i) < 0) part = std::min(part, -0.9 * gap(i) / opens(i));
    }
    force += part * by;
    gap += part * opens;
  }
  throw signorini::NotSolved("central: 200 steps are not enough");
}

VectorXd through_the_inside(const ContactProblem& problem) {
  require_square(problem);
  VectorXd force = VectorXd::Zero(problem.free_gap.size());
  if (force.size() == 0 || problem.free_gap.minCoeff() >= 0) return force;
  const VectorXd root = problem.compliance.diagonal().cwiseSqrt();
  const double size = problem.free_gap.cwiseQuotient(root).cwiseAbs().maxCoeff();
  const Inner inner = central(problem, 1e-16 * size * size);
  std::vector<Index> closed;
  for (Index i = 0; i < force.size(); ++i)
    if (inner.force(i) * root(i) > inner.gap(i) / root(i)) closed.push_back(i);
  const MatrixXd G = problem.compliance(closed, closed);
  force(closed) = signorini::CholeskyFactor(G).solve(-problem.free_gap(closed)).cwiseMax(0);
  return force;
}

}  // namespace ex8_4

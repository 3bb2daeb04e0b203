#include "signorini/closing/floating_projection.hpp"

#include <algorithm>
#include <limits>

#include "signorini/closing/complementarity_functions.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

FloatingProjection::FloatingProjection(const ScaledFloating& problem) : U(problem.span) {
  const MatrixXd& full = problem.contact.compliance;
  const VectorXd least = U * (problem.inverse.transpose() * problem.resultant);
  G = full - U * (U.transpose() * full);
  d = problem.contact.free_gap + full * least;
  d -= U * (U.transpose() * d);
  G -= (G * U).eval() * U.transpose();
  const auto row_sum = [](const MatrixXd& M) {
    return M.size() == 0 ? 0 : M.cwiseAbs().rowwise().sum().maxCoeff();
  };
  reach = row_sum(G);
  if (reach <=
      static_cast<double>(d.size() + 1) * std::numeric_limits<double>::epsilon() * row_sum(full)) {
    G.setZero();  // only rigid motions
    reach = row_sum(full) > 0 ? row_sum(full) : 1;
  }
  G /= reach;
  start = reach * least;
  share = U.transpose() * start;
}

VectorXd FloatingProjection::amplitude(const ScaledFloating& problem, const VectorXd& force,
                                       const VectorXd& b) const {
  const VectorXd gap = problem.contact.free_gap + problem.contact.compliance * (force / reach);
  return problem.inverse * (b - U.transpose() * gap);
}

void evaluate(const FloatingProjection& problem, FloatingPoint& point) {
  point.gap = problem.d;
  point.gap.noalias() += problem.G * point.force;
  point.gap.noalias() += problem.U * point.motion;
  for (Index i = 0; i < point.force.size(); ++i)
    point.residual(i) = fischer_burmeister(point.gap(i), point.force(i));
  point.merit = 0.5 * point.residual.squaredNorm();
}

FloatingPoint first_point(const FloatingProjection& problem) {
  const Index n = problem.d.size();
  FloatingPoint point{problem.start, VectorXd::Zero(problem.U.cols()), VectorXd(n), VectorXd(n)};
  evaluate(problem, point);
  return point;
}

std::vector<Index> closed_pairs(const FloatingPoint& point) {
  std::vector<Index> closed;
  const VectorXd excess = point.force - point.gap;
  for (Index i = 0; i < excess.size(); ++i)
    if (excess(i) > 0) closed.push_back(i);
  std::stable_sort(closed.begin(), closed.end(),
                   [&](Index i, Index j) { return excess(i) > excess(j); });
  return closed;
}

}  // namespace signorini

// Which pressures of Gauss points the bodies can tell apart.
#pragma once
#include <algorithm>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/scene/readings.hpp"

namespace ch10 {

using namespace signorini;

/// Closed points, their pressures, and what else these could be.
struct ClosedPoints {
  std::vector<Eigen::Index> points;  ///< their numbers
  Eigen::VectorXd root;              ///< of their weights
  Eigen::VectorXd pressure;          ///< as the solver returned it [force/length^2]
  Eigen::Index rank = 0;             ///< so many combinations of them are determined
  Eigen::MatrixXd free;              ///< Z: no node feels pressures Z y / root; orthonormal columns
};

/// Whatever has no gap may have a force. The rank is that of the forces on the nodes.
// [closed]
inline ClosedPoints closed_points(const SolvedScene& run) {
  ClosedPoints closed;
  double moved = 0;
  for (const NodeArray& u : run.solution.displacements)
    moved = std::max(moved, u.cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < run.solution.contact.gap.size(); ++i)
    if (run.solution.contact.gap(i) < 1e-9 * moved) closed.points.push_back(i);
  const Eigen::Index n = static_cast<Eigen::Index>(closed.points.size());
  closed.root = run.model.pairs.weight(closed.points).cwiseSqrt();
  closed.pressure = run.solution.pressure(closed.points);
  Eigen::MatrixXd forces(run.model.unknowns.count, n);  // of the unit of root * pressure
  for (Eigen::Index k = 0; k < n; ++k)
    forces.col(k) = closed.root(k) * run.model.programme.A.row(closed.points[k]).transpose();
  const SingularValues felt = singular_values(forces.transpose() * forces);
  closed.rank = (felt.values.array() > 1e-12 * felt.values.maxCoeff()).count();
  closed.free = felt.V.rightCols(n - closed.rank);
  return closed;
}
// [closed]

}  // namespace ch10

// What the pressures of Gauss points may be while nothing that can be seen of the bodies changes.
#pragma once
#include <algorithm>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/programme/active_set_programme.hpp"
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

/// The least |y - pull|^2 for which no pressure is negative: a point on a spring between walls.
/// \return the pressures there
// [pulled]
inline Eigen::VectorXd pulled(const ClosedPoints& closed, const Eigen::VectorXd& pull) {
  const double scale = closed.pressure.maxCoeff();
  const Eigen::VectorXd start = closed.root.cwiseProduct(closed.pressure) / scale;
  const Eigen::Index n = pull.size();
  const DenseProgramme walls{Eigen::MatrixXd::Identity(n, n), pull, -closed.free, start};
  const DenseSolution state = goldfarb_idnani(walls);
  if (state.report.status != Status::Solved) throw NotSolved("possible pressures: not found");
  return scale * state.gap.cwiseQuotient(closed.root);
}

struct Bounds {
  Eigen::VectorXd lowest, highest;
};

inline Bounds possible_pressures(const ClosedPoints& closed) {
  Bounds bounds{closed.pressure, closed.pressure};
  if (closed.free.cols() == 0) return bounds;
  const double far = 1e4 * closed.root.norm();
  for (Eigen::Index i = 0; i < closed.pressure.size(); ++i) {
    const Eigen::VectorXd up = far * closed.free.row(i).transpose().normalized();
    bounds.highest(i) = pulled(closed, up)(i);
    bounds.lowest(i) = pulled(closed, -up)(i);
  }
  return bounds;
}
// [pulled]

/// The pressures of least mean square among all that are possible.
inline Eigen::VectorXd least_pressures(const ClosedPoints& closed) {
  if (closed.free.cols() == 0) return closed.pressure;
  const double scale = closed.pressure.maxCoeff();
  return pulled(closed,
                -(closed.free.transpose() * closed.root.cwiseProduct(closed.pressure)) / scale);
}

}  // namespace ch10

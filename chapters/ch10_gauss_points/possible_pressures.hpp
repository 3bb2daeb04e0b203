// Which pressures closed points may have while no node feels a difference.
#pragma once
#include "addons/programme/active_set_programme.hpp"
#include "closed_points.hpp"
#include "signorini/core/errors.hpp"

namespace ch10 {

/// What the pressure of each closed point may be, from the lowest to the highest [force/length^2].
struct Bounds {
  Eigen::VectorXd lowest;   ///< of each point, >= 0
  Eigen::VectorXd highest;  ///< of each point
};

/// Pressures that are as far as they can be in the direction of a pull: the least |y - pull|^2 for which no pressure
/// is negative, a point on a spring between walls.
/// \param closed  points with their pressures and what no node feels \param pull  as many as `closed.free` has columns
/// \return pressures of the closed points, >= 0 [force/length^2] \throws signorini::NotSolved if the programme has no end
// [pulled]
inline Eigen::VectorXd pulled(const ClosedPoints& closed, const Eigen::VectorXd& pull) {
  const double scale = closed.pressure.maxCoeff();
  const Eigen::VectorXd start = closed.root.cwiseProduct(closed.pressure) / scale;
  const Eigen::Index n = pull.size();
  const DenseProgramme walls{Eigen::MatrixXd::Identity(n, n), pull, -closed.free, start};
  const DenseSolution state = goldfarb_idnani(walls);
  if (state.report.status != SolveStatus::Solved) throw NotSolved("possible pressures: not found");
  return scale * state.gap.cwiseQuotient(closed.root);
}

/// Each pressure as low and as high as it can be while no node feels it. \param closed  points \return bounds for each
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

}  // namespace ch10

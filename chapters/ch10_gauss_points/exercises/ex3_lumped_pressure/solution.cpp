#include "exercise.hpp"

namespace ex10_3 {

Eigen::VectorXd lumped_pressure(const Eigen::VectorXd& nodes, const Eigen::VectorXd& points,
                                const Eigen::VectorXd& weight, const Eigen::VectorXd& force) {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(nodes.size());
  Eigen::VectorXd share = nodal;
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    Eigen::Index edge = 0;
    while (edge + 2 < nodes.size() && nodes(edge + 1) <= points(k)) ++edge;
    const double s = (points(k) - nodes(edge)) / (nodes(edge + 1) - nodes(edge));
    const Eigen::Vector2d N(1 - s, s);
    nodal.segment<2>(edge) += force(k) * N;
    share.segment<2>(edge) += weight(k) * N;
  }
  return (share.array() > 0).select(nodal.array() / share.array(), 0);
}

}  // namespace ex10_3

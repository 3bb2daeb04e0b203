#include "exercise.hpp"

namespace ex10_3 {

// What many plots show: at a node the mean of the pressures of all points on its edges. Change it.
Eigen::VectorXd lumped_pressure(const Eigen::VectorXd& nodes, const Eigen::VectorXd& points,
                                const Eigen::VectorXd& weight, const Eigen::VectorXd& force) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(nodes.size());
  Eigen::VectorXd count = sum;
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    Eigen::Index edge = 0;
    while (edge + 2 < nodes.size() && nodes(edge + 1) <= points(k)) ++edge;
    sum.segment<2>(edge).array() += force(k) / weight(k);
    count.segment<2>(edge).array() += 1;
  }
  return (count.array() > 0).select(sum.array() / count.array(), 0);
}

}  // namespace ex10_3

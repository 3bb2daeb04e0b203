/// \file
/// Exercise 10.3 - the lumped pressure. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex10_3 {

/// Pressures at nodes from contact forces at points between them: force on a node over its share.
///
/// A node receives of each force the part that its linear shape function has there. Its share of the boundary is
/// the integral of that function, by the same points: the sum of its values times the weights. A node without
/// points on its edges has the pressure 0.
/// \param nodes   along the boundary, increasing [length], two or more
/// \param points  along it, anywhere between the first and the last node, in any order [length]
/// \param weight  of each point > 0 [length^2]
/// \param force   of each point [force]
/// \return pressure at each node [force/length^2]
[[nodiscard]] Eigen::VectorXd lumped_pressure(const Eigen::VectorXd& nodes,
                                              const Eigen::VectorXd& points,
                                              const Eigen::VectorXd& weight,
                                              const Eigen::VectorXd& force);

}  // namespace ex10_3

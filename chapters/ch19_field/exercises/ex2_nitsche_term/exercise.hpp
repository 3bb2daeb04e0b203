/// \file
/// Exercise 19.2 - Nitsche's term. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex19_2 {

/// A Gauss point of the side of a cell with `m` displacements.
struct Point {
  Eigen::VectorXd pressure;  ///< `m` q per displacement; compression > 0 [force/length^3]
  Eigen::VectorXd opening;   ///< `m` n per displacement [-]
  double free_gap = 0;       ///< g_0; open > 0 [length]
  double weight = 0;         ///< w, length times thickness [length^2]
};

/// What the point adds to the forces on the displacements, and to the matrix.
struct Term {
  Eigen::VectorXd force;  ///< `m` [force]
  Eigen::MatrixXd slope;  ///< `m x m` d force / d u [force/length]
};

/// Nitsche's term at a point.
/// \param at     the point
/// \param u      `m` displacements [length]
/// \param gamma  positive [force/length^3]
/// \param theta  1, 0 or -1 [-]
/// \return forces, row v for the test displacement that is 1 at v; and slopes. At the kink the slope of an open point
/// \throws std::invalid_argument unless gamma and the weight are positive and all three have `m` entries
[[nodiscard]] Term nitsche_term(const Point& at, const Eigen::VectorXd& u, double gamma,
                                double theta);

}  // namespace ex19_2

/// \file
/// Exercise 10.1 - one Gauss-point contact element. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex10_1 {

/// Two straight edges. The body of each lies to the left of the way from its first node to its second.
struct Edges {
  Eigen::Matrix2d source;  ///< rows: nodes 1 and 2 [length]
  Eigen::Matrix2d target;  ///< rows: nodes 3 and 4 [length]
};

/// What a Gauss point puts on the bodies.
struct Element {
  Eigen::Vector2d point;              ///< x_gp [length] \PaperEq{LinEtAl, 32}
  double gap;                         ///< along the normal of the target, open > 0 [length]
  Eigen::Matrix<double, 4, 2> force;  ///< rows: on nodes 1 to 4 [force]
};

/// Gap and nodal forces of a point on the source, \PaperEq{LinEtAl, 32} to \PaperEq{LinEtAl, 36} and
/// \PaperEq{LinEtAl, 38} to \PaperEq{LinEtAl, 41}, with the tangent t = (n_y, -n_x) in the latter. The
/// point faces the foot of its perpendicular on the target, which lies between nodes 3 and 4.
/// \param edges     as above, of thickness 1
/// \param xi        place of the point, from -1 at node 1 to 1 at node 2 [-]
/// \param weight    of the point in its rule on [-1, 1] [-]
/// \param pressure  f_n [force/length^2], compression > 0
/// \param shear     f_tau on the source, along t [force/length^2]
/// \return point, gap and forces
[[nodiscard]] Element gauss_point(const Edges& edges, double xi, double weight, double pressure,
                                  double shear);

}  // namespace ex10_1

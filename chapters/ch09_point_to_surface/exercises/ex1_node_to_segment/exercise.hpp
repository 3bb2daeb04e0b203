/// \file
/// Exercise 9.1 - a node over an edge. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <optional>

namespace ex9_1 {

/// Positions of, or forces on, the nodes 1 and 2 of the target and 3 of the source, one per row.
using Nodes = Eigen::Matrix<double, 3, 2>;

/// The place 3' of the edge that node 3 faces.
struct Place {
  double N1;          ///< shape function of node 1 at 3' [-]
  double N2;          ///< that of node 2 [-]
  Eigen::Vector2d n;  ///< unit normal out of the target, which lies left of the way from 1 to 2 [-]
  Eigen::Vector2d t;  ///< unit tangent (n_y, -n_x) [-]
  double gap;         ///< open > 0, overlap < 0 [length]
};

/// Projects node 3 onto the straight edge. \PaperEq{LinEtAl, 20} \PaperEq{LinEtAl, 22}
/// \param positions  of the three nodes [length]
/// \return the place; nothing if it lies beyond node 1 or node 2
[[nodiscard]] std::optional<Place> facing(const Nodes& positions);

/// What contact and friction do to the nodes. \PaperEq{LinEtAl, 23} to \PaperEq{LinEtAl, 27}
/// \param place     that node 3 faces
/// \param normal    f_n, on the source along n [force], compression > 0
/// \param friction  tau, on the source along t [force]
/// \return forces on the three nodes [force]; together they are zero
[[nodiscard]] Nodes shared_out(const Place& place, double normal, double friction);

}  // namespace ex9_1

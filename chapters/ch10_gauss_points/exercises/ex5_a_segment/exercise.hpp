/// \file
/// Exercise 10.5 - a segment. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex10_5 {

/// An edge of the source from a to b, and one of the target from c to d [length].
struct Edges {
  Eigen::Vector2d a, b, c, d;
};

/// The part of the source's edge that faces the target's edge, and integrals over it.
struct Segment {
  double from = 0, to = 0;  ///< s on the source's edge, -1 at a and 1 at b; from < to, or both 0
  Eigen::Vector2d D = Eigen::Vector2d::Zero();  ///< integral of psi_i [length]
  Eigen::Matrix2d M =
      Eigen::Matrix2d::Zero();  ///< integral of psi_i N_j, j = 1 for c and 2 for d [length]
  Eigen::Vector2d gap = Eigen::Vector2d::Zero();  ///< integral of psi_i g [length^2]
};

/// Points of the source face the target along the normal of the source's edge. psi_1 = (1 - 3 s)/2, psi_2 = (1 + 3 s)/2.
/// The gap is the distance from the source's point to the place that it faces, along n = (e_y, -e_x) with e from a to b
/// of length 1: positive if the target lies on that side. \PaperEq{LinEtAl, 36}
/// \param edges  two edges, that of the source of some length
/// \return the segment; all zero if no part of the edge faces the other, or if that stands along the normal
[[nodiscard]] Segment mortar_segment(const Edges& edges);

}  // namespace ex10_5

// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Points of pairs that are kept beside their rows: what a row of N forgets, and its change needs.
///
/// A row of \f$N\f$ is a mean over points. It says what a pair reads of the displacements where the bodies stand,
/// and not how it will read them once they have moved. That depends on the places that face each other,
/// and these are known to whoever writes the row, and shown by GapOptions::watch.
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "signorini/contact/obstacle.hpp"
#include "signorini/contact/pairs.hpp"
#include "signorini/core/alignment.hpp"
#include "signorini/pairing/mortar_points.hpp"

namespace signorini {

struct Interface;
struct Obstacle;
struct PairPoint;
struct Pairs;
struct SampledEdge;
struct Surface;

/// A place on a side: the nodes of the side and what each has of a force there.
struct SidePlace {
  std::array<Eigen::Index, 3> node = {
      -1, -1, -1};  ///< in walking order, among the nodes of all bodies; -1: no more nodes
  Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< shape functions [-]; 0 without a node

  /// \return 2 or 3 nodes of a side; a node that stands alone is 1, and a place on an obstacle has none
  [[nodiscard]] std::size_t n_nodes() const {
    return static_cast<std::size_t>(3 - (node[0] < 0) - (node[1] < 0) - (node[2] < 0));
  }
};

/// A place of the source and the place of the target that it faces, as a share of a pair.
struct KeptPoint {
  Eigen::Index pair = 0;  ///< number of the pair
  double share = 0;       ///< by which the point counts in it [-]; those of a pair add up to 1
  SidePlace source;       ///< where the point lies
  SidePlace target;       ///< what it faces; an obstacle has no nodes
  double xi = 0;          ///< place along the side of the target [-]; -1 or 1: at a vertex
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< unit vector out of the target [-]
  double gap = 0;                                    ///< [length], overlap < 0
  double turning =
      0;  ///< of an obstacle: how its normal turns as the point goes along it [1/length]
};

/// A place of the source from which on it faces the next side of the target, with another normal at the same distance.
/// Both points lie there; their share is that of a unit of length [1/length].
struct KeptJump {
  KeptPoint before;  ///< faces the side that the points before it face
  KeptPoint behind;  ///< faces the next one
  Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< unit tangent of the source there [-]
};

/// What pairs keep.
struct KeptPoints {
  std::vector<KeptPoint> points;  ///< of all pairs
  std::vector<KeptJump> jumps;    ///< between them
};

/// A point without references to what lives no longer than an interface.
/// \param interface  of source and target
/// \param point      on it
/// \param share      by which it counts in its pair [-]
/// \return the same point
[[nodiscard]] KeptPoint kept(const Interface& interface, const PairPoint& point, double share);

/// \param found  points of mortar pairs
/// \param pairs  `n_c` that they belong to
/// \return the points, and the places where normals jump between them
[[nodiscard]] KeptPoints kept_points(const MortarPoints& found, const Pairs& pairs);

/// What pairs of nodes with an obstacle keep. Each is its own point, with all of the force on one node of a
/// side. The target has no nodes, as nothing can move it.
/// \param pairs     `n_c` from node_to_obstacle()
/// \param source    of the pairs
/// \param obstacle  that they face
/// \return the points
[[nodiscard]] KeptPoints kept_points(const Pairs& pairs, const Surface& source,
                                     const Obstacle& obstacle);

/// Adds the points that some pairs have kept to those of others.
/// \param from    points of the pairs
/// \param number  `n_c` the number that each of them has among the others; -1: it is not among them
/// \param[in,out] to  points of the others
void append_points(const KeptPoints& from, const std::vector<Eigen::Index>& number, KeptPoints& to);

}  // namespace signorini

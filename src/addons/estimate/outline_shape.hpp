// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The line that the outline of a body follows between its nodes.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Straight lines and circles through neighbouring nodes of the outline, between its corners.
///
/// A node is a *corner* if the outline turns there by more than 60 degrees, or more than twice as far as at both
/// neighbours: on a circle, however unequal its sides, no node does. Three nodes on one line make both ways
/// between them straight. Elsewhere the way from node to node is the arc with the curvature of the circles
/// through it and the node before, and through it and the node behind: the mean of the two, weighted by how little
/// each differs from its neighbour, so that a line that runs into an arc without a corner stays a line. A single side
/// between two lines is straight.
class OutlineShape {
 public:
  /// \param mesh  any; must outlive this
  explicit OutlineShape(const Mesh& mesh);

  /// Middle of the arc between two neighbours.
  /// \param first  a node of the outline
  /// \param last   the next one, with the body to the left; in quadratic meshes middles are nodes as well
  /// \return the place [length]; exactly half way where the outline is straight, or is no outline
  [[nodiscard]] Eigen::Vector2d middle(Eigen::Index first, Eigen::Index last) const;

 private:
  /// What the outline does at a node.
  struct Turn {
    Eigen::Index before = -1;  ///< node; -1 if there are none or several
    Eigen::Index behind = -1;  ///< node
    double angle = 0;      ///< to the left > 0 [rad]; exactly 0 where three nodes are on one line
    double curvature = 0;  ///< of the circle through three nodes [1/length]
    bool corner = true;    ///< or no node of a single outline
  };
  [[nodiscard]] Eigen::Vector2d way(Eigen::Index from, Eigen::Index to) const;
  [[nodiscard]] double curvature(const Turn& first, const Turn& last) const;
  [[nodiscard]] const Turn& turn(Eigen::Index node) const;

  const Mesh& mesh_;
  std::vector<Turn> turns_;
};

}  // namespace signorini

/// \file
/// Where the source is integrated: Gauss points on its edges, or on segments between projected nodes.
#pragma once
#include <vector>

#include "signorini/contact/dual_basis.hpp"
#include "signorini/contact/interface.hpp"

namespace signorini {

/// A point of the source and the place of the target that it faces.
struct FacingPoint {
  EdgePoint at;       ///< on the edge
  Projection target;  ///< found
};

/// Integration of one edge of the source.
struct EdgeSamples {
  std::vector<FacingPoint> facing;  ///< points that face the target, along the edge
  Eigen::Vector2d share =
      Eigen::Vector2d::Zero();  ///< integrals of the corners' N over the whole edge [length]
};

/// Places at which what is integrated over the source has a kink: where the normals of the target at the
/// ends of its sides meet the source, and at a vertex also the line midway between them.
///
/// Between its two normals a vertex that sticks out is the place that the source faces; on the bisector of
/// one that recedes, the source changes from one side of the target to the other.
/// \param interface  of source and target
/// \return for each side of the source the places between its ends, increasing, none twice [-]
[[nodiscard]] std::vector<std::vector<double>> segment_cuts(const Interface& interface);

/// Samples one edge of the source.
/// \param edge       of the source
/// \param interface  of source and target
/// \param cuts       where the edge is cut into segments, increasing; none: the edge as it is
/// \param points     Gauss points per segment
/// \return points that face the target, and the share of the edge's corners
/// \throws ProblemError as Interface::closest()
[[nodiscard]] EdgeSamples sample_edge(const SideCurve& edge, const Interface& interface,
                                      const std::vector<double>& cuts, int points);

}  // namespace signorini

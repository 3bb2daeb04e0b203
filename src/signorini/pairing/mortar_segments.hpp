/// \file
/// Where the source is integrated: Gauss points on its edges, or on segments between projected nodes.
///
/// An integral over the source contains functions of the target, and the two meshes have their
/// nodes in different places. What is sampled here is one edge of the source with all that it
/// faces.
#pragma once
#include <array>
#include <vector>

#include "signorini/pairing/dual_basis.hpp"
#include "signorini/pairing/interface.hpp"

namespace signorini {

/// What lies between two neighbouring nodes of the source: a side of two nodes, or half of one of three.
struct SourceEdge {
  const SideCurve* side;              ///< of the source
  std::array<Eigen::Index, 2> nodes;  ///< at its ends, in walking order
  double begin;                       ///< xi of the side at the first end [-]
  double end;                         ///< xi of the side at the second end [-]
};

/// A point of the source and the place of the target that it faces.
struct FacingPoint {
  EdgePoint at;       ///< on the edge
  double xi;          ///< place along the side of the source [-]
  Projection target;  ///< found
};

/// Integration of one edge.
struct EdgeSamples {
  std::vector<FacingPoint> facing;  ///< points that face the target, along the edge
  Eigen::Vector2d share = {
      0, 0};  ///< integrals of end_shape() over the whole edge, as EdgePoint counts it
};

/// The edges of one side.
/// \param side  of the source; must outlive them
/// \return one, or two if it has three nodes
[[nodiscard]] std::vector<SourceEdge> edges_of(const SideCurve& side);

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
/// \param cuts       xi where its side is cut into segments, increasing; those outside of the edge count
///   nothing. None: the edge as it is
/// \param points     Gauss points per segment
/// \return points that face the target, and the shares of the edge's ends
/// \throws ProblemError as Interface::closest()
[[nodiscard]] EdgeSamples sample_edge(const SourceEdge& edge, const Interface& interface,
                                      const std::vector<double>& cuts, int points);

}  // namespace signorini

/// \file
/// Pairs of one point of the source with one place of the target each, written as rows of N and S.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/contact/interface.hpp"

namespace signorini {

/// A point of the source and the place that it faces.
struct PointPair {
  const SideCurve* side;     ///< of the source, on which the point lies
  double xi;                 ///< place along that side [-]
  Eigen::Vector2d position;  ///< of the point [length]
  double weight;             ///< share of the source [length^2]
  Eigen::Index node;         ///< of the source in its own mesh, or -1
  Projection place;          ///< on the target
};

/// Writes the rows.
///
/// What a row of N says can be read both ways. Times the displacements it is how much the gap opens:
/// the point of the source less the place of the target, along the normal of the target. Transposed,
/// times a force, it is what the nodes receive: every node of the side on which the point lies gets
/// its shape function's share of the force on the source, every node of the target's side its share
/// of the opposite force. Because both act along the line between the two points, they are in
/// balance. S does the same along the tangent.
/// \param interface  of source and target
/// \param points     in the order of the rows
/// \param options    of the operator; S is written if it is asked for
/// \return the pairs, without `unpaired`
[[nodiscard]] Pairs write_pairs(const Interface& interface, const std::vector<PointPair>& points,
                                const GapOptions& options);

}  // namespace signorini

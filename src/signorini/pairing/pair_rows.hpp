// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Pairs of points of the source with places of the target, written as gaps, normals and rows of N and S.
///
/// The three gap operators differ in where they sample the source, and by what amounts. From there
/// on they are one computation.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/pairing/interface.hpp"

namespace signorini {

/// A point of the source and the place that it faces, as a share of a pair.
struct PairPoint {
  Eigen::Index pair;      ///< number of its row
  const SideCurve* side;  ///< of the source, on which the point lies
  double xi;              ///< place along that side [-]
  Projection place;       ///< on the target
  double amount = 1;      ///< by which the point counts in the pair
};

/// Writes gaps, normals, moments and rows: of every pair the mean over its points.
///
/// What a row of N says can be read both ways. Times the displacements it is how much the gap opens:
/// the point of the source less the place of the target, along the normal of the target. Transposed,
/// times a force, it is what the nodes receive: every node of the side on which the point lies gets
/// its shape function's share of the force on the source, every node of the target's side its share
/// of the opposite force. Because both act along the line between the two points, they are in
/// balance. S does the same along the tangent.
/// \param interface  of source and target
/// \param points     of all pairs; those of one pair are added in this order
/// \param total      `n_c` what the points of each pair amount to
/// \param options    of the operator; S is written if it is asked for
///
/// Where the nodes stood elsewhere before, the slip since then is that of the places that face each other now,
/// \f$ t\cdot(x - \bar x) - t^0\cdot(x^0 - \bar x^0) \f$ with the tangents of the target now and then. A turn of
/// both bodies, then or now, changes none of the two numbers: so it is no slip.
/// \param pairs      with `position`; receives `slid` if the options say what has moved, `initial_gap`, `normal`, `moment`, `target_moment`, `opening` and `sliding`
void write_rows(const Interface& interface, const std::vector<PairPoint>& points,
                const Eigen::VectorXd& total, const GapOptions& options, Pairs& pairs);

}  // namespace signorini

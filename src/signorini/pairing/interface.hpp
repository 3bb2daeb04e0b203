/// \file
/// Two boundaries that may touch: their sides, the search, and the complaints about places that make
/// no sense.
///
/// Every gap operator begins with the same things: curves of the source, a search on the target,
/// and the question whether the two boundaries can be meant to touch at all.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/contact/gap_operators.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/pairing/target_search.hpp"

namespace signorini {

/// What the gap operators share.
struct Interface {
  /// \param source   the boundary whose points look for the target; its mesh must outlive this
  /// \param target   the boundary that they look for; its mesh must outlive this
  /// \param options  of the operator
  /// \throws ProblemError if a boundary does not exist
  /// \throws std::invalid_argument if a body has nodes beyond options.n_nodes, or the thickness is
  ///   not positive and finite
  Interface(const Surface& source, const Surface& target, const GapOptions& options);

  /// Closest-point projection by the rules of TargetSearch.
  /// \param x       point of the source [length]
  /// \param normal  of the source there, out of its body [-]
  /// \return the place it faces, if any
  /// \throws ProblemError if x lies inside the target body, deeper than the cell it faces
  [[nodiscard]] Projection closest(const AnchoredPoint& x, const Eigen::Vector2d& normal) const;
  /// Complains if there is nothing to pair.
  /// \param n_pairs  how many were found
  /// \throws ProblemError if there are none: the boundaries face the same way or miss each other
  void check_paired(std::size_t n_pairs) const;

  Surface source;                ///< the slave
  Surface target;                ///< the master
  std::vector<SideCurve> sides;  ///< of the source in walking order
  TargetSearch search;           ///< among the target's sides
  Depth depth;                   ///< across the plane
};

}  // namespace signorini

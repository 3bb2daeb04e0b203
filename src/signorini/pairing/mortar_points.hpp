// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What mortar pairs are means over, for whoever wants to know how their rows change: see PointWatch.
///
/// A row of \f$ N \f$ forgets which places face each other. They are known until it is written, with the edges on which they lie.
#pragma once
#include <vector>

#include "signorini/pairing/mortar_segments.hpp"
#include "signorini/pairing/pair_rows.hpp"

namespace signorini {

/// All that lives until the rows are written.
struct MortarPoints {
  const Interface& interface;             ///< of source and target
  const std::vector<PairPoint>& points;   ///< of all pairs
  const Eigen::VectorXd& total;           ///< `n_c` what the points of each pair amount to
  const std::vector<SampledEdge>& edges;  ///< of the source in walking order, cut into segments
};

}  // namespace signorini

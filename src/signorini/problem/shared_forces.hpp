/// \file
/// Forces that a solution leaves open.
///
/// Two pairs at the same point of a body share what they carry. Their rows of A are equal, so a force can go from one to the
/// other and nothing moves. If both carry 3 together, each force lies between 0 and 3, and the exchange is (1, -1).
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace signorini {

/// How far one force goes while all movements stay as they are.
struct ForceRange {
  Eigen::Index row;  ///< n_c forces of gaps, then n_s friction forces
  double low;   ///< least [force]; -infinity if nothing bounds it, NaN if it was not looked for
  double high;  ///< largest [force]
};

/// Pairs that share what they carry: forces of one can be exchanged for those of others.
struct SharedForces {
  std::vector<Eigen::Index> pairs;  ///< in increasing order
  std::vector<ForceRange> forces;   ///< that are not determined, rows in increasing order
  /// `n_c + n_s` by k: the exchanges, forces of all rows that move nothing, each with a largest entry of 1 where
  /// forces are measured by what they move
  Eigen::SparseMatrix<double> exchanges;

  /// \return the largest high - low; infinite if a range is, or was not looked for
  [[nodiscard]] double width() const {
    double most = 0;
    for (const ForceRange& range : forces) {
      const double width = range.high - range.low;
      most = std::max(most, std::isnan(width) ? std::numeric_limits<double>::infinity() : width);
    }
    return most;
  }
};

}  // namespace signorini

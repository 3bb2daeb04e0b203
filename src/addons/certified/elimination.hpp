// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which columns of a sparse matrix depend on each other, and how.
#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

namespace signorini {

/// Places and values.
using SparseEntries = std::vector<std::pair<Eigen::Index, double>>;

/// Finds the combinations of columns that are nothing, by Gaussian elimination with complete pivoting.
///
/// The largest entry that is left is the next pivot; its column is subtracted from all that have an entry in its
/// row, so no multiple is larger than 1. What is left of a column is nothing if it is at most a share of the largest term that
/// made it, which is to be what rounding of the data can be. Where columns along a line are coupled with their neighbours only,
/// so are those that are left, and the work of the eliminations grows with their number only.
/// \param columns  entries by rows; a row may occur more than once
/// \param rows     of the matrix
/// \param share    see above [-]
/// \return a basis of the combinations by numbers of columns, each with a largest entry of 1 and none up to `share`
[[nodiscard]] std::vector<SparseEntries> null_combinations(
    const std::vector<SparseEntries>& columns, Eigen::Index rows, double share);

}  // namespace signorini

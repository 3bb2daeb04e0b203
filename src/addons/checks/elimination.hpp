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

/// Finds the combinations of columns that are nothing, by a sparse QR factor with column pivoting.
///
/// A column, divided by its largest entry, depends on the columns before it if what is left of it is at most a share,
/// which is to be what rounding of the data can be. Where columns along a line are coupled with their neighbours only, so are
/// those of the factor, and the work grows with their number only.
/// \param columns  entries by rows; a row may occur more than once
/// \param rows     of the matrix
/// \param share    see above [-]
/// \return a basis of the combinations by numbers of columns, each divided such that its largest entry is 1 or its own column has 1
[[nodiscard]] std::vector<SparseEntries> null_combinations(
    const std::vector<SparseEntries>& columns, Eigen::Index rows, double share);

}  // namespace signorini

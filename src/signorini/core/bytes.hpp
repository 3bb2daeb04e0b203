// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Memory of compressed matrices.
#pragma once
#include <Eigen/SparseCore>

namespace signorini {

/// Memory that a row or column of a compressed matrix takes, with where its entries are.
/// \param entries  how many it has \return [byte]
[[nodiscard]] constexpr long long bytes_of_row(Eigen::Index entries) {
  return entries * static_cast<long long>(sizeof(double) + sizeof(int)) +
         static_cast<long long>(sizeof(int));
}

/// Memory that the entries of a compressed matrix take, with where they are.
/// \param matrix  any
/// \return [byte]
template <int Options>
[[nodiscard]] long long bytes_of(const Eigen::SparseMatrix<double, Options>& matrix) {
  return bytes_of_row(matrix.nonZeros()) + matrix.outerSize() * static_cast<long long>(sizeof(int));
}

}  // namespace signorini

/// \file
/// The order of elimination: a tree of separators, each of which parts what lies below it in two.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <memory>
#include <vector>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// Where unknowns are: one row (x, y) of each [length].
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// Unknowns that are eliminated together: a separator, or a part too small to be cut again.
struct Separator {
  int first = 0;                     ///< place of the first of them in the order
  int own = 0;                       ///< how many; none where the parts below do not touch
  std::array<int, 2> below{-1, -1};  ///< numbers of what it parts, -1 for nothing
};

/// An order of elimination by nested dissection [\ref George1973].
struct SeparatorTree {
  std::vector<int> order;             ///< `n` unknown at each place of the order
  std::vector<Separator> separators;  ///< what is below comes directly before, the second part last
};

/// What Factor::order() of the back end `frontal` holds, and Plan::order for it.
using EliminationOrder = std::shared_ptr<const SeparatorTree>;

/// Cuts the unknowns in two, each part likewise, and puts behind both parts the unknowns that join them.
///
/// A part is cut at the median of each coordinate and at the median of the distances in the graph from
/// one of its ends. What counts is the cut with the least s / (l r), for s unknowns between l and r. Unknowns
/// with the same neighbours, as the two of a node mostly are, stay together.
/// \param matrix     `n x n` compressed, symmetric pattern, both triangles
/// \param positions  `n x 2` where each unknown is [length]; empty if they are not known
/// \return each unknown once; the same tree in all units of length
/// \throws std::invalid_argument if sizes differ or the matrix is not compressed
[[nodiscard]] SeparatorTree separator_tree(const Eigen::SparseMatrix<double>& matrix,
                                           const Positions& positions = {});

}  // namespace signorini

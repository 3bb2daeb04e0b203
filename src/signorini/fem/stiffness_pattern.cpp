// # Which unknowns meet
//
// Most entries of a stiffness matrix are zero, and a sparse matrix stores only those that need not
// be. They must be known before the first number is added. Two unknowns meet where their nodes
// share a cell. In a row of two squares, the two nodes in the middle meet all six, and each other
// node meets four. With two unknowns per node the columns have 12 and 8 entries, together
//
// \f[ 4 \cdot 12 + 8 \cdot 8 = 112. \f]
//
// This file lists them, column by column.

#include <algorithm>
#include <numeric>
#include <vector>

#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The cells around every node: those of node i are cell(first(i)) to cell(first(i + 1) - 1).
///
/// The sparse matrix needs to know first which unknowns meet. They meet where their nodes share a
/// cell.
struct CellsAround {
  Eigen::ArrayX<Index> first;
  Eigen::ArrayX<Index> cell;
};

/// Two passes over the cells: one counts, one files. The second goes backwards, and so does the
/// counter of each node, which ends at the first of its places.
CellsAround cells_around(const Mesh& mesh) {
  CellsAround around{Eigen::ArrayX<Index>::Zero(mesh.n_nodes() + 1),
                     Eigen::ArrayX<Index>(mesh.cells.size())};
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (Index k = 0, n = mesh.cell_size(cell); k < n; ++k) ++around.first(mesh.cells(cell, k));
  for (Index node = 0; node < mesh.n_nodes(); ++node) around.first(node + 1) += around.first(node);
  for (Index cell = mesh.n_cells() - 1; cell >= 0; --cell)
    for (Index k = 0, n = mesh.cell_size(cell); k < n; ++k)
      around.cell(--around.first(mesh.cells(cell, k))) = cell;
  return around;
}

/// Unknowns of all nodes that share a cell with a node, rising.
std::vector<int> unknowns_around(const Mesh& mesh, const Unknowns& unknowns,
                                 const CellsAround& around, Index node) {
  std::vector<int> numbers;
  for (Index k = around.first(node); k < around.first(node + 1); ++k) {
    const Index cell = around.cell(k);
    for (Index j = 0, n = mesh.cell_size(cell); j < n; ++j)
      for (const Index number : unknowns.number.row(mesh.cells(cell, j)))
        if (number >= 0) numbers.push_back(static_cast<int>(number));
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

/// The usual way is to list all entries of all cells as triplets and let the matrix sort them. A
/// cell of four nodes has 64, and on a large mesh 36 for each node remain. Here each column is
/// written once, with its rows sorted, and the cells are then added into their places. The unknowns
/// of one node have the same rows, so that the list is kept for the second one. Where the entries of
/// a column begin is known when those before it are counted: until then they wait in lists.
Eigen::SparseMatrix<double> stiffness_pattern(const Mesh& mesh, const Unknowns& unknowns) {
  constexpr Index columns = 4096;  // of one list
  const CellsAround around = cells_around(mesh);
  Eigen::SparseMatrix<double> K(unknowns.count, unknowns.count);
  std::vector<std::vector<int>> lists(at((unknowns.count + columns - 1) / columns));
  int* const begins = K.outerIndexPtr();
  for_ranges(unknowns.count, columns, [&](Index first, Index end) {
    std::vector<int>& list = lists[at(first / columns)];
    std::vector<int> rows;
    for (Index column = first; column < end; ++column) {
      const Index node = unknowns.node_of[at(column)];
      if (column == first || node != unknowns.node_of[at(column - 1)])
        rows = unknowns_around(mesh, unknowns, around, node);
      list.insert(list.end(), rows.begin(), rows.end());
      begins[column + 1] = static_cast<int>(rows.size());
    }
  });
  std::partial_sum(begins, begins + unknowns.count + 1, begins);
  K.resizeNonZeros(begins[unknowns.count]);
  for_ranges(unknowns.count, columns, [&](Index first, Index end) {
    std::vector<int>& list = lists[at(first / columns)];
    std::copy(list.begin(), list.end(), K.innerIndexPtr() + begins[first]);
    std::fill(K.valuePtr() + begins[first], K.valuePtr() + begins[end], 0.0);
    list = {};
  });
  return K;
}

}  // namespace signorini

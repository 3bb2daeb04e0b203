/// \file
/// The tree of a Cholesky factor, column by column, of any order of elimination.
#pragma once
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <vector>

#include "addons/frontal/fronts.hpp"
#include "signorini/contact/pairs.hpp"

namespace ch21 {

using Order = std::vector<int>;  // the unknown at each place
using Sparse = Eigen::SparseMatrix<double>;

/// What the pattern says of L: no numbers yet.
struct EliminationTree {
  std::vector<int> parent;        // of each place, -1 at a root
  std::vector<int> depth;         // steps to the root
  std::vector<long long> column;  // entries of each column of L with its diagonal
  double entries = 0, operations = 0;
  int height = 0;
};

/// Eliminating a column joins all that it still has below it; the first of these is its parent.
inline EliminationTree elimination_tree(const Sparse& K, const Order& order) {
  const int n = static_cast<int>(order.size());
  EliminationTree tree{Order(order.size(), -1), Order(order.size(), 0), {}};
  tree.column.assign(order.size(), 1);
  Order place(order.size()), seen(order.size(), -1);
  for (int i = 0; i < n; ++i) place[order[i]] = i;
  for (int row = 0; row < n; ++row) {
    seen[row] = row;
    for (Sparse::InnerIterator it(K, order[row]); it; ++it)
      for (int k = place[it.row()]; k < row && seen[k] != row; k = tree.parent[k]) {
        seen[k] = row;  // L has an entry in this row and column k
        ++tree.column[k];
        if (tree.parent[k] < 0) tree.parent[k] = row;
      }
  }
  for (int k = n - 1; k >= 0; --k) {
    if (tree.parent[k] >= 0) tree.depth[k] = tree.depth[tree.parent[k]] + 1;
    tree.height = std::max(tree.height, tree.depth[k] + 1);
    tree.entries += static_cast<double>(tree.column[k]);
    tree.operations += signorini::elimination_operations(1, tree.column[k] - 1);
  }
  return tree;
}

/// \param K  symmetric \return the order of approximate minimum degree, which most libraries begin with
inline Order minimum_degree(const Sparse& K) {
  Eigen::AMDOrdering<int>::PermutationType back;
  Eigen::AMDOrdering<int>()(K, back);
  return {back.indices().data(), back.indices().data() + back.indices().size()};
}

/// \param K  symmetric \param A  rows of contacts \return an order with the unknowns that A knows last
inline Order contact_last(const Sparse& K, const signorini::NodalRows& A) {
  std::vector<bool> touches(static_cast<std::size_t>(K.cols()), false);
  for (Eigen::Index row = 0; row < A.rows(); ++row)
    for (signorini::NodalRows::InnerIterator it(A, row); it; ++it)
      touches[static_cast<std::size_t>(it.col())] = true;
  Order order, last;
  for (const int unknown : minimum_degree(K))
    (touches[static_cast<std::size_t>(unknown)] ? last : order).push_back(unknown);
  order.insert(order.end(), last.begin(), last.end());
  return order;
}

}  // namespace ch21

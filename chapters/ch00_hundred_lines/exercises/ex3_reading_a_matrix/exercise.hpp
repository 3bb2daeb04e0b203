/// \file
/// Exercise 0.3 - a matrix with a past. Do not change this file.
#pragma once
#include <Eigen/SparseCore>
#include <vector>

namespace ex0_3 {

/// What a stiffness matrix says of its body.
struct Reading {
  Eigen::Index pieces = 0;  ///< parts of the body that share no cell with each other
  std::vector<Eigen::Index>
      partners;          ///< of the node that was asked for, increasing, without itself
  bool holds_x = false;  ///< whether moving all nodes along x needs a force
  bool holds_y = false;  ///< the same along y
};

/// Reads a matrix.
/// \param K     `2n x 2n`, symmetric, in any unit [force/length]; entries that are stored may be zero
/// \param node  whose partners are asked for, from 0
/// \return what it says; a node without any entry is a piece of its own
[[nodiscard]] Reading read_matrix(const Eigen::SparseMatrix<double>& K, Eigen::Index node);

}  // namespace ex0_3

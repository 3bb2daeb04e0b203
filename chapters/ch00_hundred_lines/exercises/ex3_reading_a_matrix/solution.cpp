#include <cmath>
#include <set>

#include "exercise.hpp"

namespace ex0_3 {

namespace {

using Eigen::Index;

std::vector<std::set<Index>> partners_of(const Eigen::SparseMatrix<double>& K) {
  std::vector<std::set<Index>> partners(std::size_t(K.rows() / 2));
  for (Index column = 0; column < K.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry)
      if (entry.value() != 0) partners[std::size_t(entry.row() / 2)].insert(column / 2);
  return partners;
}

// Of all nodes that can be reached from each other.
Index pieces_of(const std::vector<std::set<Index>>& partners) {
  std::vector<bool> seen(partners.size(), false);
  Index pieces = 0;
  for (std::size_t start = 0; start < partners.size(); ++start) {
    if (seen[start]) continue;
    ++pieces;
    std::vector<std::size_t> open = {start};
    seen[start] = true;
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      for (const Index next : partners[node])
        if (!seen[std::size_t(next)]) {
          seen[std::size_t(next)] = true;
          open.push_back(std::size_t(next));
        }
    }
  }
  return pieces;
}

bool holds(const Eigen::SparseMatrix<double>& K, Index axis) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(K.rows());
  for (Index i = axis; i < K.rows(); i += 2) motion(i) = 1;
  const Eigen::VectorXd force = K * motion, terms = K.cwiseAbs() * motion;
  return (force.array().abs() > 1e-12 * terms.array()).any();
}

}  // namespace

Reading read_matrix(const Eigen::SparseMatrix<double>& K, Index node) {
  const std::vector<std::set<Index>> partners = partners_of(K);
  Reading mine{pieces_of(partners), {}, holds(K, 0), holds(K, 1)};
  for (const Index other : partners[std::size_t(node)])
    if (other != node) mine.partners.push_back(other);
  return mine;
}

}  // namespace ex0_3

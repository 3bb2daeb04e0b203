// Chapter 19 - How far an answer is from that of a much finer mesh, in energy.
#pragma once
#include <algorithm>
#include <cmath>

#include "methods.hpp"

namespace ch19 {

/// The displacement of a mesh at a place in the block, between the four nodes of its cell.
inline Eigen::Vector2d at_place(const Pressed& block, const NodeArray& u,
                                const Eigen::RowVector2d& x) {
  const Index rows = Index(std::lround(height * block.unit / rubber.youngs_modulus));
  const double size = height / double(rows);
  const Index i = std::min(Index((x(0) + width / 2) / size), 2 * rows - 1);
  const Index j = std::min(Index(x(1) / size), rows - 1);
  const double xi = 2 * ((x(0) + width / 2) / size - double(i)) - 1;
  const Shape shape = bilinear_shape(xi, 2 * (x(1) / size - double(j)) - 1);
  Eigen::Vector2d sum(0, 0);
  for (Index k = 0; k < 4; ++k)
    sum += shape.value(k) * u.row(block.mesh.cells(j * 2 * rows + i, k)).transpose();
  return sum;
}

/// A much finer mesh, and what the active set says there.
struct Reference {
  Pressed block;
  Answer answer;

  /// \param coarse  cells that are whole numbers of ours
  /// \param u       on it
  /// \return its distance from ours over the size of ours, both in energy
  [[nodiscard]] double error(const Pressed& coarse, const VectorXd& u) const {
    const NodeArray all = expand(coarse.unknowns, u);
    NodeArray here(block.mesh.n_nodes(), 2);
    for (Index node = 0; node < here.rows(); ++node)
      here.row(node) = at_place(coarse, all, block.mesh.nodes.row(node)).transpose();
    const VectorXd off = restricted(block.unknowns, here) - answer.u;
    return std::sqrt(off.dot(block.K * off) / answer.u.dot(block.K * answer.u));
  }
};

inline Reference reference(Index up) {
  Reference fine{on_round(up), {}};
  fine.answer = active_set(fine.block, compliance(fine.block));
  return fine;
}

/// The distance of an answer from another one on the same mesh, in the same measure.
inline double difference(const Pressed& block, const VectorXd& u, const VectorXd& from) {
  const VectorXd off = u - from;
  return std::sqrt(off.dot(block.K * off) / from.dot(block.K * from));
}

}  // namespace ch19

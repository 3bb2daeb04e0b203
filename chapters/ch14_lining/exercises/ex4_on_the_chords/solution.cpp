#include <stdexcept>

#include "exercise.hpp"

namespace ex14_4 {

using Eigen::Index;

Eigen::VectorXd pressures(const Eigen::MatrixX2d& position, const Eigen::MatrixX2d& force,
                          Outline outline) {
  const Index n = position.rows();
  if (force.rows() != n || n < (outline == Outline::Open ? 2 : 3))
    throw std::invalid_argument("pressures: needs two nodes or more, and a force for each");
  Eigen::MatrixX2d unit = Eigen::MatrixX2d::Zero(n, 2);  // forces of a pressure of 1
  for (Index k = 0; k < (outline == Outline::Open ? n - 1 : n); ++k) {
    const Index next = (k + 1) % n;
    const Eigen::RowVector2d side = position.row(next) - position.row(k);
    const Eigen::RowVector2d half(-side.y() / 2, side.x() / 2);  // into the body
    unit.row(k) += half;
    unit.row(next) += half;
  }
  const Eigen::VectorXd squared = unit.rowwise().squaredNorm();
  if (!(squared.array() > 0).all())
    throw std::invalid_argument("pressures: the two sides of a node cancel each other");
  return force.cwiseProduct(unit).rowwise().sum().cwiseQuotient(squared);
}

}  // namespace ex14_4

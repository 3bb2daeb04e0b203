#include "exercise.hpp"

namespace ex0_2 {

System assemble(Eigen::Index n_nodes, const std::vector<Part>& /*parts*/,
                const std::map<Eigen::Index, double>& held) {
  const Eigen::Index left = 2 * n_nodes - Eigen::Index(held.size());
  System system{Eigen::SparseMatrix<double>(left, left), Eigen::VectorXd::Zero(left)};
  // your code here: numbers of the unknowns, then all entries of all cells
  return system;
}

}  // namespace ex0_2

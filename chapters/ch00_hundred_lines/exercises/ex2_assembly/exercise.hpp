/// \file
/// Exercise 0.2 - the assembly. Do not change this file.
#pragma once
#include <Eigen/SparseCore>
#include <map>
#include <vector>

namespace ex0_2 {

/// One cell: its nodes and its matrix.
struct Part {
  std::vector<Eigen::Index> nodes;  ///< numbers from 0; one may stand twice
  Eigen::MatrixXd stiffness;  ///< x, y of the first node, then of the second, ... [force/length]
};

/// What is left of K u = p when supports are taken out.
struct System {
  Eigen::SparseMatrix<double> stiffness;  ///< both triangles, each place stored once [force/length]
  Eigen::VectorXd load;                   ///< what given displacements do to the unknowns [force]
};

/// Adds up all cells.
/// \param n_nodes  of the body
/// \param parts    its cells, in any order
/// \param held     component 2 node + axis, and the displacement that a support gives it [length]
/// \return the system of the components that are not held, in increasing order
/// \throws std::invalid_argument if a cell has a node that the body has not, or a matrix of another size, or if a
///   component is held that does not exist
[[nodiscard]] System assemble(Eigen::Index n_nodes, const std::vector<Part>& parts,
                              const std::map<Eigen::Index, double>& held);

}  // namespace ex0_2

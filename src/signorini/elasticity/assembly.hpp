/// \file
/// Stiffness matrix and load vector.
#pragma once
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/elasticity/element.hpp"
#include "signorini/elasticity/material.hpp"
#include "signorini/elasticity/unknowns.hpp"
#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// Load on one boundary: a pressure against the body plus a traction.
struct EdgeLoad {
  std::string boundary;
  double pressure = 0;   ///< against the body, normal to it [force/length^2]
  VectorField traction;  ///< (x, y) components [force/length^2]; none if empty
};

/// What acts on a body.
struct Loads {
  VectorField body_force;  ///< [force/length^3]; none if empty
  std::vector<EdgeLoad> edges;
};

/// K and p of one body or several, supports already taken out.
struct LinearSystem {
  Eigen::SparseMatrix<double> stiffness;  ///< K, both triangles [force/length]
  Eigen::VectorXd load;                   ///< p, including what given displacements cause [force]
};

/// Nodes of one cell, ready for the element functions.
[[nodiscard]] CellNodes cell_nodes(const Mesh& mesh, Eigen::Index cell);

/// Stiffness of one cell: the integral of B^T D B over its area, times the thickness [force/length].
[[nodiscard]] CellMatrix cell_stiffness(const Element& element, const CellNodes& nodes,
                                        const Eigen::Matrix3d& D, double thickness);

/// Assembles K and p of the free unknowns. \PaperEq{XuanLi2002, 12}
///
/// \throws ProblemError if the element does not fit the cells, the material is out of range, a load is
///   not finite or its boundary does not exist
[[nodiscard]] LinearSystem assemble(const Mesh& mesh, const Element& element,
                                    const Material& material, const Unknowns& unknowns,
                                    const Loads& loads);

/// Nodal forces of the loads on all nodes, held or not [force], `n_nodes x 2`.
[[nodiscard]] NodeArray nodal_loads(const Mesh& mesh, const Element& element,
                                    const Material& material, const Loads& loads);

/// Consistent share of a boundary for each of its nodes: the integral of its shape function along the
/// boundary times the thickness [length^2], in the order of boundary_nodes().
[[nodiscard]] Eigen::VectorXd boundary_weights(const Mesh& mesh, const std::string& name,
                                               double thickness);

/// Displacements of all nodes from the unknowns [length].
[[nodiscard]] NodeArray expand(const Unknowns& unknowns,
                               const Eigen::Ref<const Eigen::VectorXd>& values);

}  // namespace signorini

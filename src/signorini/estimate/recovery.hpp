/// \file
/// Smooth stresses from those of the elements, and what the two differ by: the measure of what a mesh is too coarse for.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/elasticity/cells.hpp"

namespace signorini {

/// Displacements of one body whose stresses are recovered together: the first are those of the body, as warm as it is;
/// the others are those of dual solutions, which no temperature strains.
struct Fields {
  const Mesh& mesh;                      ///< the body
  const Element& element;                ///< fits its cells
  const Matter& matter;                  ///< of its cells
  std::vector<NodeArray> displacements;  ///< `n_nodes x 2` of each field [length]
};

/// Recovered stresses. A node that several layers share has a number for each of them, and a stress for each.
struct SmoothStress {
  CellArray cells;  ///< as Mesh::cells, with these numbers
  /// A row per number: the components of the first field, as many as its D has rows, then of the second, ...
  /// [force/length^2]
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> value;
};

/// Recovers stresses node by node from the cells around it, never from another layer [\ref ZienkiewiczZhu1992].
///
/// Stresses of cells are best inside: of cells of two nodes per side their mean, taken at the middle; of those of
/// three nodes the values at the 2 x 2 points of the square, at the 3 of the triangle. A polynomial through
/// those of all cells around a corner, linear or quadratic, is fitted by least squares; the node gets what it says. Nodes
/// of the edge of a layer and midpoints of sides get the mean of what the polynomials of the corners of their cells
/// say, as far as these lie inside; where none does, as in a strip of one row of cells, the mean of the cells there.
/// \param fields  one or more
/// \return smooth stresses; exact where stresses are linear, or quadratic
/// \throws std::invalid_argument unless there is one displacement per node
/// \throws ProblemError as check_material()
[[nodiscard]] SmoothStress recovered(const Fields& fields);

/// What the stresses that the mesh has no room for do to the product of two fields, cell by cell:
///
/// \f[ E_K = \int_K (\sigma^*_u - \sigma_u)^T D^{-1} (\sigma^*_z - \sigma_z) + \sigma^*_u{}^T m_z + \sigma^*_z{}^T m_u, \f]
///
/// with the recovered stresses \f$ \sigma^* \f$ and the part m of the strain of an element that is not that of its
/// displacements: internal modes, or the mean volume of B-bar. It is what \f$ a(u, z) - a_h(u_h, z_h) \f$ is if the
/// recovered stresses are the true ones and those of u_h and z_h are in equilibrium with their loads. Of a field
/// with itself, without m, it is the square of the estimated error of the energy.
/// \param fields  u, then one or more z
/// \param stress  recovered() of them
/// \return `n_cells x n_z` [force*length]
[[nodiscard]] Eigen::MatrixXd error_products(const Fields& fields, const SmoothStress& stress);

}  // namespace signorini

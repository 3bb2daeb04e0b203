/// \file
/// Stiffness matrix and load vector.
///
/// The page that explains loads is loads.cpp, the one for the matrix assembly.cpp.
#pragma once
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/fem/cells.hpp"
#include "signorini/fem/material_field.hpp"
#include "signorini/fem/mesh.hpp"
#include "signorini/fem/places.hpp"
#include "signorini/fem/unknowns.hpp"

namespace signorini {

/// Where something is integrated along a side: points xi in [-1, 1] whose weights add up to 2.
using SideRule = std::function<std::vector<GaussPoint>(const SideCurve&)>;

/// Load on one boundary: a pressure against the body plus a traction. \PaperEq{XuanLi2002, 4}
struct EdgeLoad {
  std::string boundary;      ///< where it acts
  double pressure = 0;       ///< against the body, normal to it [force/length^2]; < 0 pulls
  VectorField traction;      ///< (x, y) components [force/length^2]; none if empty
  std::string history = {};  ///< name of what it grows with, see Path; empty: it is always there
  ScalarField share = {};    ///< how much of the pressure there is at a place [-]; empty: all of it
  SideRule rule = {};        ///< where both are integrated; empty: at three Gauss points of a side
};

/// A force at one place. At a node it acts on that node alone; elsewhere on the edge of a body it is shared
/// by the nodes of the side as their shape functions say.
struct PointForce {
  Eigen::Vector2d point;     ///< a node, or a place on the edge [length]
  Eigen::Vector2d force;     ///< (x, y) components; in axial symmetry of the whole circle [force]
  std::string history = {};  ///< name of what it grows with, see Path; empty: it is always there
};

/// What acts on a body.
struct Loads {
  VectorField body_force;               ///< [force/length^3]; none if empty
  std::vector<EdgeLoad> edges;          ///< several on one boundary add up
  std::vector<PointForce> points = {};  ///< several at one place add up
  /// Name of what the body force grows with, see Path; empty: it is always there.
  std::string body_force_history = {};
};

/// K and p of one body or several, supports already taken out.
struct LinearSystem {
  Eigen::SparseMatrix<double> stiffness;  ///< K `n x n`, both triangles [force/length]
  Eigen::VectorXd load;                   ///< p `n` [force], with what given displacements cause
};

/// Checks that an element has as many nodes as the cells it is to be used in; where quadrilaterals and triangles
/// are mixed, as the quadrilaterals.
/// \param mesh     any
/// \param element  a member of the family
/// \throws ProblemError naming both numbers if they differ
void check_element(const Mesh& mesh, const Element& element);

/// K with every entry in its place, and zero: unknowns are joined if their nodes share a cell.
/// \param mesh      the body
/// \param unknowns  `n` of it
/// \return `n x n` compressed, both triangles
[[nodiscard]] Eigen::SparseMatrix<double> stiffness_pattern(const Mesh& mesh,
                                                            const Unknowns& unknowns);

/// The element for those who name none: it bends without locking.
/// \param mesh  through check_mesh()
/// \return the name of a member of the family: t3, q4_incompatible, t6 or q8, whatever its cells need
[[nodiscard]] const char* usual_element(const Mesh& mesh);

/// Stiffness of one cell: the integral of \f$ B^T D B \f$ over its volume.
/// \param element  of the cell, `m` nodes
/// \param cell     from cell_body()
/// \return `2m x 2m`, exactly symmetric, positive semidefinite [force/length]
[[nodiscard]] CellMatrix cell_stiffness(const Element& element, const CellBody& cell);

/// Assembles K and p of the free unknowns, with eigenstrain_forces() in p. \PaperEq{XuanLi2002, 12}
/// \param mesh      the body, already through check_mesh()
/// \param element   fits its cells
/// \param material  of its cells
/// \param unknowns  `n` of the mesh; given displacements move to the right-hand side
/// \param loads     on the body
/// \return the system of the `n` unknowns
/// \throws ProblemError if the element does not fit the cells, the material is out of range, a load
///   is not finite or its boundary does not exist
[[nodiscard]] LinearSystem assemble(const Mesh& mesh, const Element& element,
                                    const MaterialField& material, const Unknowns& unknowns,
                                    const Loads& loads);

/// Where point forces act.
/// \param mesh   the body
/// \param loads  on it
/// \return the nodes that share each of them; none for a force of zero, wherever it is
/// \throws ProblemError if a force is not finite, or as place_on_edge()
[[nodiscard]] std::vector<EdgePlace> places_of(const Mesh& mesh,
                                               const std::vector<PointForce>& loads);

/// Nodal forces of the loads, consistent with the shape functions.
/// \param mesh      the body
/// \param element   fits its cells
/// \param material  whose depth multiplies the loads
/// \param loads     on the body
/// \return `n_nodes x 2` on all nodes, held or not [force]
/// \throws ProblemError if a load is not finite, its boundary does not exist, or as places_of()
[[nodiscard]] NodeArray nodal_loads(const Mesh& mesh, const Element& element,
                                    const MaterialField& material, const Loads& loads);

/// What the body's stresses do to its nodes: K u less eigenstrain_forces(), with the rows of held components.
///
/// Less the loads and the contact forces it is zero where nothing holds a node, and what the support
/// does to the body where something does.
/// \param mesh           the body
/// \param element        fits its cells
/// \param material       of its cells
/// \param displacements  `n_nodes x 2` [length]
/// \return `n_nodes x 2` [force]
/// \throws std::invalid_argument unless there is one displacement per node
[[nodiscard]] NodeArray internal_forces(const Mesh& mesh, const Element& element,
                                        const MaterialField& material,
                                        const NodeArray& displacements);

/// Consistent share of a boundary for each of its nodes: the integral of its shape function along
/// the boundary times the depth.
/// \param mesh   that has the boundary
/// \param name   of the boundary
/// \param depth  across the plane
/// \return one number per node [length^2], in the order of boundary_nodes()
/// \throws ProblemError if there is no such boundary
[[nodiscard]] Eigen::VectorXd boundary_weights(const Mesh& mesh, const std::string& name,
                                               const Depth& depth);

/// What a pressure of one does to each node of a boundary, with the sign turned round: the integral of its shape function
/// times the normal out of the body, times the depth. Its length is that of boundary_weights() where the boundary is
/// straight, and less where it turns at the node: the sides on either hand then push different ways.
/// \param mesh   that has the boundary
/// \param name   of the boundary
/// \param depth  across the plane
/// \return `n x 2` [length^2], in the order of boundary_nodes()
/// \throws ProblemError if there is no such boundary
[[nodiscard]] NodeArray boundary_areas(const Mesh& mesh, const std::string& name,
                                       const Depth& depth);

/// Nodes of a boundary on which a pressure causes no force: in axial symmetry an end of a side of three nodes on the
/// axis, whose shape function times the radius has the mean zero. What is read there as force / weight means nothing.
/// \param mesh   that has the boundary
/// \param name   of the boundary
/// \param depth  across the plane
/// \return their numbers, increasing; none in the plane, nor on straight sides of two nodes
/// \throws ProblemError if there is no such boundary
[[nodiscard]] std::vector<Eigen::Index> nodes_without_share(const Mesh& mesh,
                                                            const std::string& name,
                                                            const Depth& depth);

/// Displacements of all nodes.
/// \param unknowns  which are unknown, and what the others are held at
/// \param values    `n` unknowns u [length]
/// \return `n_nodes x 2` [length]
/// \throws std::invalid_argument unless there is one value per unknown
[[nodiscard]] NodeArray expand(const Unknowns& unknowns,
                               const Eigen::Ref<const Eigen::VectorXd>& values);

/// What the unknowns feel of forces on all nodes.
/// \param unknowns  `n` of a body
/// \param nodal     `n_nodes x 2` on its nodes, held or not [force]
/// \return `n` components that are not held [force]
[[nodiscard]] Eigen::VectorXd restricted(const Unknowns& unknowns, const NodeArray& nodal);

}  // namespace signorini

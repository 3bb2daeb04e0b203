#include "signorini/elasticity/assembly.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/mesh/side_curve.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Calls visit(nodes, N, tangent, position, weight) at the Gauss points of every side of a boundary.
template <typename Visit>
void integrate_boundary(const Mesh& mesh, const std::string& name, Visit&& visit) {
  for (const CellSide& side : boundary(mesh, name)) {
    const SideCurve curve(mesh, side);
    for (const GaussPoint& gauss : gauss_line(3))
      visit(curve.nodes(), curve.shape(gauss.xi).value, curve.tangent(gauss.xi),
            curve.point(gauss.xi).position(), gauss.weight);
  }
}

/// A curved cell can fold although its corners are in order; the map then turns over at some point.
void check_unfolded(const Mesh& mesh, const Element& element, Index cell, const CellNodes& nodes) {
  if (element.n_nodes == 4) return;  // for straight sides the corners decide, see check_mesh()
  const CellNodes arms = arms_from_middle(nodes);
  for (const GaussPoint& at : gauss_square(3))
    pose(jacobian(element.shape(at.xi, at.eta), arms).determinant > 0, "mesh '", mesh.name,
         "': cell ", cell,
         " folds over itself: move the middle nodes of its sides closer to the straight lines");
}

void add_body_force(const Mesh& mesh, const Element& element, const Eigen::Matrix3d& D,
                    double thickness, const VectorField& force, NodeArray& load) {
  StrainPoints points;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const CellNodes nodes = cell_nodes(mesh, cell);
    const CellNodes arms = arms_from_middle(nodes);
    const Eigen::RowVector2d middle = nodes.row(0) - arms.row(0);
    element.strain(arms, D, points);
    for (int i = 0; i < points.size; ++i) {
      const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
      const CellScalars N = element.shape(point.local.x(), point.local.y()).value;
      const Eigen::Vector2d position = middle.transpose() + arms.transpose() * N;
      const Eigen::Vector2d f = force(position);
      pose(f.allFinite(), "body force: not finite at (", position.x(), ", ", position.y(), ')');
      for (Index k = 0; k < element.n_nodes; ++k)
        load.row(mesh.cells(cell, k)) += thickness * point.area * N(k) * f.transpose();
    }
  }
}

void add_edge_load(const Mesh& mesh, double thickness, const EdgeLoad& edge, NodeArray& load) {
  integrate_boundary(
      mesh, edge.boundary,
      [&](const std::vector<Index>& nodes, const Eigen::Vector3d& N, const Eigen::Vector2d& tangent,
          const Eigen::Vector2d& position, double weight) {
        const Eigen::Vector2d inward(-tangent.y(), tangent.x());  // body on the left
        Eigen::Vector2d force = edge.pressure * inward;
        if (edge.traction) force += edge.traction(position) * tangent.norm();
        pose(force.allFinite(), "load on '", edge.boundary, "': not finite at (", position.x(),
             ", ", position.y(), ')');
        for (std::size_t k = 0; k < nodes.size(); ++k)
          load.row(nodes[k]) += thickness * weight * N(static_cast<Index>(k)) * force.transpose();
      });
}

/// The cells around every node: those of node i are cell(first(i)) to cell(first(i + 1) - 1).
struct CellsAround {
  Eigen::ArrayX<Index> first;
  Eigen::ArrayX<Index> cell;
};

CellsAround cells_around(const Mesh& mesh) {
  CellsAround around{Eigen::ArrayX<Index>::Zero(mesh.n_nodes() + 1),
                     Eigen::ArrayX<Index>(mesh.cells.size())};
  for (Index k = 0; k < mesh.cells.size(); ++k) ++around.first(mesh.cells.data()[k]);
  for (Index node = 0; node < mesh.n_nodes(); ++node) around.first(node + 1) += around.first(node);
  for (Index cell = mesh.n_cells() - 1; cell >= 0; --cell)
    for (Index k = 0; k < mesh.cells.cols(); ++k)
      around.cell(--around.first(mesh.cells(cell, k))) = cell;
  return around;
}

}  // namespace

CellNodes cell_nodes(const Mesh& mesh, Index cell) {
  CellNodes nodes(mesh.cells.cols(), 2);
  for (Index k = 0; k < mesh.cells.cols(); ++k) nodes.row(k) = mesh.nodes.row(mesh.cells(cell, k));
  return nodes;
}

void check_element(const Mesh& mesh, const Element& element) {
  pose(mesh.cells.cols() == element.n_nodes, "mesh '", mesh.name, "' has cells of ",
       mesh.cells.cols(), " nodes, but the element ", element.name, " needs ", element.n_nodes);
}

CellMatrix cell_stiffness(const Element& element, const CellNodes& nodes, const Eigen::Matrix3d& D,
                          double thickness) {
  StrainPoints points;
  element.strain(arms_from_middle(nodes), D, points);
  CellMatrix K = CellMatrix::Zero(2 * element.n_nodes, 2 * element.n_nodes);
  for (int i = 0; i < points.size; ++i) {
    const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
    const StrainMatrix stress = thickness * point.area * D * point.B;
    K.noalias() += point.B.transpose() * stress;
  }
  return 0.5 * (K + CellMatrix(K.transpose()));  // exactly symmetric
}

NodeArray nodal_loads(const Mesh& mesh, const Element& element, const Material& material,
                      const Loads& loads) {
  NodeArray load = NodeArray::Zero(mesh.n_nodes(), 2);
  if (loads.body_force)
    add_body_force(mesh, element, elasticity_matrix(material), material.thickness, loads.body_force,
                   load);
  for (const EdgeLoad& edge : loads.edges) add_edge_load(mesh, material.thickness, edge, load);
  return load;
}

Eigen::SparseMatrix<double> stiffness_pattern(const Mesh& mesh, const Unknowns& unknowns) {
  const CellsAround around = cells_around(mesh);
  Eigen::SparseMatrix<double> K(unknowns.count, unknowns.count);
  K.reserve(4 * mesh.cells.size() * mesh.cells.cols());  // more than enough: cells share entries
  std::vector<Index> rows;
  Index last = -1;
  for (Index column = 0; column < unknowns.count; ++column) {
    const Index node = unknowns.node_of[static_cast<std::size_t>(column)];
    if (node != last) {
      rows.clear();
      for (Index k = around.first(node); k < around.first(node + 1); ++k)
        for (const Index other : mesh.cells.row(around.cell(k)))
          for (const Index number : unknowns.number.row(other))
            if (number >= 0) rows.push_back(number);
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      last = node;
    }
    K.startVec(column);
    for (const Index row : rows) K.insertBack(row, column) = 0;
  }
  K.finalize();
  return K;
}

LinearSystem assemble(const Mesh& mesh, const Element& element, const Material& material,
                      const Unknowns& unknowns, const Loads& loads) {
  check_element(mesh, element);
  const Eigen::Matrix3d D = elasticity_matrix(material);
  const Index n_cell = 2 * element.n_nodes;
  LinearSystem system{stiffness_pattern(mesh, unknowns), {}};
  const NodeArray nodal = nodal_loads(mesh, element, material, loads);
  system.load.resize(unknowns.count);
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (unknowns.number(node, axis) >= 0)
        system.load(unknowns.number(node, axis)) = nodal(node, axis);

  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const CellNodes nodes = cell_nodes(mesh, cell);
    check_unfolded(mesh, element, cell, nodes);
    const CellMatrix K = cell_stiffness(element, nodes, D, material.thickness);
    for (Index i = 0; i < n_cell; ++i) {
      const Index row = unknowns.number(mesh.cells(cell, i / 2), i % 2);
      if (row < 0) continue;
      for (Index j = 0; j < n_cell; ++j) {
        const Index column = unknowns.number(mesh.cells(cell, j / 2), j % 2);
        if (column >= 0)
          system.stiffness.coeffRef(row, column) += K(i, j);
        else
          system.load(row) -= K(i, j) * unknowns.held(mesh.cells(cell, j / 2), j % 2);
      }
    }
  }
  return system;
}

NodeArray internal_forces(const Mesh& mesh, const Element& element, const Material& material,
                          const NodeArray& displacements) {
  require(displacements.rows() == mesh.n_nodes(), "internal_forces: need ", mesh.n_nodes(),
          " displacements (one per node), got ", displacements.rows());
  const Eigen::Matrix3d D = elasticity_matrix(material);
  NodeArray forces = NodeArray::Zero(mesh.n_nodes(), 2);
  Eigen::VectorXd u(2 * element.n_nodes);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    for (Index k = 0; k < element.n_nodes; ++k)
      u.segment<2>(2 * k) = displacements.row(mesh.cells(cell, k)).transpose();
    const Eigen::VectorXd f =
        cell_stiffness(element, cell_nodes(mesh, cell), D, material.thickness) * u;
    for (Index k = 0; k < element.n_nodes; ++k)
      forces.row(mesh.cells(cell, k)) += f.segment<2>(2 * k).transpose();
  }
  return forces;
}

Eigen::VectorXd boundary_weights(const Mesh& mesh, const std::string& name, double thickness) {
  std::map<Index, double> weight;
  integrate_boundary(
      mesh, name,
      [&](const std::vector<Index>& nodes, const Eigen::Vector3d& N, const Eigen::Vector2d& tangent,
          const Eigen::Vector2d& /*position*/, double w) {
        for (std::size_t k = 0; k < nodes.size(); ++k)
          weight[nodes[k]] += thickness * w * N(static_cast<Index>(k)) * tangent.norm();
      });
  const std::vector<Index> nodes = boundary_nodes(mesh, name);
  Eigen::VectorXd weights(static_cast<Index>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k) weights(static_cast<Index>(k)) = weight[nodes[k]];
  return weights;
}

NodeArray expand(const Unknowns& unknowns, const Eigen::Ref<const Eigen::VectorXd>& values) {
  require(values.size() == unknowns.count, "expand: need ", unknowns.count,
          " values (one per unknown), got ", values.size());
  NodeArray all = unknowns.held;
  for (Index node = 0; node < all.rows(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      if (unknowns.number(node, axis) >= 0) all(node, axis) = values(unknowns.number(node, axis));
  return all;
}

}  // namespace signorini

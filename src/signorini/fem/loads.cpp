#include <algorithm>
#include <map>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/fem/along_boundary.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {
namespace {

using Eigen::Index;

void add_body_force(const Mesh& mesh, const Element& element, const MaterialField& material,
                    const VectorField& force, NodeArray& load) {
  visit_strains(mesh, element, material, [&](const Cell& cell, const StrainPoints& points) {
    for (int i = 0; i < points.size; ++i) {
      const StrainPoint& point = points.point[static_cast<std::size_t>(i)];
      const CellScalars N = cell.element.shape(point.local.x(), point.local.y()).value;
      const Eigen::Vector2d position = cell.body.position(N);
      const Eigen::Vector2d f = force(position);
      require_input(f.allFinite(), "body force on '", mesh.name, "': not finite at (", position.x(),
                    ", ", position.y(), "), but it must be at every point of the body");
      for (Index k = 0; k < cell.element.n_nodes; ++k)
        load.row(cell.node(k)) += point.volume * N(k) * f.transpose();
    }
  });
}

void add_edge_load(const Mesh& mesh, const Depth& depth, const EdgeLoad& edge, NodeArray& load) {
  integrate_boundary(mesh, edge.boundary, [&](const BoundaryPoint& at) {
    const Eigen::Vector2d position = at.point.position();
    const Eigen::Vector2d inward(-at.tangent.y(), at.tangent.x());  // body on the left
    Eigen::Vector2d force = edge.pressure * inward;
    if (edge.traction) force += edge.traction(position) * at.tangent.norm();
    require_input(force.allFinite(), "load on '", edge.boundary, "' of '", mesh.name,
                  "': not finite at (", position.x(), ", ", position.y(),
                  "), but it must be at every point of the boundary");
    Index k = 0;
    for (const Index node : at.side.nodes())
      load.row(node) += depth.at(position.x()) * at.weight * at.N(k++) * force.transpose();
  });
}

/// The integrals of the shape functions times something along a boundary, in the order of boundary_nodes().
/// \param integrand  two numbers for a tangent, times its length
template <typename Integrand>
NodeArray boundary_integrals(const Mesh& mesh, const std::string& name, const Depth& depth,
                             const Integrand& integrand) {
  const std::vector<Index> nodes = boundary_nodes(mesh, name);
  std::map<Index, Index> number;
  for (const Index node : nodes) number.emplace(node, static_cast<Index>(number.size()));
  NodeArray sums = NodeArray::Zero(static_cast<Index>(nodes.size()), 2);
  integrate_boundary(mesh, name, [&](const BoundaryPoint& at) {
    const double share = depth.at(at.point.position().x()) * at.weight;
    Index k = 0;
    for (const Index node : at.side.nodes())
      sums.row(number.at(node)) += share * at.N(k++) * integrand(at.tangent);
  });
  return sums;
}

void add_point_forces(const Mesh& mesh, const std::vector<PointForce>& forces, NodeArray& load) {
  auto force = forces.begin();
  for (const EdgePlace& place : places_of(mesh, forces)) {
    for (std::size_t k = 0; k < place.nodes.size(); ++k)
      load.row(place.nodes[k]) += place.share(static_cast<Index>(k)) * force->force.transpose();
    ++force;
  }
}

}  // namespace

std::vector<EdgePlace> places_of(const Mesh& mesh, const std::vector<PointForce>& loads) {
  Edge edge(mesh);
  std::vector<EdgePlace> places;
  for (const PointForce& load : loads) {
    require_input(load.force.allFinite(), "point force on '", mesh.name, "' at (", load.point.x(),
                  ", ", load.point.y(), "): not finite, but its components must be numbers");
    places.push_back((load.force.array() == 0).all() ? EdgePlace{{}, {0, 0, 0}}
                                                     : edge.place(load.point));
  }
  return places;
}

NodeArray nodal_loads(const Mesh& mesh, const Element& element, const MaterialField& material,
                      const Loads& loads) {
  NodeArray load = NodeArray::Zero(mesh.n_nodes(), 2);
  if (loads.body_force) add_body_force(mesh, element, material, loads.body_force, load);
  for (const EdgeLoad& edge : loads.edges) add_edge_load(mesh, depth_of(material), edge, load);
  add_point_forces(mesh, loads.points, load);
  return load;
}

Eigen::VectorXd boundary_weights(const Mesh& mesh, const std::string& name, const Depth& depth) {
  return boundary_integrals(
             mesh, name, depth,
             [](const Eigen::Vector2d& tangent) { return Eigen::RowVector2d(tangent.norm(), 0); })
      .col(0);
}

NodeArray boundary_areas(const Mesh& mesh, const std::string& name, const Depth& depth) {
  return boundary_integrals(mesh, name, depth, [](const Eigen::Vector2d& tangent) {
    return Eigen::RowVector2d(tangent.y(), -tangent.x());
  });
}

std::vector<Index> nodes_without_share(const Mesh& mesh, const std::string& name,
                                       const Depth& depth) {
  std::vector<Index> nodes;
  if (!depth.axial) return nodes;
  const std::vector<Index> axis = axis_nodes(mesh);
  for (const CellSide& side : boundary(mesh, name)) {
    const std::vector<Index> own = mesh.side_nodes(side);
    if (own.size() == 2) continue;
    for (const Index end : {own.front(), own.back()})
      if (std::binary_search(axis.begin(), axis.end(), end)) nodes.push_back(end);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace signorini

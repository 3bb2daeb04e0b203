// # Loads, shared out to the nodes
//
// A load does the work \f$\int b\cdot u\,dV + \int t\cdot u\,d\Gamma\f$ on a displacement. Forces
// on nodes that do the same work on every \f$u = \sum_k N_k u_k\f$ are *consistent*:
//
// \f[ p_k = \int N_k\,b\,dV + \int N_k\,t\,d\Gamma. \f]
//
// A pressure of 1 on a straight edge of length 6 and depth 1 acts on three nodes, which are
// equally far apart, as 1.5, 3, 1.5 if two sides of two nodes lie there, and as 1, 4, 1 if they
// are one side of three nodes. Had the three nodes been given 2 each, the sum would be right and
// the stress below them would not be uniform, on any mesh.
//
// With a tangent \f$x' = dx/d\xi\f$ along the side, and the body on the left of it,
// \f$(-x'_y,\ x'_x)\f$ points into the body, and its length is that of \f$x'\f$. So a pressure
// needs neither a unit normal nor a length. Three Gauss points are exact for polynomials of degree
// 5: a parabola for \f$N\f$, degree 1 for \f$x'\f$ on a curved side, and on a body of revolution
// degree 2 for the radius.

#include <algorithm>
#include <map>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/fem/along_boundary.hpp"
#include "signorini/fem/assembly.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The points are those of the stiffness. They are exact for a weight that is constant in the cell,
/// if its sides are straight. For a force that varies more, the error is one of the mesh, as others
/// are. A function that users write may return anything, so each value is checked.
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

/// A load that varies brings a rule of its own, which ends pieces where the load has a kink or a jump: a Gauss rule across one is
/// wrong by the square of the length of the side, or by the length itself.
void add_edge_load(const Mesh& mesh, const Depth& depth, const EdgeLoad& edge, NodeArray& load) {
  integrate_boundary(
      mesh, edge.boundary,
      [&](const BoundaryPoint& at) {
        const Eigen::Vector2d position = at.point.position();
        const Eigen::Vector2d inward(-at.tangent.y(), at.tangent.x());  // body on the left
        Eigen::Vector2d force = edge.pressure * inward;
        if (edge.share) force *= edge.share(position);
        if (edge.traction) force += edge.traction(position) * at.tangent.norm();
        require_input(force.allFinite(), "load on '", edge.boundary, "' of '", mesh.name,
                      "': not finite at (", position.x(), ", ", position.y(),
                      "), but it must be at every point of the boundary");
        Index k = 0;
        for (const Index node : at.side.nodes())
          load.row(node) += depth.at(position.x()) * at.weight * at.N(k++) * force.transpose();
      },
      edge.rule);
}

/// The integrals of the shape functions times something along a boundary, in the order of
/// boundary_nodes().
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

/// On the edge between two nodes the shape functions share a force out, as a narrow pressure would
/// be.
void add_point_forces(const Mesh& mesh, const std::vector<PointForce>& forces, NodeArray& load) {
  auto force = forces.begin();
  for (const EdgePlace& place : places_of(mesh, forces)) {
    for (std::size_t k = 0; k < place.nodes.size(); ++k)
      load.row(place.nodes[k]) += place.share(static_cast<Index>(k)) * force->force.transpose();
    ++force;
  }
}

}  // namespace

/// One Edge for all forces: it looks for the outer sides of the mesh only once.
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

/// A force that is zero may stand anywhere: a user who switches one off need not take it out.
NodeArray nodal_loads(const Mesh& mesh, const Element& element, const MaterialField& material,
                      const Loads& loads) {
  NodeArray load = NodeArray::Zero(mesh.n_nodes(), 2);
  if (loads.body_force) add_body_force(mesh, element, material, loads.body_force, load);
  for (const EdgeLoad& edge : loads.edges) add_edge_load(mesh, depth_of(material), edge, load);
  add_point_forces(mesh, loads.points, load);
  return load;
}

/// Contact reads the same integrals backwards. It finds forces and divides them by the shares
/// \f$w_k = \int N_k\,d\Gamma\f$ to print pressures. Around the corner of a unit square, with both
/// sides in one boundary, the corner node has the share \f$\tfrac12 + \tfrac12 = 1\f$. A uniform
/// pressure pushes there along the diagonal, with \f$\lvert(\tfrac12, -\tfrac12)\rvert = 0.71\f$:
/// boundary_areas() keeps the direction.
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

/// On a body of revolution the share is \f$2\pi\int N_k\,x\,dx\f$. For a side of length 1 that
/// begins on the axis it is \f$2\pi\f$ times (1/6, 1/3) with two nodes, and \f$2\pi\f$ times (0,
/// 1/3, 1/6) with three. The node on the axis has no share there: a pressure does not push it, and
/// a pair on it would have none.
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

// # Supports and unknowns
//
// A node has two components, and each is either given or unknown. Unknowns are numbered node by
// node, first \f$x\f$ and then \f$y\f$, and held components get \f$-1\f$. On the block of 2 x 1
// cells with its left side fixed, four of six nodes are free, and there are eight unknowns.
//
// Leaving held components out is more work than keeping them, and worth it. The matrix is smaller
// and positive definite, its entries are all stiffnesses, and a given displacement is met to the
// last bit. With a penalty, a spring that is stiffer by \f$10^{6}\f$, it would be met to six
// digits only.
//
// Two supports may meet at a corner. If both give the same component the same value, they agree.
// If not, the user has to decide, since the order of the supports should not.

#include "signorini/fem/unknowns.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/places.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// The axis across a straight, axis-parallel boundary.
///
/// "Symmetric" means: no displacement across the line, no force along it. For a line that is
/// inclined this would couple the two components of each node, and there would be no component to
/// leave out.
Axis normal_axis(const Mesh& mesh, const std::string& name) {
  const NodeArray x = mesh.nodes(boundary_nodes(mesh, name), Eigen::all);
  const Eigen::RowVector2d extent = x.colwise().maxCoeff() - x.colwise().minCoeff();
  const double flat = 1e3 * epsilon * mesh.nodes.cwiseAbs().maxCoeff();
  require_input(extent.minCoeff() <= flat && extent.maxCoeff() > flat, "support 'symmetric' on '",
                name, "': the boundary must be straight and parallel to an axis, but it spans ",
                extent.x(), " x ", extent.y());
  // An upright line has no extent in x, and x is what it holds.
  return extent.x() < extent.y() ? Axis::X : Axis::Y;
}

/// Holds the nodes of a support where it says; another support, or the axis, must not say
/// otherwise.
///
/// A component that is held already must be given the same value. On a body of revolution the axis
/// is such a support, which the user has not written: nothing moves away from it, \f$u_x = 0\f$.
void hold(const Mesh& mesh, const Support& support, const std::vector<Index>& on_axis,
          Unknowns& unknowns) {
  const auto require_support = [&](bool right, const auto&... fault) {
    require_input(right, "support on '", support.boundary, "': ", fault...);
  };
  // A symmetric support learns from the mesh which of the two it holds.
  bool held[2] = {support.holds_x, support.holds_y};
  if (support.normal_only) held[normal_axis(mesh, support.boundary) == Axis::X ? 0 : 1] = true;
  require_support(static_cast<bool>(support.displacement),
                  "has no displacement; make it with fixed, symmetric or prescribed");
  for (const Index node : nodes_at(mesh, support.boundary, support.only_at, "support")) {
    const Eigen::Vector2d value = support.displacement(mesh.nodes.row(node).transpose());
    for (int axis = 0; axis < 2; ++axis) {
      if (!held[axis]) continue;
      require_support(std::isfinite(value(axis)), "the displacement given at node ", node,
                      " is not finite, but it must be a number at every node");
      // The message tells who else holds the node, so that the user knows what to take out.
      const bool by_axis = axis == 0 && std::binary_search(on_axis.begin(), on_axis.end(), node);
      require_support(unknowns.number(node, axis) == 0 || unknowns.held(node, axis) == value(axis),
                      "the node at (", mesh.nodes(node, 0), ", ", mesh.nodes(node, 1), ") gets the displacement ", value(axis), " in direction ",
                      axis == 0 ? 'x' : 'y',
                      by_axis ? ", but it lies on the axis of the body, which gives it "
                              : ", but another support gives it ",
                      unknowns.held(node, axis), ": leave one of them out");
      unknowns.number(node, axis) = -1;
      unknowns.held(node, axis) = value(axis);
    }
  }
}

}  // namespace

/// Makers with names say what is meant: fixed, symmetric, prescribed. All of them fill the same
/// struct.
Support fixed(const std::string& boundary) {
  return {boundary, true, true, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); },
          false};
}

/// Which component is held is decided later, from the mesh: a boundary that is upright holds
/// \f$x\f$.
Support symmetric(const std::string& boundary) {
  return {boundary, false, false, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); },
          true};
}

/// The function gets a place, so that a rigid tool that turns is prescribed in one line.
Support prescribed(const std::string& boundary, Axis axis, const ScalarField& displacement) {
  return {boundary, axis == Axis::X, axis == Axis::Y,
          [displacement](const Eigen::Vector2d& x) {
            return Eigen::Vector2d::Constant(displacement(x)).eval();
          },
          false};
}

/// Settlements and strokes are usually the same along a boundary.
Support prescribed(const std::string& boundary, Axis axis, double displacement) {
  return prescribed(boundary, axis,
                    [displacement](const Eigen::Vector2d&) { return displacement; });
}

/// One node and one component: the last motion of a body is often held like this. With one
/// component such a support carries no force if the loads balance.
Support prescribed_at(const std::string& boundary, const Eigen::Vector2d& point, Axis axis,
                      double displacement) {
  Support support = prescribed(boundary, axis, displacement);
  support.only_at = point;
  return support;
}

/// Numbers of unknowns mean nothing outside of this program. Messages speak of nodes, places and
/// directions.
std::string Unknowns::describe(const Mesh& mesh, Index unknown) const {
  const Index node = node_of[at(unknown)];
  return text("node ", node, " at (", mesh.nodes(node, 0), ", ", mesh.nodes(node, 1),
              "), direction ", number(node, 0) == unknown ? 'x' : 'y');
}

/// For those who order unknowns by where they are, as nested dissection does.
NodeArray unknown_positions(const Mesh& mesh, const Unknowns& unknowns) {
  NodeArray positions(unknowns.count, 2);
  for (Index k = 0; k < unknowns.count; ++k)
    positions.row(k) = mesh.nodes.row(unknowns.node_of[at(k)]);
  return positions;
}

/// The mesh of a body of revolution is one half of its cross-section. A node at negative radius
/// means that the other half was drawn as well, and its volume would be negative.
std::vector<Index> axis_nodes(const Mesh& mesh) {
  // Generators compute a radius of zero as a sum or a cosine.
  const double rounding = 1e3 * epsilon * mesh.nodes.col(0).cwiseAbs().maxCoeff();
  std::vector<Index> nodes;
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const double radius = mesh.nodes(node, 0);
    require_input(
        radius >= -rounding, "mesh '", mesh.name, "': node ", node, " lies at (", radius, ", ",
        mesh.nodes(node, 1),
        "), but in axial symmetry x is the radius: take the half of the cross-section with x >= 0");
    if (radius <= rounding) nodes.push_back(node);
  }
  return nodes;
}

/// Two passes: first -1 for all that is held, then numbers for the rest, in the order of nodes.
/// Unknowns of one node are neighbours then, which keeps the columns of the stiffness alike in
/// pairs.
Unknowns number_unknowns(const Mesh& mesh, const std::vector<Support>& supports, PlaneState state) {
  Unknowns unknowns;
  unknowns.number.setZero(mesh.n_nodes(), 2);
  unknowns.held.setZero(mesh.n_nodes(), 2);
  std::vector<Index> on_axis;
  if (state == PlaneState::Axial) on_axis = axis_nodes(mesh);
  for (const Index node : on_axis) unknowns.number(node, 0) = -1;
  for (const Support& support : supports) hold(mesh, support, on_axis, unknowns);
  // Zero was the mark of what is free; it becomes a number now.
  const Index free = (unknowns.number >= 0).count();
  unknowns.node_of.reserve(at(free));
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (int axis = 0; axis < 2; ++axis) {
      if (unknowns.number(node, axis) < 0) continue;
      unknowns.number(node, axis) = unknowns.count++;
      unknowns.node_of.push_back(static_cast<int>(node));
    }
  return unknowns;
}

/// Bodies are numbered one after the other. Their stiffnesses are blocks on the diagonal, and
/// nothing but contact couples them.
Unknowns joined(const std::vector<const Unknowns*>& bodies) {
  Unknowns all;
  Index n_nodes = 0;
  Index n_unknowns = 0;
  for (const Unknowns* body : bodies) {
    n_nodes += body->number.rows();
    n_unknowns += body->count;
  }
  all.node_of.reserve(at(n_unknowns));
  all.number.resize(n_nodes, 2);
  all.held.resize(n_nodes, 2);
  Index first = 0;
  for (const Unknowns* body : bodies) {
    const Index rows = body->number.rows();
    // Held components stay at -1, all others count on from the bodies before.
    all.number.middleRows(first, rows) = (body->number < 0).select(-1, body->number + all.count);
    all.held.middleRows(first, rows) = body->held;
    for (const int node : body->node_of) all.node_of.push_back(static_cast<int>(first) + node);
    all.count += body->count;
    first += rows;
  }
  return all;
}

}  // namespace signorini

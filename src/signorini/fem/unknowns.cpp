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
Axis normal_axis(const Mesh& mesh, const std::string& name) {
  const std::vector<Index> nodes = boundary_nodes(mesh, name);
  Eigen::RowVector2d low = mesh.nodes.row(nodes.front());
  Eigen::RowVector2d high = low;
  for (const Index node : nodes) {
    low = low.cwiseMin(mesh.nodes.row(node));
    high = high.cwiseMax(mesh.nodes.row(node));
  }
  const Eigen::RowVector2d extent = high - low;
  const double flat = 1e3 * epsilon * mesh.nodes.cwiseAbs().maxCoeff();
  require_input(extent.minCoeff() <= flat && extent.maxCoeff() > flat, "support 'symmetric' on '",
                name, "': the boundary must be straight and parallel to an axis, but it spans ",
                extent.x(), " x ", extent.y());
  return extent.x() < extent.y() ? Axis::X : Axis::Y;
}

/// Holds the nodes of a support where it says; another support, or the axis, must not say otherwise.
void hold(const Mesh& mesh, const Support& support, const std::vector<Index>& on_axis,
          Unknowns& unknowns) {
  const auto require_support = [&](bool right, const auto&... fault) {
    require_input(right, "support on '", support.boundary, "': ", fault...);
  };
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
      const bool by_axis = axis == 0 && std::binary_search(on_axis.begin(), on_axis.end(), node);
      require_support(unknowns.number(node, axis) == 0 || unknowns.held(node, axis) == value(axis),
                      "node ", node, " gets the displacement ", value(axis), " in direction ",
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

Support fixed(const std::string& boundary) {
  return {boundary, true, true, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); },
          false};
}

Support symmetric(const std::string& boundary) {
  return {boundary, false, false, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0); },
          true};
}

Support prescribed(const std::string& boundary, Axis axis, const ScalarField& displacement) {
  return {boundary, axis == Axis::X, axis == Axis::Y,
          [displacement](const Eigen::Vector2d& x) {
            return Eigen::Vector2d::Constant(displacement(x)).eval();
          },
          false};
}

Support prescribed(const std::string& boundary, Axis axis, double displacement) {
  return prescribed(boundary, axis,
                    [displacement](const Eigen::Vector2d&) { return displacement; });
}

Support prescribed_at(const std::string& boundary, const Eigen::Vector2d& point, Axis axis,
                      double displacement) {
  Support support = prescribed(boundary, axis, displacement);
  support.only_at = point;
  return support;
}

std::string Unknowns::describe(const Mesh& mesh, Index unknown) const {
  const Index node = node_of[static_cast<std::size_t>(unknown)];
  return text("node ", node, " at (", mesh.nodes(node, 0), ", ", mesh.nodes(node, 1),
              "), direction ", number(node, 0) == unknown ? 'x' : 'y');
}

NodeArray unknown_positions(const Mesh& mesh, const Unknowns& unknowns) {
  NodeArray positions(unknowns.count, 2);
  for (Index k = 0; k < unknowns.count; ++k)
    positions.row(k) = mesh.nodes.row(unknowns.node_of[static_cast<std::size_t>(k)]);
  return positions;
}

std::vector<Index> axis_nodes(const Mesh& mesh) {
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

Unknowns number_unknowns(const Mesh& mesh, const std::vector<Support>& supports, PlaneState state) {
  Unknowns unknowns;
  unknowns.number.setZero(mesh.n_nodes(), 2);
  unknowns.held.setZero(mesh.n_nodes(), 2);
  std::vector<Index> on_axis;
  if (state == PlaneState::Axial) on_axis = axis_nodes(mesh);
  for (const Index node : on_axis) unknowns.number(node, 0) = -1;
  for (const Support& support : supports) hold(mesh, support, on_axis, unknowns);
  const Index free = (unknowns.number >= 0).count();
  unknowns.node_of.reserve(at(free));
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (int axis = 0; axis < 2; ++axis) {
      if (unknowns.number(node, axis) < 0) continue;
      unknowns.number(node, axis) = unknowns.count++;
      unknowns.node_of.push_back(node);
    }
  return unknowns;
}

Unknowns joined(const std::vector<Unknowns>& bodies) {
  Unknowns all;
  Index n_nodes = 0;
  Index n_unknowns = 0;
  for (const Unknowns& body : bodies) {
    n_nodes += body.number.rows();
    n_unknowns += body.count;
  }
  all.node_of.reserve(static_cast<std::size_t>(n_unknowns));
  all.number.resize(n_nodes, 2);
  all.held.resize(n_nodes, 2);
  Index first = 0;
  for (const Unknowns& body : bodies) {
    const Index rows = body.number.rows();
    all.number.middleRows(first, rows) = (body.number < 0).select(-1, body.number + all.count);
    all.held.middleRows(first, rows) = body.held;
    for (const Index node : body.node_of) all.node_of.push_back(first + node);
    all.count += body.count;
    first += rows;
  }
  return all;
}

}  // namespace signorini

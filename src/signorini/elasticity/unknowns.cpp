#include "signorini/elasticity/unknowns.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "signorini/core/errors.hpp"

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
  const double flat =
      1e3 * std::numeric_limits<double>::epsilon() * mesh.nodes.cwiseAbs().maxCoeff();
  pose(extent.minCoeff() <= flat && extent.maxCoeff() > flat, "support 'symmetric' on '", name,
       "': the boundary must be straight and parallel to an axis, but it spans ", extent.x(), " x ",
       extent.y());
  return extent.x() < extent.y() ? Axis::X : Axis::Y;
}

/// The nodes that a support is about.
std::vector<Index> supported_nodes(const Mesh& mesh, const Support& support) {
  std::vector<Index> nodes = boundary_nodes(mesh, support.boundary);
  if (!support.only_at) return nodes;
  const Eigen::RowVector2d point = support.only_at->transpose();
  const auto distance = [&](Index node) { return (mesh.nodes.row(node) - point).norm(); };
  const Index nearest = *std::min_element(
      nodes.begin(), nodes.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
  const double rounding =
      1e3 * std::numeric_limits<double>::epsilon() * mesh.nodes.cwiseAbs().maxCoeff();
  pose(distance(nearest) <= rounding, "support on '", support.boundary, "': no node lies at (",
       point.x(), ", ", point.y(), "); the nearest, node ", nearest, ", lies at (",
       mesh.nodes(nearest, 0), ", ", mesh.nodes(nearest, 1), ')');
  return {nearest};
}

/// Numbers the connected bodies of a mesh; returns the body of every node.
std::vector<Index> body_of_nodes(const Mesh& mesh) {
  std::vector<Index> parent(static_cast<std::size_t>(mesh.n_nodes()));
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&parent](Index node) {
    while (parent[static_cast<std::size_t>(node)] != node) {
      Index& up = parent[static_cast<std::size_t>(node)];
      up = parent[static_cast<std::size_t>(up)];
      node = up;
    }
    return node;
  };
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (Index k = 1; k < mesh.cells.cols(); ++k)
      parent[static_cast<std::size_t>(root(mesh.cells(cell, k)))] = root(mesh.cells(cell, 0));
  std::vector<Index> body(parent.size());
  for (std::size_t node = 0; node < parent.size(); ++node)
    body[node] = root(static_cast<Index>(node));
  return body;
}

/// Says in words what the rigid motion (a, b, c) does: translation (a, b) and rotation c about `centre`.
std::string motion_in_words(const Eigen::Vector3d& motion, const Eigen::Vector2d& centre) {
  constexpr double visible = 1e-6;
  const bool x = std::abs(motion(0)) > visible;
  const bool y = std::abs(motion(1)) > visible;
  if (std::abs(motion(2)) > visible) {
    const double pivot_x = centre.x() - motion(1) / motion(2);
    const double pivot_y = centre.y() + motion(0) / motion(2);
    return text("turn freely about (", pivot_x, ", ", pivot_y, ')');
  }
  if (x && y) return text("move freely in direction (", motion(0), ", ", motion(1), ')');
  return x ? "move freely in direction x" : "move freely in direction y";
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

Unknowns number_unknowns(const Mesh& mesh, const std::vector<Support>& supports) {
  Unknowns unknowns;
  unknowns.number.setZero(mesh.n_nodes(), 2);
  unknowns.held.setZero(mesh.n_nodes(), 2);
  for (const Support& support : supports) {
    bool held[2] = {support.holds_x, support.holds_y};
    if (support.normal_only) held[normal_axis(mesh, support.boundary) == Axis::X ? 0 : 1] = true;
    pose(static_cast<bool>(support.displacement), "support on '", support.boundary,
         "': has no displacement; make it with fixed, symmetric or prescribed");
    for (const Index node : supported_nodes(mesh, support)) {
      const Eigen::Vector2d value = support.displacement(mesh.nodes.row(node).transpose());
      for (int axis = 0; axis < 2; ++axis) {
        if (!held[axis]) continue;
        pose(std::isfinite(value(axis)), "support on '", support.boundary,
             "': the displacement given at node ", node, " is not finite");
        pose(unknowns.number(node, axis) == 0 || unknowns.held(node, axis) == value(axis),
             "support on '", support.boundary, "': node ", node, " gets the displacement ",
             value(axis), " in direction ", axis == 0 ? 'x' : 'y',
             ", but another support gives it ", unknowns.held(node, axis));
        unknowns.number(node, axis) = -1;
        unknowns.held(node, axis) = value(axis);
      }
    }
  }
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    for (int axis = 0; axis < 2; ++axis) {
      if (unknowns.number(node, axis) < 0) continue;
      unknowns.number(node, axis) = unknowns.count++;
      unknowns.node_of.push_back(node);
    }
  return unknowns;
}

std::vector<std::string> free_motions(const Mesh& mesh, const Unknowns& unknowns) {
  const std::vector<Index> body = body_of_nodes(mesh);
  std::vector<std::string> found;
  for (Index first = 0; first < mesh.n_nodes(); ++first) {
    if (body[static_cast<std::size_t>(first)] != first) continue;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d low = mesh.nodes.row(first).transpose();
    Eigen::Vector2d high = low;
    double members = 0;
    for (Index node = 0; node < mesh.n_nodes(); ++node) {
      if (body[static_cast<std::size_t>(node)] != first) continue;
      const Eigen::Vector2d x = mesh.nodes.row(node).transpose();
      centre += x;
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      ++members;
    }
    if (members < 2) continue;  // a node that belongs to no cell
    centre /= members;
    const double size = (high - low).norm();
    // A rigid motion (a, b, c) moves x by (a - c (y - y0), b + c (x - x0)); held components forbid it.
    Eigen::Matrix3d forbidden = Eigen::Matrix3d::Zero();
    for (Index node = 0; node < mesh.n_nodes(); ++node) {
      if (body[static_cast<std::size_t>(node)] != first) continue;
      const Eigen::Vector2d arm = (mesh.nodes.row(node).transpose() - centre) / size;
      const Eigen::Vector3d in_x(1, 0, -arm.y());
      const Eigen::Vector3d in_y(0, 1, arm.x());
      if (unknowns.number(node, 0) < 0) forbidden += in_x * in_x.transpose();
      if (unknowns.number(node, 1) < 0) forbidden += in_y * in_y.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(forbidden);
    const double none =
        16 * std::numeric_limits<double>::epsilon() * std::max(1.0, forbidden.trace());
    std::string motions;
    for (int k = 0; k < 3; ++k) {
      if (modes.eigenvalues()(k) > none) continue;
      Eigen::Vector3d motion = modes.eigenvectors().col(k);
      motion(2) /= size;
      motion /= std::max(motion.head<2>().norm(), std::abs(motion(2)) * size);
      motions += (motions.empty() ? "" : " and ") + motion_in_words(motion, centre);
    }
    Index cells = 0;
    for (Index cell = 0; cell < mesh.n_cells(); ++cell)
      cells += body[static_cast<std::size_t>(mesh.cells(cell, 0))] == first ? 1 : 0;
    if (!motions.empty())
      found.push_back(text("body '", mesh.name, "' (", cells, " cells around (", centre.x(), ", ",
                           centre.y(), ")) can ", motions));
  }
  return found;
}

}  // namespace signorini

// # Places named by where they are
//
// Node numbers belong to a mesh, and a finer mesh has others. A scene says "hold the point (0, 5)"
// or "press at (3, 0)", and means it on any mesh. Hence two rules: a position finds its node up to
// rounding, and a position that finds none is an error, never the nearest node. To snap to the
// nearest one is what many programs do; it moves a load by half a cell, and the result still looks
// right.
//
// How much is rounding? A user types decimals, and a generator multiplies radii with cosines. A
// few roundings of the largest coordinate lie between the two. We allow a thousand: on a mesh that
// reaches to 10 that is \f$2\cdot10^{-12}\f$. No cell is so small.

#include "signorini/fem/places.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/joints.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// How far positions that mean the same place may lie apart.
double position_rounding(const Mesh& mesh) {
  return 1e3 * epsilon * mesh.nodes.cwiseAbs().maxCoeff();
}

double distance(const Mesh& mesh, Index node, const Vector2d& point) {
  return (mesh.nodes.row(node).transpose() - point).norm();
}

/// The nearest node is for messages only. Of two that are equally near it is the first in the list.
Index nearest(const Mesh& mesh, const std::vector<Index>& nodes, const Vector2d& point) {
  return *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) {
    return distance(mesh, a, point) < distance(mesh, b, point);
  });
}

std::string describe(const Mesh& mesh, Index node) {
  return text("node ", node, ", lies at (", mesh.nodes(node, 0), ", ", mesh.nodes(node, 1), ')');
}

}  // namespace

/// A message that names the nearest node tells at once whether the place was mistyped or the mesh
/// has no node where one is needed.
std::vector<Index> nodes_at(const Mesh& mesh, const std::string& boundary,
                            const std::optional<Vector2d>& only_at, const std::string& what) {
  std::vector<Index> nodes = boundary_nodes(mesh, boundary);
  if (!only_at) return nodes;
  const Index found = nearest(mesh, nodes, *only_at);
  require_input(distance(mesh, found, *only_at) <= position_rounding(mesh), what, " on '", boundary,
                "': no node lies at (", only_at->x(), ", ", only_at->y(), "); the nearest, ",
                describe(mesh, found));
  return {found};
}

/// For one place. Whoever has several keeps an Edge, which finds the outer sides once.
EdgePlace place_on_edge(const Mesh& mesh, const Vector2d& point) { return Edge(mesh).place(point); }

Edge::Edge(const Mesh& mesh) : mesh_(mesh) {}

/// First nodes, then sides. If two nodes lie there and are not joined, as on a cut, a force acts on
/// one of two faces that move apart, and only the user knows on which.
EdgePlace Edge::place(const Vector2d& point) {
  const double rounding = position_rounding(mesh_);
  const std::string at = text("point (", point.x(), ", ", point.y(), ") of '", mesh_.name, "': ");
  require_input(point.allFinite(), at,
                "is not finite; give the place of a node, or one on the edge");
  std::vector<Index> nodes;
  for (Index node = 0; node < mesh_.n_nodes(); ++node)
    if (distance(mesh_, node, point) <= rounding) nodes.push_back(node);
  require_input(nodes.size() <= 1, at, "nodes ", nodes.empty() ? 0 : nodes.front(), " and ",
                nodes.empty() ? 0 : nodes.back(),
                " both lie there and are not joined. Choose a place beside them");
  // A node takes the whole force, also inside of the body, where there is no side to share it.
  if (!nodes.empty()) return {std::move(nodes), {1, 0, 0}};

  // On a side the shape functions say what each node gets. In the middle of a straight side of two
  // nodes that is half and half. Inside of a cell there is no answer but an error: a load there
  // needs a node.
  if (sides_.empty())
    for (const CellSide& side : outer_sides(mesh_)) sides_.emplace_back(mesh_, side);
  std::vector<EdgePlace> places;
  for (const SideCurve& side : sides_) {
    const double xi = side.closest(point);
    // A point is on a side if the closest place of the side is the point itself.
    if ((side.point(xi) - point).norm() <= rounding)
      places.push_back({side.nodes(), side.shape(xi).value});
  }
  require_input(places.size() <= 1, at,
                "lies on two sides that are not joined. Choose another place");
  if (!places.empty()) return places.front();
  nodes.resize(static_cast<std::size_t>(mesh_.n_nodes()));
  std::iota(nodes.begin(), nodes.end(), Index{0});
  const Index close = nearest(mesh_, nodes, point);
  throw ProblemError(text(at, "neither a node nor a place on the edge. The nearest, ",
                          describe(mesh_, close), ", ", distance(mesh_, close, point), " away"));
}

}  // namespace signorini

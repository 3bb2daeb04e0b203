#include "signorini/fem/places.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/joints.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// How far positions that mean the same place may lie apart.
double position_rounding(const Mesh& mesh) {
  return 1e3 * epsilon * mesh.nodes.cwiseAbs().maxCoeff();
}

double distance(const Mesh& mesh, Index node, const Vector2d& point) {
  return (mesh.nodes.row(node).transpose() - point).norm();
}

Index nearest(const Mesh& mesh, const std::vector<Index>& nodes, const Vector2d& point) {
  return *std::min_element(nodes.begin(), nodes.end(), [&](Index a, Index b) {
    return distance(mesh, a, point) < distance(mesh, b, point);
  });
}

std::string describe(const Mesh& mesh, Index node) {
  return text("node ", node, ", lies at (", mesh.nodes(node, 0), ", ", mesh.nodes(node, 1), ')');
}

}  // namespace

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

EdgePlace place_on_edge(const Mesh& mesh, const Vector2d& point) { return Edge(mesh).place(point); }

Edge::Edge(const Mesh& mesh) : mesh_(mesh) {}

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
  if (!nodes.empty()) return {std::move(nodes), {1, 0, 0}};

  if (sides_.empty())
    for (const CellSide& side : outer_sides(mesh_)) sides_.emplace_back(mesh_, side);
  std::vector<EdgePlace> places;
  for (const SideCurve& side : sides_) {
    const double xi = side.closest(point);
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

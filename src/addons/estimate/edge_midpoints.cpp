#include "addons/estimate/edge_midpoints.hpp"

#include <utility>

#include "addons/estimate/outline_shape.hpp"
#include "signorini/core/index.hpp"
#include "signorini/fem/side_curve.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

EdgeMidpoints::EdgeMidpoints(const Mesh& mesh, const MeshEdges& edges, std::vector<char> halved)
    : mesh_(mesh),
      edges_(edges),
      halved_(std::move(halved)),
      on_(edges.size(), {-1, -1, -1}),
      nodes_(mesh.nodes) {
  const bool quadratic = mesh.order() == MeshOrder::Quadratic;
  Index next = mesh.n_nodes();
  for (std::size_t e = 0; e < on_.size(); ++e) {
    if (halved_[e] == 0) continue;
    on_[e][1] = quadratic ? mesh.side_nodes(edges.sides[e][0])[1] : next++;
    if (quadratic) on_[e][0] = next++;
    if (quadratic) on_[e][2] = next++;
  }
  nodes_.conservativeResize(next, 2);
  for (std::size_t e = 0; e < on_.size(); ++e) {
    if (halved_[e] == 0) continue;
    const SideCurve curve(mesh, edges.sides[e][0]);
    visit_new(static_cast<Index>(e), [&](Index number, Index, Index, double xi) {
      nodes_.row(number) = curve.point(xi).position();
    });
  }
  const OutlineShape shape(mesh);
  std::vector<char> done(on_.size(), 0);
  for (std::size_t e = 0; e < on_.size(); ++e) {
    if (halved_[e] == 0 || done[e] != 0 || edges.sides[e][1].cell >= 0) continue;
    const std::vector<Walked> line = line_from(static_cast<Index>(e));
    done[at(line.back().edge)] = 1;
    bend(line, off(line.front(), shape), off(line.back(), shape));
  }
}

Index EdgeMidpoints::node(const CellSide& side, int place) const {
  const Index edge = edges_.at(side);
  const CellSide& first = edges_.sides[at(edge)][0];
  const bool same = first.cell == side.cell && first.side == side.side;
  return on_[at(edge)][at(same ? place : 2 - place)];
}

/// Calls visit(number, first, last, xi) for each new node of an edge, which lies between two old ones.
template <typename Visit>
void EdgeMidpoints::visit_new(Index edge, Visit&& visit) const {
  const std::array<Index, 3>& on = on_[at(edge)];
  const std::vector<Index> nodes = mesh_.side_nodes(edges_.sides[at(edge)][0]);
  if (nodes.size() == 2) return visit(on[1], nodes[0], nodes[1], 0.0);
  visit(on[0], nodes[0], nodes[1], -0.5);
  visit(on[2], nodes[1], nodes[2], 0.5);
}

/// The edges opposite each other, through quadrilaterals, from one of the outline to the other end.
std::vector<EdgeMidpoints::Walked> EdgeMidpoints::line_from(Index edge) const {
  std::vector<Walked> line = {{edge, false}};
  CellSide side = edges_.sides[at(edge)][0];
  while (side.cell >= 0 && mesh_.corners(side.cell) == 4) {
    const CellSide opposite{side.cell, (side.side + 2) % 4};
    const Index next = edges_.at(opposite);
    const std::array<CellSide, 2>& cells = edges_.sides[at(next)];
    // A cell walks opposite sides in opposite directions, and two cells their common edge.
    const bool first = cells[0].cell == opposite.cell && cells[0].side == opposite.side;
    line.push_back({next, first});
    side = cells[first ? 1 : 0];
  }
  return line;
}

/// How far the outline is off the new nodes of an edge, in walking order; nothing if the edge is inside.
template <typename Shape>
std::vector<Vector2d> EdgeMidpoints::off(const Walked& walked, const Shape& shape) const {
  std::vector<Vector2d> ways;
  const bool inside = edges_.sides[at(walked.edge)][1].cell >= 0;
  visit_new(walked.edge, [&](Index number, Index first, Index last, double) {
    const Vector2d way = shape.middle(first, last) - nodes_.row(number).transpose();
    ways.insert(walked.against ? ways.begin() : ways.end(), inside ? Vector2d(0, 0) : way);
  });
  return ways;
}

/// Moves the new nodes of a refinement line off their edges.
void EdgeMidpoints::bend(const std::vector<Walked>& line, const std::vector<Vector2d>& start,
                         const std::vector<Vector2d>& end) {
  const auto middle = [&](const Walked& walked) {
    return SideCurve(mesh_, edges_.sides[at(walked.edge)][0]).point(0);
  };
  std::vector<double> place = {0};
  for (std::size_t k = 1; k < line.size(); ++k)
    place.push_back(place.back() + (middle(line[k]) - middle(line[k - 1])).norm());
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double t = k == 0 ? 0 : place[k] / place.back();
    std::size_t count = 0;
    visit_new(line[k].edge, [&](Index number, Index, Index, double) {
      const std::size_t j = line[k].against ? start.size() - ++count : count++;
      nodes_.row(number) += ((1 - t) * start[j] + t * end[j]).transpose();
    });
  }
}

}  // namespace signorini

#include "addons/estimate/edges.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A side of a cell by the numbers of its ends.
struct Ends {
  Index low, high;
  CellSide side;
};

std::vector<Ends> sorted_sides(const Mesh& mesh) {
  std::vector<Ends> sides;
  sides.reserve(at(4 * mesh.n_cells()));
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int side = 0; side < mesh.corners(cell); ++side) {
      const Index first = mesh.cells(cell, side);
      const Index last = mesh.cells(cell, (side + 1) % mesh.corners(cell));
      sides.push_back({std::min(first, last), std::max(first, last), {cell, side}});
    }
  std::sort(sides.begin(), sides.end(), [](const Ends& a, const Ends& b) {
    return std::tie(a.low, a.high, a.side.cell, a.side.side) <
           std::tie(b.low, b.high, b.side.cell, b.side.side);
  });
  return sides;
}

/// Calls visit(other) for the edge opposite an edge in each of its quadrilaterals.
template <typename Visit>
void visit_opposite(const Mesh& mesh, const MeshEdges& edges, Index edge, Visit&& visit) {
  for (const CellSide& side : edges.sides[at(edge)])
    if (side.cell >= 0 && mesh.corners(side.cell) == 4)
      visit(edges.of_cell(side.cell, (side.side + 2) % 4));
}

}  // namespace

MeshEdges edges(const Mesh& mesh) {
  MeshEdges result;
  result.of_cell.setConstant(mesh.n_cells(), 4, -1);
  const std::vector<Ends> sides = sorted_sides(mesh);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const bool second =
        k > 0 && sides[k].low == sides[k - 1].low && sides[k].high == sides[k - 1].high;
    if (second) {
      CellSide& other = result.sides.back()[1];
      require_input(other.cell < 0, "mesh '", mesh.name,
                    "': more than two cells share the edge from node ", sides[k].low, " to node ",
                    sides[k].high, ", cell ", sides[k].side.cell, " among them");
      other = sides[k].side;
    } else {
      result.sides.push_back({sides[k].side, CellSide{-1, 0}});
    }
    result.of_cell(sides[k].side.cell, sides[k].side.side) =
        static_cast<Index>(result.sides.size()) - 1;
  }
  return result;
}

MarkedEdges marked_alike(const Mesh& mesh, char times) {
  MeshEdges all = edges(mesh);
  std::vector<char> halved(all.size(), times);
  return {std::move(all), std::move(halved)};
}

int longest_side(const Mesh& mesh, Index triangle) {
  const auto node = [&](int k) -> Eigen::RowVector2d {
    return mesh.nodes.row(mesh.cells(triangle, k % 3));
  };
  double longest = 0;
  for (int s = 0; s < 3; ++s) longest = std::max(longest, (node(s + 1) - node(s)).norm());
  int found = -1;
  Eigen::RowVector2d place;
  for (int s = 0; s < 3; ++s) {
    if ((node(s + 1) - node(s)).norm() < (1 - 1e-12) * longest) continue;
    const Eigen::RowVector2d ends = node(s) + node(s + 1);
    if (found >= 0 && std::make_pair(ends.x(), ends.y()) > std::make_pair(place.x(), place.y()))
      continue;
    found = s;
    place = ends;
  }
  return found;
}

std::vector<Index> refinement_lines(const Mesh& mesh, const MeshEdges& edges) {
  std::vector<Index> line(edges.size(), -1);
  std::vector<Index> open;
  Index count = 0;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (line[first] >= 0) continue;
    open.push_back(static_cast<Index>(first));
    line[first] = count;
    while (!open.empty()) {
      const Index edge = open.back();
      open.pop_back();
      visit_opposite(mesh, edges, edge, [&](Index other) {
        if (line[at(other)] >= 0) return;
        line[at(other)] = count;
        open.push_back(other);
      });
    }
    ++count;
  }
  return line;
}

std::vector<char> closed_under_halving(const Mesh& mesh, const MeshEdges& edges,
                                       std::vector<char> halved) {
  require_argument(halved.size() == edges.size(),
                   "closed_under_halving: expected a mark for each of ", edges.size(),
                   " edges, got ", halved.size());
  std::vector<Index> open;
  for (std::size_t edge = 0; edge < halved.size(); ++edge)
    if (halved[edge] != 0) open.push_back(static_cast<Index>(edge));
  const auto halve = [&](Index edge, char times) {
    if (halved[at(edge)] >= times) return;
    halved[at(edge)] = times;
    open.push_back(edge);
  };
  while (!open.empty()) {
    const Index edge = open.back();
    open.pop_back();
    const char times = halved[at(edge)];
    visit_opposite(mesh, edges, edge, [&](Index other) { halve(other, times); });
    for (const CellSide& side : edges.sides[at(edge)])
      if (side.cell >= 0 && mesh.corners(side.cell) == 3)
        halve(edges.of_cell(side.cell, longest_side(mesh, side.cell)), 1);
  }
  return halved;
}

}  // namespace signorini

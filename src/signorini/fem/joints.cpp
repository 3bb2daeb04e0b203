// # What hangs together with what
//
// A mesh is a list of cells. Whether they form one body or two, and where its outline is, stands
// nowhere in the list. Two questions are answered here, both by looking at nodes that cells share.
//
// *Pieces.* Cells that share a node belong together, and so do their neighbours, and so on. This
// is the problem of connected components, see [disjoint_sets.hpp](../core/disjoint_sets.hpp).
//
// *Outer sides.* A side inside of the body belongs to two cells, one of the outline to one.
// Sorting all sides and looking for those that stand alone answers it. A mesh of a million cells
// has two million sides and only some thousands on its outline, so we first find the nodes there,
// in one pass and without sorting.

#include "signorini/fem/joints.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "signorini/core/disjoint_sets.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Calls visit(side, first, last) for the ways from node to node round a cell: one per side, or two by its middle.
///
/// A side of three nodes counts as two edges. Then both kinds of mesh look alike from here on: a
/// graph of nodes and edges between neighbours.
template <typename Visit>
void visit_edges(const Mesh& mesh, Index cell, Visit&& visit) {
  const int corners = mesh.corners(cell);
  const bool quadratic = mesh.order() == MeshOrder::Quadratic;
  for (int side = 0; side < corners; ++side) {
    const Index first = mesh.cells(cell, side);
    const Index last = mesh.cells(cell, side + 1 < corners ? side + 1 : 0);
    if (quadratic) {
      const Index middle = mesh.cells(cell, corners + side);
      visit(side, first, middle);
      visit(side, middle, last);
    } else {
      visit(side, first, last);
    }
  }
}

/// Bits without any pattern of the number (the end of splitmix64).
///
/// Node numbers themselves would not do for the sum below. A node where two outlines meet has two
/// neighbours before it and two behind, such as 1, 4 and 2, 3: the sum \f$2 + 3 - 1 - 4\f$ is 0.
std::uint64_t scrambled(std::uint64_t number) {
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// Whether a node is on the outline. Inside, the edge to each neighbour is walked once there and once back: what
/// is added for one is taken away for the other.
///
/// Sums are of integers that wrap around, so they are exact: a node inside has exactly 0. An edge of
/// the outline is walked once. A node there keeps the marks of its neighbours along the outline, with
/// the signs + and -, which add up to 0 only by an accident of about one in \f$2^{64}\f$.
std::vector<char> on_outline(const Mesh& mesh) {
  std::vector<std::uint64_t> mark(at(mesh.n_nodes()));
  for (std::size_t node = 0; node < mark.size(); ++node) mark[node] = scrambled(node);
  std::vector<std::uint64_t> sum(mark.size(), 0);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    visit_edges(mesh, cell, [&](int /*side*/, Index first, Index last) {
      sum[at(first)] += mark[at(last)];
      sum[at(last)] -= mark[at(first)];
    });
  std::vector<char> outer(sum.size());
  for (std::size_t node = 0; node < sum.size(); ++node) outer[node] = sum[node] != 0 ? 1 : 0;
  return outer;
}

}  // namespace

/// The smallest node of a set names it. So pieces come in the order of their first nodes, and a
/// renumbered list of cells gives the same pieces in the same order. A node that no cell has is in none.
std::vector<MeshPiece> pieces(const Mesh& mesh) {
  DisjointSets sets(mesh.n_nodes());
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (Index k = 1, n = mesh.cell_size(cell); k < n; ++k)
      sets.join(mesh.cells(cell, 0), mesh.cells(cell, k));
  std::vector<Index> cells(at(mesh.n_nodes()), 0);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) ++cells[at(sets.name(mesh.cells(cell, 0)))];
  std::vector<MeshPiece> found;
  std::vector<std::size_t> place(cells.size());  // of the piece that a node names
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Index name = sets.name(node);
    if (cells[at(name)] == 0) continue;
    if (name == node) {
      place[at(node)] = found.size();
      found.push_back({{}, cells[at(node)]});
    }
    found[place[at(name)]].nodes.push_back(node);
  }
  return found;
}

/// A piece has no name of its own. Messages say where it is, by the middle of its box, and how many
/// cells it has.
Eigen::Vector2d middle(const Mesh& mesh, const MeshPiece& piece) {
  const NodeArray x = mesh.nodes(piece.nodes, Eigen::all);
  return (x.colwise().minCoeff() + x.colwise().maxCoeff()).transpose() / 2;
}

/// Such as "8 cells around (2, 0.5)": a user finds that in a picture, and not the number of a
/// piece.
std::string in_words(const Mesh& mesh, const MeshPiece& piece) {
  const Eigen::Vector2d x = middle(mesh, piece);
  return text(piece.cells, " cells around (", x.x(), ", ", x.y(), ')');
}

/// Only edges with both ends on the outline are sorted. That is not yet enough to be an outer side:
/// the diagonal of a narrow strip has both ends there and belongs to two cells. Those that stand
/// alone are outer. The faces of a crack count as well, since their nodes are two at each place.
std::vector<CellSide> outer_sides(const Mesh& mesh) {
  const std::vector<char> outer = on_outline(mesh);
  struct CellEdge {
    Index low, high;  // its nodes
    CellSide side;
  };
  std::vector<CellEdge> edges;  // all those between nodes of the outline
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    visit_edges(mesh, cell, [&](int side, Index first, Index last) {
      if (outer[at(first)] != 0 && outer[at(last)] != 0)
        edges.push_back({std::min(first, last), std::max(first, last), {cell, side}});
    });
  std::sort(edges.begin(), edges.end(), [](const CellEdge& a, const CellEdge& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  std::vector<CellSide> sides;
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k + 1;
    while (end < edges.size() && edges[end].low == edges[k].low && edges[end].high == edges[k].high)
      ++end;
    // Edges between the same two nodes stand behind each other now. One that stands alone is an
    // outer one.
    if (end == k + 1) sides.push_back(edges[k].side);
    k = end;
  }
  std::sort(sides.begin(), sides.end(), [](const CellSide& a, const CellSide& b) {
    return std::pair(a.cell, a.side) < std::pair(b.cell, b.side);
  });
  // Both halves of a quadratic side may be outer ones.
  sides.erase(std::unique(sides.begin(), sides.end(),
                          [](const CellSide& a, const CellSide& b) {
                            return a.cell == b.cell && a.side == b.side;
                          }),
              sides.end());
  return sides;
}

}  // namespace signorini

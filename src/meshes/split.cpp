#include "meshes/split.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::RowVector2d;

/// What becomes of a cell.
struct Piece {
  Index first = 0;  ///< number of its first piece
  int start = -1;   ///< the corner where the diagonal starts, 0 or 1; -1 if the cell stays whole
};

/// The corner, 0 or 1, from which the shorter diagonal of a quadrilateral starts; 0 if rounding cannot tell.
int shorter_diagonal(const Mesh& mesh, Index cell) {
  const auto length = [&](int k) {
    return (mesh.nodes.row(mesh.cells(cell, k + 2)) - mesh.nodes.row(mesh.cells(cell, k))).norm();
  };
  const double first = length(0);
  return length(1) < (1 - 1e-12) * first ? 1 : 0;
}

/// Where the node in the middle of a diagonal goes: half way if the sides of the cell are straight, and as far off as
/// the middle of the cell if they are curved.
RowVector2d middle_of_diagonal(const Mesh& mesh, Index cell, int start) {
  const auto node = [&](int k) -> RowVector2d { return mesh.nodes.row(mesh.cells(cell, k)); };
  RowVector2d middle = 0.5 * (node(start) + node(start + 2));
  for (int s = 0; s < 4; ++s) middle += 0.5 * (node(4 + s) - 0.5 * (node(s) + node((s + 1) % 4)));
  return middle;
}

std::vector<Piece> pieces_of(const Mesh& mesh, const std::vector<Index>& cells) {
  std::vector<Piece> pieces(static_cast<std::size_t>(mesh.n_cells()));
  for (const Index cell : cells) {
    require_argument(cell >= 0 && cell < mesh.n_cells(), "split: mesh '", mesh.name,
                     "' has the cells 0 to ", mesh.n_cells() - 1, ", got ", cell);
    if (mesh.corners(cell) == 4)
      pieces[static_cast<std::size_t>(cell)].start = shorter_diagonal(mesh, cell);
  }
  Index next = 0;
  for (Piece& piece : pieces) {
    piece.first = next;
    next += piece.start < 0 ? 1 : 2;
  }
  return pieces;
}

/// The nodes on diagonals, and the cells.
void cut(const Mesh& mesh, const std::vector<Piece>& pieces, Mesh& result) {
  const bool quadratic = mesh.order() == MeshOrder::Quadratic;
  bool quadrilaterals = false;
  Index cuts = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const bool whole = pieces[static_cast<std::size_t>(cell)].start < 0;
    cuts += whole ? 0 : 1;
    quadrilaterals = quadrilaterals || (whole && mesh.corners(cell) == 4);
  }
  const Index width = (quadratic ? 2 : 1) * (quadrilaterals ? 4 : 3);
  result.cells.setConstant(mesh.n_cells() + cuts, width, -1);
  Index middle = mesh.n_nodes();
  if (quadratic) result.nodes.conservativeResize(middle + cuts, 2);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const auto [first, start] = pieces[static_cast<std::size_t>(cell)];
    const auto old = mesh.cells.row(cell);
    if (start < 0) {
      const Index size = mesh.cell_size(cell);
      result.cells.row(first).head(size) = old.head(size);
      continue;
    }
    for (const int half : {0, 1}) {
      auto triangle = result.cells.row(first + half);
      const int from = start + 2 * half;
      for (int k = 0; k < 3; ++k) triangle(k) = old((from + k) % 4);
      if (quadratic) triangle.segment<3>(3) << old(4 + from), old(4 + (from + 1) % 4), middle;
    }
    if (quadratic) result.nodes.row(middle++) = middle_of_diagonal(mesh, cell, start);
  }
}

}  // namespace

Mesh split(const Mesh& mesh, const std::vector<Index>& cells) {
  const std::vector<Piece> pieces = pieces_of(mesh, cells);
  const auto piece_of = [&](Index cell) { return pieces[static_cast<std::size_t>(cell)]; };
  Mesh result = mesh;
  cut(mesh, pieces, result);
  for (auto& [name, sides] : result.boundaries)
    for (CellSide& side : sides) {
      const Piece piece = piece_of(side.cell);
      const int s = piece.start < 0 ? side.side : (side.side - piece.start + 4) % 4;
      side = piece.start < 0 ? CellSide{piece.first, s} : CellSide{piece.first + s / 2, s % 2};
    }
  for (auto& [name, list] : result.regions) {
    const std::vector<Index> before = std::move(list);
    list.clear();
    for (const Index cell : before) {
      const Piece piece = piece_of(cell);
      list.push_back(piece.first);
      if (piece.start >= 0) list.push_back(piece.first + 1);
    }
  }
  return result;
}

Mesh split(const Mesh& mesh) {
  std::vector<Index> all(static_cast<std::size_t>(mesh.n_cells()));
  std::iota(all.begin(), all.end(), Index{0});
  return split(mesh, all);
}

}  // namespace signorini

// # Cells in rows and columns
//
// A ring, a plate with a hole and a beam are the same table of cells, bent into place by a
// function of \f$(i, j)\f$. Numbering and boundaries are settled here, once; a generator only says
// where nodes go.
//
// Places are counted in half steps, so that corners of cells have even \f$i\f$ and \f$j\f$ and
// midpoints of sides one odd number. With three nodes per side a row of two cells has the nodes
//
//     8-----9----10----11----12
//     |           |           |
//     5           6           7
//     |           |           |
//     0-----1-----2-----3-----4
//
// Its first cell is 0, 2, 10, 8 for the corners, then 1, 6, 9, 5 for the midpoints of its four
// sides.

#include "meshes/lattice.hpp"

namespace signorini {

using Eigen::Index;

/// Both numbers odd is the middle of a cell. Serendipity elements have no node there.
bool Lattice::has(Index i, Index j) const {
  return order == MeshOrder::Quadratic ? i % 2 == 0 || j % 2 == 0 : i % 2 == 0 && j % 2 == 0;
}

/// Around a hole the last row is the first one again, with the same nodes.
Index Lattice::node(Index i, Index j) const {
  const Index row = closed && j == 2 * cells_y ? 0 : j;
  return row_start(row) + (order == MeshOrder::Quadratic && row % 2 == 0 ? i : i / 2);
}

Index Lattice::row_start(Index j) const {
  // Full rows alternate with rows of midpoints.
  const Index full = order == MeshOrder::Quadratic ? 2 * cells_x + 1 : cells_x + 1;
  const Index between = order == MeshOrder::Quadratic ? cells_x + 1 : 0;
  return (j + 1) / 2 * full + j / 2 * between;
}

Mesh make_lattice(const std::string& name, const Lattice& lattice,
                  const std::function<Eigen::RowVector2d(Index i, Index j)>& position) {
  const Index columns = lattice.cells_x;
  const Index rows = lattice.cells_y;
  const bool quadratic = lattice.order == MeshOrder::Quadratic;
  Mesh mesh;
  mesh.name = name;
  mesh.nodes.resize(lattice.n_nodes(), 2);
  for (Index j = 0; j < 2 * rows + (lattice.closed ? 0 : 1); ++j)
    for (Index i = 0; i <= 2 * columns; ++i)
      if (lattice.has(i, j)) mesh.nodes.row(lattice.node(i, j)) = position(i, j);

  mesh.cells.resize(columns * rows, quadratic ? 8 : 4);
  for (Index row = 0; row < rows; ++row)
    for (Index column = 0; column < columns; ++column) {
      const Index cell = row * columns + column;
      const Index i = 2 * column;
      const Index j = 2 * row;
      mesh.cells.row(cell).head<4>() << lattice.node(i, j), lattice.node(i + 2, j),
          lattice.node(i + 2, j + 2), lattice.node(i, j + 2);
      if (quadratic)
        mesh.cells.row(cell).tail<4>() << lattice.node(i + 1, j), lattice.node(i + 2, j + 1),
            lattice.node(i + 1, j + 2), lattice.node(i, j + 1);
    }

  // Sides are listed so that one walks around the body anticlockwise, with the body on the left.
  // The top therefore begins at its right end.
  const auto add = [&](int side, Index n, Index first, Index step) {
    std::vector<CellSide>& named = mesh.boundaries[lattice.sides[static_cast<std::size_t>(side)]];
    for (Index k = 0; k < n; ++k) named.push_back({first + k * step, side});
  };
  if (!lattice.closed) add(2, columns, rows * columns - 1, -1);
  add(3, rows, (rows - 1) * columns, -columns);
  if (!lattice.closed) add(0, columns, 0, 1);
  add(1, rows, columns - 1, columns);
  return mesh;
}

}  // namespace signorini

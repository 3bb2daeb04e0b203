/// \file
/// Exercise 9.4 - a row with a fault. Do not change this file.
#pragma once
#include <array>
#include <optional>

namespace ex9_4 {

/// Positions of the nodes 1 and 2 of the target and 3 of the source [length].
struct Nodes {
  double x1, y1, x2, y2, x3, y3;
};

/// How much a gap grows with U_1x, U_1y, U_2x, U_2y, U_3x, U_3y [-].
using Row = std::array<double, 6>;

/// The row of node 3 over the straight edge from 1 to 2. \PaperEq{LinEtAl, 20} to \PaperEq{LinEtAl, 22}
///
/// The target lies on the left of the way from 1 to 2; the gap is counted along the unit normal out of it. The node faces the edge
/// if its projection lies on it, the ends included.
/// \param nodes  positions before loading
/// \return the row; nothing if the node faces no place of the edge
/// \throws std::invalid_argument if nodes 1 and 2 coincide or a position is not finite
[[nodiscard]] std::optional<Row> gap_row(const Nodes& nodes);

}  // namespace ex9_4

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex9_4 {

// Three faults: find and mend them.
std::optional<Row> gap_row(const Nodes& nodes) {
  for (const double place : {nodes.x1, nodes.y1, nodes.x2, nodes.y2, nodes.x3, nodes.y3})
    if (!std::isfinite(place)) throw std::invalid_argument("gap_row: a position is not finite");
  const double ex = nodes.x2 - nodes.x1, ey = nodes.y2 - nodes.y1;
  if (ex == 0 && ey == 0) throw std::invalid_argument("gap_row: the edge has no length");
  const double along = (nodes.x3 - nodes.x1) * ex + (nodes.y3 - nodes.y1) * ey;
  const double N1 = std::clamp(along / (ex * ex + ey * ey), 0.0, 1.0), N2 = 1 - N1;
  const double nx = ey, ny = -ex;
  return Row{-N1 * nx, -N1 * ny, -N2 * nx, -N2 * ny, nx, ny};
}

}  // namespace ex9_4

// # Where a field changes its sign
//
// Concrete cracks where it is pulled, and a joint opens where nothing presses. So the line between
// tension and compression is often what a picture is drawn for. It is found triangle by triangle,
// where the field is linear: from \f$ v_1 < 0 \f$ at one corner to \f$ v_2 > 0 \f$ at the next it
// vanishes at the share
// \f[ t = \frac{v_1}{v_1 - v_2} \f]
// of the way. With -1 and 3 that is a quarter.

#include "papers/zero_line_csv.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

// What may be rounding alone counts as zero: every machine draws the same line.
double without_rounding(double value, double rounding) {
  return std::abs(value) <= rounding ? 0 : value;
}

}  // namespace

// A triangle whose corners have different signs is crossed on two of its sides: the line between
// these two points is its part of the zero line. Zero counts as positive, so a line through a
// corner is found on one of the two sides that meet there, not on both.
//
// Each triangle is treated alone. Neighbours share a side and compute the same point on it, so the
// short pieces join to a line.
// A triangle without change of sign adds nothing.
std::string deformed_zero_line_csv(const Mesh& mesh, const NodeArray& displacements,
                                   const Eigen::Ref<const Eigen::VectorXd>& value, double scale) {
  require_argument(displacements.rows() == mesh.n_nodes() && value.size() == mesh.n_nodes(),
                   "deformed_zero_line_csv: need ", mesh.n_nodes(),
                   " displacements and values, got ", displacements.rows(), " and ", value.size());
  const NodeArray moved = mesh.nodes + scale * displacements;
  const double rounding = 1e-12 * (value.size() > 0 ? value.cwiseAbs().maxCoeff() : 0);
  Table line({"x", "y"});
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const int n = mesh.corners(cell);
    Eigen::Matrix<double, 5, 3> corner;  // x, y, value; the last of a quadrilateral is the middle
    for (int k = 0; k < n; ++k)
      corner.row(k) << moved.row(mesh.cells(cell, k)),
          without_rounding(value(mesh.cells(cell, k)), rounding);
    if (n == 4) corner.row(4) = corner.topRows<4>().colwise().mean();
    for (int k = 0; k < (n == 4 ? 4 : 1); ++k) {
      const int triangle[] = {k, (k + 1) % 4, n == 4 ? 4 : 2};
      int crossings = 0;
      for (int side = 0; side < 3; ++side) {
        const Eigen::RowVector3d one = corner.row(triangle[side]);
        const Eigen::RowVector3d other = corner.row(triangle[(side + 1) % 3]);
        if ((one(2) < 0) == (other(2) < 0)) continue;
        const Eigen::RowVector3d at = one + one(2) / (one(2) - other(2)) * (other - one);
        line.row({number(at(0), "%.5g"), number(at(1), "%.5g")});
        ++crossings;
      }
      if (crossings > 0) line.blank_line();
    }
  }
  return line.csv(text("rel 1e-4 abs ", 2e-5 * moved.cwiseAbs().maxCoeff()));
}

}  // namespace signorini

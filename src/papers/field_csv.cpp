// # A field in colours
//
// gnuplot fills polygons, but it does not know elements. So a field on a deformed mesh is written
// as polygons, each closed and followed by an empty line. Two pictures need two kinds: a cell with
// one value, and bands between levels. The line where a field changes its sign is in
// [zero_line_csv.cpp](zero_line_csv.cpp).
//
// Bands are cut where the field meets a level. Within a triangle the field is linear: if it is
// \f$ v_1 \f$ at one corner and \f$ v_2 \f$ at the next, it has the value v at the share
// \f[ t = \frac{v - v_1}{v_2 - v_1} \f]
// of the way between them. A quadrilateral is cut into four triangles about its middle, which has
// the mean of the corners.

#include "papers/field_csv.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

namespace {

// The corners of a polygon in order. A point carries its value with it, so that a cut interpolates
// position and value at once.
using Polygon = std::vector<Eigen::Vector3d>;  // x, y and the field

// What is left of a polygon where sign * (field - level) >= 0.
// Walk around the polygon: keep the corners on the right side of the level, and add a point
// wherever a side crosses it. A square with the values 0, 0, 1, 1 at its corners, cut at 0.5, keeps
// two corners and gets two points, half-way up.
Polygon part(const Polygon& whole, double level, int sign) {
  Polygon kept;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const Eigen::Vector3d &here = whole[k], &next = whole[(k + 1) % whole.size()];
    const double now = sign * (here[2] - level), then = sign * (next[2] - level);
    if (now >= 0) kept.push_back(here);
    if (now * then < 0) {
      kept.push_back(here + now / (now - then) * (next - here));
      kept.back()[2] = level;
    }
  }
  return kept;
}

// The pieces of a cell between two levels: of a triangle one, of a quadrilateral those of four triangles.
// Cut off what is below the lower level, then what is above the upper one. What has fewer than
// three corners is no piece.
std::vector<Polygon> between(const Polygon& corners, const Eigen::Vector3d& middle, double low,
                             double high) {
  std::vector<Polygon> pieces;
  const bool whole = corners.size() == 3;
  for (std::size_t k = 0; k < (whole ? 1 : 4); ++k) {
    const Eigen::Vector3d& last = whole ? corners[2] : middle;
    Polygon piece = part(part({corners[k], corners[(k + 1) % 4], last}, low, 1), high, -1);
    if (piece.size() > 2) pieces.push_back(std::move(piece));
  }
  return pieces;
}

// The corners of a cell where they have moved to; the field is filled in later.
Polygon corners_of(const Mesh& mesh, const NodeArray& moved, Eigen::Index cell) {
  Polygon corners;
  for (int k = 0; k < mesh.corners(cell); ++k)
    corners.emplace_back(moved(mesh.cells(cell, k), 0), moved(mesh.cells(cell, k), 1), 0);
  return corners;
}

// The outline of a polygon, closed, with what is said of it.
void add_outline(const Polygon& polygon, const std::string& said, Table& field) {
  for (std::size_t k = 0; k <= polygon.size(); ++k) {
    const Eigen::Vector3d& point = polygon[k % polygon.size()];
    field.row({number(point[0], "%.5g"), number(point[1], "%.5g"), said});
  }
  field.blank_line();
}

// The pieces of a cell in bands between limits: the whole cell if it is in one.
void add_bands(const Polygon& corners, const Eigen::Vector3d& middle,
               const std::vector<double>& limits, Table& field) {
  double low = limits.back(), high = limits.front();
  for (const Eigen::Vector3d& corner : corners) {
    low = std::min(low, corner[2]);
    high = std::max(high, corner[2]);
  }
  for (std::size_t band = 0; band + 1 < limits.size(); ++band) {
    if (low >= limits[band] && high <= limits[band + 1])
      return add_outline(corners, std::to_string(band), field);
    for (const Polygon& piece : between(corners, middle, limits[band], limits[band + 1]))
      add_outline(piece, std::to_string(band), field);
  }
}

// Values that rounding alone keeps from a level are moved onto it: every machine cuts the same cells.
// Otherwise such a value would be on one side with one compiler and on the other with the next, and
// the committed figure would change.
double snapped(double value, const std::vector<double>& levels, double tolerance) {
  for (const double level : levels)
    if (std::abs(value - level) <= tolerance) return level;
  return value;
}

}  // namespace

// The first corner is written again at the end, so that the polygon is closed. Numbers have five
// digits, which is more than a picture shows, and the tolerance in the first line allows for the
// last of them.
//
// A square of side 10 with the value 3.5 is
//
//     # tolerance rel 1e-4 abs 0.0002
//     x,y,value
//     0,0,3.5
//     10,0,3.5
//     10,10,3.5
//     0,10,3.5
//     0,0,3.5
std::string deformed_cells_csv(const Mesh& mesh, const NodeArray& displacements,
                               const Eigen::Ref<const Eigen::VectorXd>& value, double scale) {
  require_argument(displacements.rows() == mesh.n_nodes() && value.size() == mesh.n_cells(),
                   "deformed_cells_csv: need ", mesh.n_nodes(), " displacements and ",
                   mesh.n_cells(), " values, got ", displacements.rows(), " and ", value.size());
  const NodeArray moved = mesh.nodes + scale * displacements;
  const double size = moved.cwiseAbs().maxCoeff();
  const double largest = value.size() > 0 ? value.cwiseAbs().maxCoeff() : 0;
  Table field({"x", "y", "value"});
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell)
    add_outline(corners_of(mesh, moved, cell), number(value(cell), "%.5g"), field);
  return field.csv(text("rel 1e-4 abs ", 2e-5 * std::max(size, largest)));
}

// Two levels more, minus and plus infinity, make the first and the last band like the others.
//
// The colour of a band is its number: how many levels lie below it. A picture of bands shows the
// value to a reader without a scale of hundreds of colours.
//
// The mean in the middle is moved onto a level like the corners, so that no sliver is cut there.
std::string deformed_bands_csv(const Mesh& mesh, const NodeArray& displacements,
                               const Eigen::Ref<const Eigen::VectorXd>& value,
                               const std::vector<double>& levels, double scale) {
  require_argument(displacements.rows() == mesh.n_nodes() && value.size() == mesh.n_nodes(),
                   "deformed_bands_csv: need ", mesh.n_nodes(), " displacements and values, got ",
                   displacements.rows(), " and ", value.size());
  require_argument(
      std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) == levels.end(),
      "deformed_bands_csv: every level must be above the one before it");
  const NodeArray moved = mesh.nodes + scale * displacements;
  const double tolerance = 1e-9 * (value.size() > 0 ? value.cwiseAbs().maxCoeff() : 0);
  std::vector<double> limits = levels;
  limits.push_back(std::numeric_limits<double>::infinity());
  limits.insert(limits.begin(), -limits.back());
  Table field({"x", "y", "band"});
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    Polygon corners = corners_of(mesh, moved, cell);
    double sum = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const int n = mesh.corners(cell);
    for (int k = 0; k < n; ++k) {
      Eigen::Vector3d& corner = corners[static_cast<std::size_t>(k)];
      const double here = value(mesh.cells(cell, k));
      corner[2] = snapped(here, levels, tolerance);
      middle += corner / n;
      sum += here / n;
    }
    middle[2] = snapped(sum, levels, tolerance);
    add_bands(corners, middle, limits, field);
  }
  return field.csv(text("rel 1e-4 abs ", 2e-5 * moved.cwiseAbs().maxCoeff()));
}

// A pressure pushes along a normal; how long its arrow is drawn is the figure's own choice.
//
// A pressure of 3 upwards at (10, 0) is the line 10,0,0,3.
std::string pressure_arrows_csv(const NodeArray& place, const NodeArray& normal,
                                const Eigen::Ref<const Eigen::VectorXd>& pressure) {
  require_argument(place.rows() == normal.rows() && place.rows() == pressure.size(),
                   "pressure_arrows_csv: need as many places as normals and pressures, got ",
                   place.rows(), ", ", normal.rows(), " and ", pressure.size());
  Table arrows({"x", "y", "px", "py"});
  double largest = 0;
  for (Eigen::Index k = 0; k < place.rows(); ++k) {
    Eigen::RowVector4d row;
    row << place.row(k), pressure(k) * normal.row(k);
    largest = std::max(largest, row.cwiseAbs().maxCoeff());
    arrows.row({number(row(0), "%.5g"), number(row(1), "%.5g"), number(row(2), "%.5g"),
                number(row(3), "%.5g")});
  }
  return arrows.csv(text("rel 1e-4 abs ", 2e-5 * largest));
}

}  // namespace signorini

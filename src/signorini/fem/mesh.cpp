#include "signorini/fem/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <set>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/far.hpp"

namespace signorini {
namespace {

/// Twice the area of the triangle spanned at corner `k` by its two sides: det J there, times 4.
double corner_jacobian(const Mesh& mesh, Eigen::Index cell, int k) {
  const Eigen::RowVector2d here = mesh.nodes.row(mesh.cells(cell, k));
  const int n = mesh.corners(cell);
  const Eigen::RowVector2d next = mesh.nodes.row(mesh.cells(cell, (k + 1) % n)) - here;
  const Eigen::RowVector2d last = mesh.nodes.row(mesh.cells(cell, (k + n - 1) % n)) - here;
  return next.x() * last.y() - next.y() * last.x();
}

/// The corners of a cell, put into words only where a message is written.
struct Corners {
  const Mesh& mesh;
  Eigen::Index cell;
};

std::ostream& operator<<(std::ostream& out, const Corners& corners) {
  for (int k = 0; k < corners.mesh.corners(corners.cell); ++k) {
    const Eigen::RowVector2d x = corners.mesh.nodes.row(corners.mesh.cells(corners.cell, k));
    out << (k == 0 ? "" : ", ") << '(' << x.x() << ", " << x.y() << ')';
  }
  return out;
}

void check_node_numbers(const Mesh& mesh) {
  const Eigen::Index n = mesh.n_nodes();
  const Eigen::Index width = mesh.cells.cols();
  require_input(width == 3 || width == 4 || width == 6 || width == 8, "mesh '", mesh.name,
                "': cells must have 3 or 4 nodes, or 6 or 8, got ", width);
  require_input(mesh.n_cells() > 0, "mesh '", mesh.name,
                "' has no cells: make it with a generator, or read it from a file with surfaces");
  for (Eigen::Index node = 0; node < n; ++node)
    require_input(mesh.nodes.row(node).allFinite(), "mesh '", mesh.name, "': the position (",
                  mesh.nodes(node, 0), ", ", mesh.nodes(node, 1), ") of node ", node,
                  " is not finite, but it must be two numbers");
  std::vector<char> used(static_cast<std::size_t>(n), 0);
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Eigen::Index size = mesh.cell_size(cell);
    for (Eigen::Index k = 0; k < size; ++k) {
      const Eigen::Index node = mesh.cells(cell, k);
      require_input(node >= 0 && node < n, "mesh '", mesh.name, "': cell ", cell,
                    " refers to node ", node, ", but the nodes are 0 to ", n - 1);
      used[static_cast<std::size_t>(node)] = 1;
    }
    for (Eigen::Index k = size; k < width; ++k)
      require_input(mesh.cells(cell, k) == -1, "mesh '", mesh.name, "': cell ", cell,
                    ", a triangle in rows of ", width, ", must have -1 after its ", size,
                    " nodes, got ", mesh.cells(cell, k));
  }
  for (Eigen::Index node = 0; node < n; ++node)
    require_input(used[static_cast<std::size_t>(node)] != 0, "mesh '", mesh.name, "': node ", node,
                  " belongs to no cell; leave it out");
  for (const auto& [name, sides] : mesh.boundaries) {
    require_input(!sides.empty(), "mesh '", mesh.name, "': the boundary '", name,
                  "' has no sides; give it some, or leave it out");
    std::set<std::pair<Eigen::Index, int>> seen;
    for (const CellSide& side : sides) {
      const bool has_cell = side.cell >= 0 && side.cell < mesh.n_cells();
      const int n_sides = has_cell ? mesh.corners(side.cell) : 4;
      require_input(has_cell && side.side >= 0 && side.side < n_sides, "mesh '", mesh.name,
                    "': the boundary '", name, "' refers to side ", side.side, " of cell ",
                    side.cell, ", but the cells are 0 to ", mesh.n_cells() - 1, " with sides 0 to ",
                    n_sides - 1);
      require_input(seen.insert({side.cell, side.side}).second, "mesh '", mesh.name,
                    "': the boundary '", name, "' lists side ", side.side, " of cell ", side.cell,
                    " twice");
    }
  }
}

/// Midside nodes must lie in the middle half of their side: beyond it the map of the cell folds.
void check_midpoints(const Mesh& mesh, Eigen::Index cell) {
  const int n = mesh.corners(cell);
  for (int s = 0; s < n && mesh.order() == MeshOrder::Quadratic; ++s) {
    const Eigen::RowVector2d a = mesh.nodes.row(mesh.cells(cell, s));
    const Eigen::RowVector2d along = mesh.nodes.row(mesh.cells(cell, (s + 1) % n)) - a;
    const Eigen::RowVector2d middle = mesh.nodes.row(mesh.cells(cell, n + s)) - a;
    const double t = middle.dot(along) / along.squaredNorm();
    require_input(t > 0.25 && t < 0.75, "mesh '", mesh.name, "': cell ", cell,
                  " has the middle node of side ", s, " at ", t,
                  " of the side; it must lie between 0.25 and 0.75");
  }
}

/// Refuses what is too small for its distance from the origin. Small strains are a thousandth at most: of what
/// they do to a length, rounding then leaves three digits.
/// \param away  of the box of the mesh from the origin [length]
/// \param size  of something [length]
template <typename... Parts>
void check_digits(const Mesh& mesh, double away, double size, const Parts&... something) {
  const double rounding = epsilon * away;
  require_input(rounding <= 1e-6 * size, "mesh '", mesh.name,
                "' has lost its digits: so far from the origin its coordinates are rounded to ",
                rounding, ", expected at most a millionth of ", something..., ", which is ", size,
                ". Move the bodies near the origin");
}

}  // namespace

std::vector<Eigen::Index> Mesh::side_nodes(const CellSide& side) const {
  const Eigen::Index first = cells(side.cell, side.side);
  const int n = corners(side.cell);
  const Eigen::Index last = cells(side.cell, (side.side + 1) % n);
  if (order() == MeshOrder::Linear) return {first, last};
  return {first, cells(side.cell, n + side.side), last};
}

const std::vector<CellSide>& boundary(const Mesh& mesh, const std::string& name) {
  const auto found = mesh.boundaries.find(name);
  if (found != mesh.boundaries.end()) return found->second;
  std::string known;
  for (const auto& [other, sides] : mesh.boundaries) known += (known.empty() ? "" : ", ") + other;
  throw ProblemError(text(
      "mesh '", mesh.name, "' has no boundary '", name,
      "'; it has: ", known.empty() ? "none; name its sides, in Gmsh by Physical Curve" : known));
}

std::vector<Eigen::Index> boundary_nodes(const Mesh& mesh, const std::string& name) {
  std::vector<Eigen::Index> list;
  std::set<Eigen::Index> seen;
  for (const CellSide& side : boundary(mesh, name))
    for (const Eigen::Index node : mesh.side_nodes(side))
      if (seen.insert(node).second) list.push_back(node);
  return list;
}

MeshQuality check_mesh(const Mesh& mesh) {
  check_node_numbers(mesh);
  const double size = (mesh.nodes.colwise().maxCoeff() - mesh.nodes.colwise().minCoeff()).norm();
  const double away = distance_from_origin(mesh.nodes);
  check_digits(mesh, away, size, "its size");
  // A side shorter than rounding of the coordinates of a mesh on the origin has no length.
  const double no_length = 4 * epsilon * size;
  for (const auto& [name, sides] : mesh.boundaries)
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const std::vector<Eigen::Index> ends = mesh.side_nodes(sides[s]);
      const double length = (mesh.nodes.row(ends.front()) - mesh.nodes.row(ends.back())).norm();
      require_input(length > no_length, "mesh '", mesh.name, "': side ", s, " of the boundary '",
                    name, "' (cell ", sides[s].cell, ") has zero length: its end nodes ",
                    ends.front(), " and ", ends.back(),
                    " coincide; leave the side out, or move a node");
    }
  MeshQuality quality{1, 1};
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    double shortest = lowest;
    double longest = 0;
    const int n = mesh.corners(cell);
    for (int k = 0; k < n; ++k) {
      const double jacobian = corner_jacobian(mesh, cell, k);
      lowest = std::min(lowest, jacobian);
      highest = std::max(highest, jacobian);
      const double side =
          (mesh.nodes.row(mesh.cells(cell, (k + 1) % n)) - mesh.nodes.row(mesh.cells(cell, k)))
              .norm();
      shortest = std::min(shortest, side);
      longest = std::max(longest, side);
    }
    const double flat = 16 * epsilon * longest * size;
    require_input(
        lowest > flat, "mesh '", mesh.name, "': cell ", cell,
        highest < -flat
            ? " is inverted (its corners run clockwise)"
            : " is degenerate (a corner of 180 degrees or more, or two corners in one place)",
        ": corners ", Corners{mesh, cell}, "; list them anticlockwise, or move a node");
    check_digits(mesh, away, lowest / longest, "the height of cell ", cell);
    check_midpoints(mesh, cell);
    quality.smallest_jacobian_ratio = std::min(quality.smallest_jacobian_ratio, lowest / highest);
    // A triangle may be flat with sides of like lengths: its height tells.
    if (n == 3) shortest = lowest / longest / std::sqrt(0.75);
    quality.largest_aspect_ratio = std::max(quality.largest_aspect_ratio, longest / shortest);
  }
  return quality;
}

}  // namespace signorini

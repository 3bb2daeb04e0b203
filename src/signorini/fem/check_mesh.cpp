// # What may be wrong with a mesh
//
// A wrong mesh seldom stops a program. A cell whose corners run clockwise has a negative volume;
// its stiffness is negative, and the displacements are wrong in its neighbourhood, or the factor
// breaks down far from it. So each cell is looked at once, and messages name the cell and what to
// do.
//
// The test of shape is the sign of \f$\det J\f$. On a quadrilateral with straight sides
// \f$\det J\f$ is linear in \f$\xi\f$ and \f$\eta\f$, so that its least value is at a corner;
// there it is a quarter of the cross product of the two sides. For the square \f$[0, 1]^2\f$ it is
// 1/4 at each corner: the reference square has the area 4. If one corner is pulled in to (0.4,
// 0.4), that corner has \f$-0.2\f$ as its cross product: the angle is more than 180 degrees, and a
// part of the cell is covered twice. The two ratios that are returned are 1 for a square; programs
// warn by them.

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/fem/mesh.hpp"

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
///
/// Checks run on millions of cells, of which at most one gets a message.
struct Corners {
  const Mesh& mesh;
  Eigen::Index cell;
};

/// Such as (0, 0), (1, 0), (1, 1), (0, 1).
std::ostream& operator<<(std::ostream& out, const Corners& corners) {
  for (int k = 0; k < corners.mesh.corners(corners.cell); ++k) {
    const Eigen::RowVector2d x = corners.mesh.nodes.row(corners.mesh.cells(corners.cell, k));
    out << (k == 0 ? "" : ", ") << '(' << x.x() << ", " << x.y() << ')';
  }
  return out;
}

/// All messages begin with the name of the mesh.
template <typename... Parts>
void require_mesh(const Mesh& mesh, bool right, const Parts&... fault) {
  require_input(right, "mesh '", mesh.name, "': ", fault...);
}

/// Order matters: what a check reads, an earlier one has looked at. Numbers of nodes come before
/// positions of corners, and positions before angles.
void check_shape_and_positions(const Mesh& mesh) {
  const Eigen::Index width = mesh.cells.cols();
  require_mesh(mesh, width == 3 || width == 4 || width == 6 || width == 8,
               "cells must have 3 or 4 nodes, or 6 or 8, got ", width);
  require_input(mesh.n_cells() > 0, "mesh '", mesh.name,
                "' has no cells: make it with a generator, or read it from a file with surfaces");
  for (Eigen::Index node = 0; node < mesh.n_nodes(); ++node)
    require_mesh(mesh, mesh.nodes.row(node).allFinite(), "the position (", mesh.nodes(node, 0),
                 ", ", mesh.nodes(node, 1), ") of node ", node,
                 " is not finite, but it must be two numbers");
}

/// Cells refer to nodes that exist, and every node belongs to a cell.
///
/// A node that belongs to no cell has no stiffness. Its unknowns would make \f$K\f$ singular.
void check_node_numbers(const Mesh& mesh) {
  const Eigen::Index n = mesh.n_nodes();
  std::vector<char> used(at(n), 0);
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Eigen::Index size = mesh.cell_size(cell);
    for (Eigen::Index k = 0; k < size; ++k) {
      const Eigen::Index node = mesh.cells(cell, k);
      require_mesh(mesh, node >= 0 && node < n, "cell ", cell, " refers to node ", node,
                   ", but the nodes are 0 to ", n - 1);
      used[at(node)] = 1;
    }
    for (Eigen::Index k = size; k < mesh.cells.cols(); ++k)
      require_mesh(mesh, mesh.cells(cell, k) == -1, "cell ", cell, ", a triangle in rows of ",
                   mesh.cells.cols(), ", must have -1 after its ", size, " nodes, got ",
                   mesh.cells(cell, k));
  }
  for (Eigen::Index node = 0; node < n; ++node)
    require_mesh(mesh, used[at(node)] != 0, "node ", node, " belongs to no cell; leave it out");
}

/// Boundaries list sides that exist, each once.
///
/// A side that is listed twice would be loaded twice.
void check_boundaries(const Mesh& mesh) {
  for (const auto& [name, sides] : mesh.boundaries) {
    require_mesh(mesh, !sides.empty(), "the boundary '", name,
                 "' has no sides; give it some, or leave it out");
    std::set<std::pair<Eigen::Index, int>> seen;
    for (const CellSide& side : sides) {
      const bool has_cell = side.cell >= 0 && side.cell < mesh.n_cells();
      const int n_sides = has_cell ? mesh.corners(side.cell) : 4;
      require_mesh(mesh, has_cell && side.side >= 0 && side.side < n_sides, "the boundary '", name,
                   "' refers to side ", side.side, " of cell ", side.cell,
                   ", but the cells are 0 to ", mesh.n_cells() - 1, " with sides 0 to ",
                   n_sides - 1);
      require_mesh(mesh, seen.insert({side.cell, side.side}).second, "the boundary '", name,
                   "' lists side ", side.side, " of cell ", side.cell, " twice");
    }
  }
}

/// Midside nodes must lie in the middle half of their side: beyond it the map of the cell folds.
///
/// Along a straight side with its middle at the share \f$t\f$ the map is
/// \f$x = t\,(1 - \xi^2) + \tfrac12\xi(1+\xi)\f$, with the slope \f$\tfrac12 + (1 - 2t)\,\xi\f$. At
/// an end it is 0 for \f$t = 1/4\f$ or \f$3/4\f$: there the strain is infinite. Cracks are modelled
/// so on purpose in the *quarter-point* elements of fracture mechanics; here it is a mistake.
void check_midpoints(const Mesh& mesh, Eigen::Index cell) {
  const int n = mesh.corners(cell);
  for (int s = 0; s < n && mesh.order() == MeshOrder::Quadratic; ++s) {
    const Eigen::RowVector2d a = mesh.nodes.row(mesh.cells(cell, s));
    const Eigen::RowVector2d along = mesh.nodes.row(mesh.cells(cell, (s + 1) % n)) - a;
    const Eigen::RowVector2d middle = mesh.nodes.row(mesh.cells(cell, n + s)) - a;
    const double t = middle.dot(along) / along.squaredNorm();
    require_mesh(mesh, t > 0.25 && t < 0.75, "cell ", cell, " has the middle node of side ", s,
                 " at ", t, " of the side; it must lie between 0.25 and 0.75");
  }
}

/// Refuses what is too small for its distance from the origin. Small strains are a thousandth at
/// most: of what they do to a length, rounding then leaves three digits.
///
/// The unit square is accepted at \f$x = 4\cdot10^9\f$ and refused at \f$5\cdot10^9\f$.
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

/// Sides of boundaries have a length: more than rounding of the coordinates of a mesh on the
/// origin.
///
/// A side of no length has no normal.
/// \param size  of the mesh [length]
void check_lengths(const Mesh& mesh, double size) {
  for (const auto& [name, sides] : mesh.boundaries)
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const std::vector<Eigen::Index> ends = mesh.side_nodes(sides[s]);
      const double length = (mesh.nodes.row(ends.front()) - mesh.nodes.row(ends.back())).norm();
      require_mesh(mesh, length > 4 * epsilon * size, "side ", s, " of the boundary '", name,
                   "' (cell ", sides[s].cell, ") has zero length: its end nodes ", ends.front(),
                   " and ", ends.back(), " coincide; leave the side out, or move a node");
    }
}

/// One cell. Both ratios compare corners only; sides that bulge are looked at when their cell is
/// integrated, in assemble().
///
/// \param away, size  of the mesh, as of check_digits() [length]
MeshQuality check_cell(const Mesh& mesh, Eigen::Index cell, double away, double size) {
  const int n = mesh.corners(cell);
  Eigen::Array4d jacobian;
  Eigen::Array4d side;
  for (int k = 0; k < 4; ++k) {  // a triangle meets its first corner again
    jacobian(k) = corner_jacobian(mesh, cell, k % n);
    side(k) =
        (mesh.nodes.row(mesh.cells(cell, (k + 1) % n)) - mesh.nodes.row(mesh.cells(cell, k % n)))
            .norm();
  }
  const double lowest = jacobian.minCoeff();
  const double highest = jacobian.maxCoeff();
  const double longest = side.maxCoeff();
  // Zero up to rounding: a product of two lengths, each rounded with the size of the mesh.
  const double flat = 16 * epsilon * longest * size;
  require_mesh(
      mesh, lowest > flat, "cell ", cell,
      highest < -flat
          ? " is inverted (its corners run clockwise)"
          : " is degenerate (a corner of 180 degrees or more, or two corners in one place)",
      ": corners ", Corners{mesh, cell}, "; list them anticlockwise, or move a node");
  const double height = lowest / longest;
  check_digits(mesh, away, height, "the height of cell ", cell);
  check_midpoints(mesh, cell);
  // A triangle may be flat with sides of like lengths: its height tells.
  return {lowest / highest, longest / (n == 3 ? height / std::sqrt(0.75) : side.minCoeff())};
}

}  // namespace

/// The order is that of the functions above.
MeshQuality check_mesh(const Mesh& mesh) {
  check_shape_and_positions(mesh);
  check_node_numbers(mesh);
  check_boundaries(mesh);
  const double size = (mesh.nodes.colwise().maxCoeff() - mesh.nodes.colwise().minCoeff()).norm();
  const double away = distance_from_origin(mesh.nodes);
  check_digits(mesh, away, size, "its size");
  check_lengths(mesh, size);
  MeshQuality worst{1, 1};
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const auto [jacobian_ratio, aspect_ratio] = check_cell(mesh, cell, away, size);
    worst.smallest_jacobian_ratio = std::min(worst.smallest_jacobian_ratio, jacobian_ratio);
    worst.largest_aspect_ratio = std::max(worst.largest_aspect_ratio, aspect_ratio);
  }
  return worst;
}

}  // namespace signorini

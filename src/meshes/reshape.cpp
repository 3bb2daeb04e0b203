// # New meshes from old ones
//
// Each function takes a mesh and returns another one, so that a drawing is read from the inside
// out: `joined(moved(block, shift), ...)`. Three things must stay true, and they are what makes
// these functions more than a formula for positions. Cells run anticlockwise. Boundaries keep the
// body on their left. Names go with the sides that they name.

#include "meshes/reshape.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Where the walk along a list of sides begins, and where it ends.
Index first_node(const Mesh& mesh, const std::vector<CellSide>& sides) {
  return mesh.side_nodes(sides.front()).front();
}

Index last_node(const Mesh& mesh, const std::vector<CellSide>& sides) {
  return mesh.side_nodes(sides.back()).back();
}

/// Adds `more` to a boundary, before or after what it has, whichever continues the walk.
///
/// Two boundaries of one name become one. Walking order matters: results along a boundary are
/// printed in this order.
void lengthen(const Mesh& mesh, const std::vector<CellSide>& more, std::vector<CellSide>& sides) {
  const bool before = !sides.empty() && !more.empty() &&
                      last_node(mesh, more) == first_node(mesh, sides) &&
                      last_node(mesh, sides) != first_node(mesh, more);
  sides.insert(before ? sides.begin() : sides.end(), more.begin(), more.end());
}

/// Numbers in `first` of the nodes of `second`; those off the line follow the nodes of `first`.
///
/// Gluing is renumbering: the second mesh uses the nodes of the first one on the common line, which
/// it meets in the opposite order. Nodes must lie in the same place, up to rounding. If one mesh
/// had a node in between, the two would be held together at the others and would gape at this one
/// (loose_nodes.cpp).
std::vector<Index> numbers_after_joining(const Mesh& first, const std::string& along,
                                         const Mesh& second, const std::string& opposite) {
  const std::vector<Index> line = boundary_nodes(first, along);
  std::vector<Index> other = boundary_nodes(second, opposite);
  std::reverse(other.begin(), other.end());  // both keep their body on the left
  require_input(line.size() == other.size(), "joined: '", first.name, "' has ", line.size(),
                " nodes on '", along, "', but '", second.name, "' has ", other.size(), " on '",
                opposite, "'; they must be the same");
  const double size =
      std::max(first.nodes.cwiseAbs().maxCoeff(), second.nodes.cwiseAbs().maxCoeff());
  std::vector<Index> number(static_cast<std::size_t>(second.n_nodes()), -1);
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Eigen::RowVector2d here = first.nodes.row(line[k]);
    const Eigen::RowVector2d there = second.nodes.row(other[k]);
    require_input((here - there).norm() <= 1e-12 * size, "joined: node ", k, " on '", along,
                  "' of '", first.name, "' is at (", here.x(), ", ", here.y(),
                  "), but its partner on '", opposite, "' of '", second.name, "' is at (",
                  there.x(), ", ", there.y(), "); they must be in one place");
    number[static_cast<std::size_t>(other[k])] = line[k];
  }
  Index next = first.n_nodes();
  for (Index& n : number)
    if (n < 0) n = next++;
  return number;
}

}  // namespace

/// Only positions change. A map that mirrors would turn all cells inside out; mirrored() takes care
/// of it. Midpoints of sides are mapped like all nodes, so that a straight side becomes a parabola
/// through three points of the image, which is closer to it than a chord.
Mesh mapped(Mesh mesh, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map) {
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    // Any formula will do: a ring is a block whose sides are taken for angle and radius.
    const Eigen::Vector2d image = map(mesh.nodes.row(node).transpose());
    mesh.nodes.row(node) = image.transpose();
  }
  return mesh;
}

/// Half a body is often drawn, mirrored and moved: the gaps of a contact are then set by one
/// number.
Mesh moved(Mesh mesh, const Eigen::Vector2d& shift) {
  mesh.nodes.rowwise() += shift.transpose();
  return mesh;
}

/// A mirror image runs clockwise until its corners are listed backwards. With the corners 0 1 2 3
/// read as 1 0 3 2, side 0 stays in its place and sides 1 and 3 change theirs; midpoints follow
/// their sides. A triangle reads 1 0 2. A boundary must be walked from its other end. New positions
/// alone would leave all cells inverted, and check_mesh() would refuse them. The image of \f$x\f$
/// is \f$2p - x\f$ with the place \f$p\f$ of the line.
Mesh mirrored(Mesh mesh, MirrorLine line, double place) {
  const Index axis = line == MirrorLine::Upright ? 0 : 1;
  mesh.nodes.col(axis) = (2 * place - mesh.nodes.col(axis).array()).matrix();
  // Backwards from the second corner: side 0 stays side 0, side 1 becomes the last.
  const bool quadratic = mesh.order() == MeshOrder::Quadratic;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    auto nodes = mesh.cells.row(cell);
    const int n = mesh.corners(cell);
    std::swap(nodes(0), nodes(1));
    if (n == 4) std::swap(nodes(2), nodes(3));
    if (quadratic) std::swap(nodes(n + 1), nodes(2 * n - 1));
  }
  for (auto& [name, sides] : mesh.boundaries) {
    std::reverse(sides.begin(), sides.end());
    for (CellSide& side : sides) {
      const int n = mesh.corners(side.cell);
      side.side = (n - side.side) % n;
    }
  }
  return mesh;
}

/// Two boundaries that are renamed alike become one. They must follow each other, for a boundary is
/// walked from end to end, and neighbours along it are told from the nodes that they share.
///
/// A contact is between two boundaries. What a point should see as one surface must be one boundary:
/// no side of another boundary is a neighbour of its last side.
Mesh renamed(Mesh mesh, const std::string& from, const std::string& to) {
  const std::vector<CellSide> sides = boundary(mesh, from);
  mesh.boundaries.erase(from);
  std::vector<CellSide>& target = mesh.boundaries[to];
  require_input(target.empty() || last_node(mesh, target) == first_node(mesh, sides) ||
                    last_node(mesh, sides) == first_node(mesh, target),
                "renamed: mesh '", mesh.name, "' has a boundary '", to, "' already, and '", from,
                "' neither begins where it ends nor ends where it begins; take another name");
  lengthen(mesh, sides, target);
  return mesh;
}

/// The order of nodes and cells is that of the parts, so that results of the first part can be
/// found again. The common line is inside now: it is no boundary any more.
Mesh joined(Mesh first, const std::string& along, const Mesh& second, const std::string& opposite) {
  // Sides of two nodes beside sides of three would gape between the nodes, so this is refused.
  const auto per_side = [](const Mesh& mesh) { return mesh.order() == MeshOrder::Linear ? 2 : 3; };
  require_input(first.order() == second.order(), "joined: sides of '", first.name, "' have ",
                per_side(first), " nodes, those of '", second.name, "' have ", per_side(second),
                "; they must be alike");
  // Nodes keep their numbers in the first mesh, cells as well; those of the second one follow.
  const std::vector<Index> number = numbers_after_joining(first, along, second, opposite);
  const Index old_nodes = first.n_nodes();
  const Index old_cells = first.n_cells();
  Mesh mesh = std::move(first);
  mesh.nodes.conservativeResize(*std::max_element(number.begin(), number.end()) + 1, 2);
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] >= old_nodes)
      mesh.nodes.row(number[node]) = second.nodes.row(static_cast<Index>(node));
  // Rows are as wide as the largest cell of both. What they do not use is -1.
  const Index width = std::max(mesh.cells.cols(), second.cells.cols());
  mesh.cells.conservativeResizeLike(CellArray::Constant(old_cells + second.n_cells(), width, -1));
  for (Index cell = 0; cell < second.n_cells(); ++cell)
    for (Index k = 0; k < second.cell_size(cell); ++k)
      mesh.cells(old_cells + cell, k) = number[static_cast<std::size_t>(second.cells(cell, k))];

  // Then names: boundaries of the second mesh count their cells behind those of the first.
  mesh.boundaries.erase(along);
  for (const auto& [name, sides] : second.boundaries) {
    if (name == opposite) continue;
    std::vector<CellSide> more = sides;
    for (CellSide& side : more) side.cell += old_cells;
    lengthen(mesh, more, mesh.boundaries[name]);
  }
  for (const auto& [name, cells] : second.regions)
    for (const Index cell : cells) mesh.regions[name].push_back(old_cells + cell);
  return mesh;
}

}  // namespace signorini

#include "addons/estimate/mesh_refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "addons/estimate/edge_midpoints.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// A corner of a piece as a point of the cell that was cut. Of a cell of n corners, the corners are the points 0 to
/// n - 1, the middles of its sides n to 2n - 1, and its own middle is 2n.
using Point = int;
/// Corners of the pieces of a cell; those of triangles have -1 at the end.
using Pieces = std::vector<std::array<Point, 4>>;

Pieces pieces_of_quadrilateral(bool along, bool across) {
  if (along && across) return {{0, 4, 8, 7}, {1, 5, 8, 4}, {2, 6, 8, 5}, {3, 7, 8, 6}};
  if (along) return {{0, 4, 6, 3}, {4, 1, 2, 6}};
  if (across) return {{0, 1, 5, 7}, {7, 5, 2, 3}};
  return {{0, 1, 2, 3}};
}

/// \param a       its longest side
/// \param halved  whether its sides are halved: if one is, the longest is
Pieces pieces_of_triangle(Point a, const std::array<bool, 3>& halved) {
  const Point b = (a + 1) % 3;
  const Point c = (a + 2) % 3;
  if (!halved[at(a)]) return {{0, 1, 2, -1}};
  Pieces pieces = {{a, 3 + a, c, -1}, {3 + a, b, c, -1}};
  if (halved[at(b)]) pieces[1] = {3 + a, b, 3 + b, -1};
  if (halved[at(b)]) pieces.push_back({3 + a, 3 + b, c, -1});
  if (halved[at(c)]) pieces[0] = {a, 3 + a, 3 + c, -1};
  if (halved[at(c)]) pieces.push_back({3 + a, c, 3 + c, -1});
  return pieces;
}

/// One cell and its pieces.
class Cut {
 public:
  Cut(const Mesh& mesh, const EdgeMidpoints& edges, Index cell)
      : mesh_(mesh), edges_(edges), cell_(cell), n_(mesh.corners(cell)) {
    const auto halved = [&](int side) { return edges.halves({cell, side}); };
    pieces_ = n_ == 4
                  ? pieces_of_quadrilateral(halved(0), halved(1))
                  : pieces_of_triangle(longest_side(mesh, cell), {halved(0), halved(1), halved(2)});
  }

  [[nodiscard]] const Pieces& pieces() const { return pieces_; }

  /// Nodes of the pieces, one row each.
  /// \param next    number of the first node inside the cell
  /// \param inside  gets the positions of those
  [[nodiscard]] CellArray cells(Index next, std::vector<Vector2d>& inside) const {
    const Index width = mesh_.cells.cols();
    CellArray cells = CellArray::Constant(static_cast<Index>(pieces_.size()), width, -1);
    std::vector<std::pair<int, Index>>
        made;  // twice the place in the cell as one number, and the node
    const auto node = [&](Point p, Point q) {
      const Index known = on_side(p, q);
      if (known >= 0) return known;
      const int key = std::min(p, q) + 16 * std::max(p, q);
      for (const auto& [other, number] : made)
        if (other == key) return number;
      made.emplace_back(key, next + static_cast<Index>(inside.size()));
      inside.push_back(place(p, q));
      return made.back().second;
    };
    for (Index k = 0; k < cells.rows(); ++k) {
      const std::array<Point, 4>& corner = pieces_[at(k)];
      for (int j = 0; j < n_; ++j) {
        cells(k, j) = node(corner[at(j)], corner[at(j)]);
        if (width > 4) cells(k, n_ + j) = node(corner[at(j)], corner[at((j + 1) % n_)]);
      }
    }
    return cells;
  }

  /// What becomes of a side, in walking order.
  /// \param first  number of the first piece
  [[nodiscard]] std::vector<CellSide> sides(int side, Index first) const {
    const Point next = (side + 1) % n_;
    std::vector<CellSide> found;
    for (const auto& [p, q] :
         edges_.halves({cell_, side})
             ? std::vector<std::pair<Point, Point>>{{side, n_ + side}, {n_ + side, next}}
             : std::vector<std::pair<Point, Point>>{{side, next}})
      for (std::size_t k = 0; k < pieces_.size(); ++k)
        for (int j = 0; j < n_; ++j)
          if (pieces_[k][at(j)] == p && pieces_[k][at((j + 1) % n_)] == q)
            found.push_back({first + static_cast<Index>(k), j});
    return found;
  }

 private:
  /// The node between two points, or at one, if it is a node of a side of the cell; else -1.
  [[nodiscard]] Index on_side(Point p, Point q) const {
    if (p > q) std::swap(p, q);
    if (q < n_) {
      if (p == q) return mesh_.cells(cell_, p);
      return mesh_.cells(cell_, n_ + ((p + 1) % n_ == q ? p : q));  // a whole side
    }
    const int side = q - n_;
    if (side >= n_) return -1;
    if (p == q) return edges_.node({cell_, side}, 1);
    if (p == side) return edges_.node({cell_, side}, 0);
    return p == (side + 1) % n_ ? edges_.node({cell_, side}, 2) : -1;
  }

  /// The point of a side at -1, -1/2, 0, 1/2 or 1 less the first corner of the cell.
  [[nodiscard]] Vector2d way(int side, double xi) const {
    const Point first = side;
    const Point last = (side + 1) % n_;
    const auto node = [&](Index number) -> Vector2d {
      return edges_.nodes().row(number) - mesh_.nodes.row(mesh_.cells(cell_, 0));
    };
    if (std::abs(xi) == 1) return node(mesh_.cells(cell_, xi < 0 ? first : last));
    if (edges_.halves({cell_, side}))
      return node(edges_.node({cell_, side}, xi < 0 ? 0 : xi > 0 ? 2 : 1));
    if (mesh_.order() == MeshOrder::Quadratic) return node(mesh_.cells(cell_, n_ + side));
    return (way(side, -1) + way(side, 1)) / 2;
  }

  /// Where a node inside a cell goes that lies between two of its points: of a quadrilateral, between its four sides
  /// as they are now; of a triangle, where its shape functions have it.
  [[nodiscard]] Vector2d place(Point p, Point q) const {
    const Vector2d origin = mesh_.nodes.row(mesh_.cells(cell_, 0));
    if (n_ == 4) {
      const Vector2d local = (in_square(p) + in_square(q)) / 2;
      const double x = local.x();
      const double y = local.y();
      const Vector2d between_sides = (1 - y) / 2 * way(0, x) + (1 + y) / 2 * way(2, -x) +
                                     (1 + x) / 2 * way(1, y) + (1 - x) / 2 * way(3, -y);
      const Vector2d bilinear =
          (1 - x) * (1 - y) / 4 * way(0, -1) + (1 + x) * (1 - y) / 4 * way(1, -1) +
          (1 + x) * (1 + y) / 4 * way(2, -1) + (1 - x) * (1 + y) / 4 * way(3, -1);
      return origin + (between_sides - bilinear);
    }
    const Eigen::Vector3d L = (in_triangle(p) + in_triangle(q)) / 2;
    Vector2d sum = Vector2d::Zero();
    for (int k = 0; k < 3; ++k) {
      sum += L(k) * (2 * L(k) - 1) * way(k, -1);
      sum += 4 * L(k) * L((k + 1) % 3) * old_middle(k);
    }
    return origin + sum;
  }

  [[nodiscard]] Vector2d old_middle(int side) const {
    return mesh_.nodes.row(mesh_.cells(cell_, n_ + side)) - mesh_.nodes.row(mesh_.cells(cell_, 0));
  }

  static Vector2d in_square(Point p) {
    static const double place[9][2] = {{-1, -1}, {1, -1}, {1, 1},  {-1, 1}, {0, -1},
                                       {1, 0},   {0, 1},  {-1, 0}, {0, 0}};
    return {place[p][0], place[p][1]};
  }

  static Eigen::Vector3d in_triangle(Point p) {
    if (p < 3) return Eigen::Vector3d::Unit(p);
    return (Eigen::Vector3d::Unit(p - 3) + Eigen::Vector3d::Unit((p - 2) % 3)) / 2;
  }

  const Mesh& mesh_;
  const EdgeMidpoints& edges_;
  Index cell_;
  int n_;
  Pieces pieces_;
};

}  // namespace

HalvedMesh halved_once(const Mesh& mesh, const MarkedEdges& marks) {
  const std::vector<char> times = closed_under_halving(mesh, marks.edges, marks.halved);
  const EdgeMidpoints on_edges(mesh, marks.edges, times);
  std::vector<Cut> cuts;
  std::vector<Index> first = {0};
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    cuts.emplace_back(mesh, on_edges, cell);
    first.push_back(first.back() + static_cast<Index>(cuts.back().pieces().size()));
  }
  Mesh result;
  result.name = mesh.name;
  result.cells.resize(first.back(), mesh.cells.cols());
  std::vector<Vector2d> inside;
  for (std::size_t cell = 0; cell < cuts.size(); ++cell) {
    const CellArray cells = cuts[cell].cells(on_edges.nodes().rows(), inside);
    result.cells.middleRows(first[cell], cells.rows()) = cells;
  }
  result.nodes = on_edges.nodes();
  result.nodes.conservativeResize(result.nodes.rows() + static_cast<Index>(inside.size()), 2);
  for (std::size_t k = 0; k < inside.size(); ++k)
    result.nodes.row(on_edges.nodes().rows() + static_cast<Index>(k)) = inside[k];
  for (const auto& [name, sides] : mesh.boundaries)
    for (const CellSide& side : sides)
      for (const CellSide& half : cuts[at(side.cell)].sides(side.side, first[at(side.cell)]))
        result.boundaries[name].push_back(half);
  for (const auto& [name, cells] : mesh.regions)
    for (const Index cell : cells)
      for (Index piece = first[at(cell)]; piece < first[at(cell) + 1]; ++piece)
        result.regions[name].push_back(piece);
  MarkedEdges again = marked_alike(result, 0);
  for (std::size_t edge = 0; edge < times.size(); ++edge) {
    if (times[edge] < 2) continue;
    const CellSide& side = marks.edges.sides[edge][0];
    for (const CellSide& half : cuts[at(side.cell)].sides(side.side, first[at(side.cell)]))
      again.halved[at(again.edges.at(half))] = static_cast<char>(times[edge] - 1);
  }
  return {std::move(result), std::move(again)};
}

Mesh refined_mesh(const Mesh& mesh, const MeshEdges& edges, std::vector<char> halved) {
  return halved_once(mesh, {edges, std::move(halved)}).mesh;
}

Mesh refined_mesh(const Mesh& mesh) { return halved_once(mesh, marked_alike(mesh, 1)).mesh; }

}  // namespace signorini

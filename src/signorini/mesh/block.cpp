#include "signorini/mesh/block.hpp"

#include <cmath>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Numbers the nodes of a block: corners on even, midpoints on odd places of a lattice of half steps.
class Lattice {
 public:
  Lattice(Index cells_x, Index cells_y, MeshOrder order)
      : cells_x_(cells_x), cells_y_(cells_y), quadratic_(order == MeshOrder::Quadratic) {}

  [[nodiscard]] Index n_nodes() const { return row_start(2 * cells_y_ + 1); }
  /// Number of the node at half steps (i, j).
  [[nodiscard]] Index node(Index i, Index j) const {
    return row_start(j) + (quadratic_ && j % 2 == 0 ? i : i / 2);
  }

 private:
  /// Nodes in the lattice rows below j. Full rows alternate with rows of midpoints.
  [[nodiscard]] Index row_start(Index j) const {
    const Index full = quadratic_ ? 2 * cells_x_ + 1 : cells_x_ + 1;
    const Index between = quadratic_ ? cells_x_ + 1 : 0;
    return (j + 1) / 2 * full + j / 2 * between;
  }
  Index cells_x_;
  Index cells_y_;
  bool quadratic_;
};

/// Position at half step i of a row of steps.
double at_half(const Eigen::VectorXd& steps, Index i) {
  return i % 2 == 0 ? steps(i / 2) : 0.5 * (steps(i / 2) + steps(i / 2 + 1));
}

}  // namespace

Eigen::VectorXd graded_steps(Index n, double grading) {
  require(n > 0, "graded_steps: need at least one step, got ", n);
  require(grading > 0 && std::isfinite(grading), "graded_steps: grading must be positive, got ",
          grading);
  Eigen::VectorXd position = Eigen::VectorXd::LinSpaced(n + 1, 0, 1);
  if (n == 1 || grading == 1) return position;
  const double ratio = std::pow(grading, 1 / static_cast<double>(n - 1));
  double step = 1;
  for (Index i = 1; i <= n; ++i, step *= ratio) position(i) = position(i - 1) + step;
  return position / position(n);
}

Mesh make_block(const BlockSpec& spec) {
  require(spec.size.minCoeff() > 0 && spec.size.allFinite() && spec.corner.allFinite(),
          "make_block '", spec.name, "': width and height must be positive, got ", spec.size.x(),
          " x ", spec.size.y());
  require(spec.cells_x > 0 && spec.cells_y > 0, "make_block '", spec.name,
          "': need at least one cell in each direction, got ", spec.cells_x, " x ", spec.cells_y);
  const Lattice lattice(spec.cells_x, spec.cells_y, spec.order);
  const Eigen::VectorXd x =
      spec.corner.x() + spec.size.x() * graded_steps(spec.cells_x, spec.grading_x).array();
  const Eigen::VectorXd y =
      spec.corner.y() + spec.size.y() * graded_steps(spec.cells_y, spec.grading_y).array();
  const bool quadratic = spec.order == MeshOrder::Quadratic;

  Mesh mesh;
  mesh.name = spec.name;
  mesh.nodes.resize(lattice.n_nodes(), 2);
  for (Index j = 0; j <= 2 * spec.cells_y; ++j)
    for (Index i = 0; i <= 2 * spec.cells_x; ++i) {
      const bool corner = i % 2 == 0 && j % 2 == 0;
      const bool midpoint = quadratic && i % 2 != j % 2;
      if (corner || midpoint) mesh.nodes.row(lattice.node(i, j)) << at_half(x, i), at_half(y, j);
    }

  mesh.cells.resize(spec.cells_x * spec.cells_y, quadratic ? 8 : 4);
  for (Index cy = 0; cy < spec.cells_y; ++cy)
    for (Index cx = 0; cx < spec.cells_x; ++cx) {
      const Index cell = cy * spec.cells_x + cx;
      const Index i = 2 * cx;
      const Index j = 2 * cy;
      mesh.cells.row(cell).head<4>() << lattice.node(i, j), lattice.node(i + 2, j),
          lattice.node(i + 2, j + 2), lattice.node(i, j + 2);
      if (quadratic)
        mesh.cells.row(cell).tail<4>() << lattice.node(i + 1, j), lattice.node(i + 2, j + 1),
            lattice.node(i + 1, j + 2), lattice.node(i, j + 1);
    }

  const Index top_row = (spec.cells_y - 1) * spec.cells_x;
  for (Index c = 0; c < spec.cells_x; ++c) {
    mesh.boundaries["bottom"].push_back({c, 0});
    mesh.boundaries["top"].push_back({top_row + spec.cells_x - 1 - c, 2});
  }
  for (Index c = 0; c < spec.cells_y; ++c) {
    mesh.boundaries["right"].push_back({c * spec.cells_x + spec.cells_x - 1, 1});
    mesh.boundaries["left"].push_back({(spec.cells_y - 1 - c) * spec.cells_x, 3});
  }
  return mesh;
}

Mesh mapped(Mesh mesh, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map) {
  for (Index node = 0; node < mesh.n_nodes(); ++node) {
    const Eigen::Vector2d image = map(mesh.nodes.row(node).transpose());
    mesh.nodes.row(node) = image.transpose();
  }
  return mesh;
}

}  // namespace signorini

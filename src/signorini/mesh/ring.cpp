#include "signorini/mesh/ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;

const double pi = std::acos(-1.0);

/// Numbers the nodes ray by ray, outwards; half rays hold midpoints only.
class RayLattice {
 public:
  RayLattice(Index rays, Index steps, bool closed, bool quadratic)
      : rays_(rays), steps_(steps), closed_(closed), quadratic_(quadratic) {}

  [[nodiscard]] Index n_nodes() const { return ray_start(closed_ ? 2 * rays_ : 2 * rays_ + 1); }
  /// Whether there is a node at half ray i and half step j.
  [[nodiscard]] bool has(Index i, Index j) const {
    return quadratic_ ? i % 2 == 0 || j % 2 == 0 : i % 2 == 0 && j % 2 == 0;
  }
  /// Its number.
  [[nodiscard]] Index node(Index i, Index j) const {
    const Index ray = closed_ && i == 2 * rays_ ? 0 : i;
    return ray_start(ray) + (quadratic_ && ray % 2 == 0 ? j : j / 2);
  }

 private:
  /// Nodes on the half rays below i.
  [[nodiscard]] Index ray_start(Index i) const {
    const Index full = quadratic_ ? 2 * steps_ + 1 : steps_ + 1;
    const Index between = quadratic_ ? steps_ + 1 : 0;
    return (i + 1) / 2 * full + i / 2 * between;
  }
  Index rays_;
  Index steps_;
  bool closed_;
  bool quadratic_;
};

}  // namespace

double opening(Sector sector) {
  return sector == Sector::Quarter ? pi / 2 : sector == Sector::Half ? pi : 2 * pi;
}

Eigen::VectorXd ray_directions(const Eigen::VectorXd& rays, Index cells, Sector sector) {
  const double last = opening(sector);
  require(cells > 0 && (rays.size() == 0 || rays.size() == cells + 1),
          "rays: need at least one cell along the angle and one ray more than cells, got ", cells,
          " cells and ", rays.size(), " rays");
  const Eigen::VectorXd even = Eigen::VectorXd::LinSpaced(cells + 1, 0, last);
  const Eigen::VectorXd& given = rays.size() == 0 ? even : rays;
  const Eigen::VectorXd step = given.tail(cells) - given.head(cells);
  require(step.minCoeff() > 0 && step.maxCoeff() < pi && std::abs(given(0)) < 1e-12 &&
              std::abs(given(cells) - last) < 1e-12,
          "rays: directions must increase from 0 to ", last,
          " in steps below half a turn; they run from ", given(0), " to ", given(cells),
          " in steps of ", step.minCoeff(), " to ", step.maxCoeff());
  Eigen::VectorXd directions(2 * cells + 1);
  for (Index i = 0; i <= 2 * cells; ++i)
    directions(i) = i % 2 == 0 ? given(i / 2) : 0.5 * (given(i / 2) + given(i / 2 + 1));
  return directions;
}

Eigen::VectorXd rays_by_quadrant(const std::vector<Index>& cells) {
  require((cells.size() == 1 || cells.size() == 2 || cells.size() == 4) &&
              *std::min_element(cells.begin(), cells.end()) > 0,
          "rays_by_quadrant: need at least one cell in each of 1, 2 or 4 quadrants");
  Eigen::VectorXd rays(std::accumulate(cells.begin(), cells.end(), Index{1}));
  Index ray = 0;
  for (std::size_t quadrant = 0; quadrant < cells.size(); ++quadrant)
    for (Index k = 0; k < cells[quadrant]; ++k)
      rays(ray++) = pi / 2 *
                    (static_cast<double>(quadrant) +
                     static_cast<double>(k) / static_cast<double>(cells[quadrant]));
  rays(ray) = pi / 2 * static_cast<double>(cells.size());
  return rays;
}

Eigen::RowVector2d unit_vector(double angle) {
  const double none = 8 * std::numeric_limits<double>::epsilon();
  const auto clean = [none](double value) { return std::abs(value) < none ? 0 : value; };
  return {clean(std::cos(angle)), clean(std::sin(angle))};
}

Mesh make_ring_of_rays(const std::string& name, const NodeArray& inner, const NodeArray& outer,
                       const Eigen::VectorXd& steps, Sector sector, MeshOrder order) {
  const Index n = inner.rows() / 2;
  const Index m = steps.size() - 1;
  const bool closed = sector == Sector::Full;
  const bool quadratic = order == MeshOrder::Quadratic;
  const RayLattice lattice(n, m, closed, quadratic);
  Mesh mesh;
  mesh.name = name;
  mesh.nodes.resize(lattice.n_nodes(), 2);
  for (Index i = 0; i < (closed ? 2 * n : 2 * n + 1); ++i)
    for (Index j = 0; j <= 2 * m; ++j) {
      if (!lattice.has(i, j)) continue;
      const double z = j % 2 == 0 ? steps(j / 2) : 0.5 * (steps(j / 2) + steps(j / 2 + 1));
      mesh.nodes.row(lattice.node(i, j)) = (1 - z) * inner.row(i) + z * outer.row(i);
    }

  mesh.cells.resize(n * m, quadratic ? 8 : 4);
  for (Index ray = 0; ray < n; ++ray)
    for (Index step = 0; step < m; ++step) {
      const Index cell = ray * m + step;
      const Index i = 2 * ray;
      const Index j = 2 * step;
      mesh.cells.row(cell).head<4>() << lattice.node(i, j), lattice.node(i, j + 2),
          lattice.node(i + 2, j + 2), lattice.node(i + 2, j);
      if (quadratic)
        mesh.cells.row(cell).tail<4>() << lattice.node(i, j + 1), lattice.node(i + 1, j + 2),
            lattice.node(i + 2, j + 1), lattice.node(i + 1, j);
    }

  for (Index ray = 0; ray < n; ++ray) {
    mesh.boundaries["outer"].push_back({ray * m + m - 1, 1});
    mesh.boundaries["inner"].push_back({(n - 1 - ray) * m, 3});
  }
  for (Index step = 0; step < m && !closed; ++step) {
    mesh.boundaries["start"].push_back({step, 0});
    mesh.boundaries["end"].push_back({(n - 1) * m + m - 1 - step, 2});
  }
  return mesh;
}

void rename_boundary(Mesh& mesh, const std::string& from, const std::string& to) {
  const auto found = mesh.boundaries.find(from);
  if (found == mesh.boundaries.end()) return;
  const std::vector<CellSide> sides = found->second;
  mesh.boundaries.erase(found);
  std::vector<CellSide>& target = mesh.boundaries[to];
  target.insert(target.end(), sides.begin(), sides.end());
}

}  // namespace signorini

#include "signorini/mesh/ring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "signorini/core/errors.hpp"
#include "signorini/mesh/lattice.hpp"

namespace signorini {
namespace {

using Eigen::Index;

const double pi = std::acos(-1.0);

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
  const Lattice lattice{steps.size() - 1, inner.rows() / 2, order, sector == Sector::Full};
  Mesh mesh = make_lattice(name, lattice, [&](Index i, Index j) -> Eigen::RowVector2d {
    const double z = at_half(steps, i);
    return (1 - z) * inner.row(j) + z * outer.row(j);
  });
  rename_boundary(mesh, "bottom", "start");
  rename_boundary(mesh, "right", "outer");
  rename_boundary(mesh, "top", "end");
  rename_boundary(mesh, "left", "inner");
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

#include "signorini/report/field_csv.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

namespace {

using Polygon = std::vector<Eigen::Vector3d>;  // x, y, value of its corners

// What lies above a level (sign 1) or below it (sign -1), after Sutherland and Hodgman.
Polygon beyond(const Polygon& polygon, double level, double sign) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector3d &here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
    const double a = sign * (here.z() - level), b = sign * (next.z() - level);
    if (a >= 0) kept.push_back(here);
    if (a * b >= 0) continue;
    kept.push_back(here + a / (a - b) * (next - here));
    kept.back().z() = level;
  }
  return kept;
}

// Rounding must not decide on which side of a level a node lies.
double snapped(double value, const Eigen::VectorXd& levels) {
  const double close = 1e-9 * (levels(levels.size() - 1) - levels(0));
  for (const double level : levels)
    if (std::abs(value - level) < close) return level;
  return value;
}

}  // namespace

std::string deformed_cells_csv(const Mesh& mesh, const NodeArray& displacements,
                               const Eigen::Ref<const Eigen::VectorXd>& value, double scale) {
  require(displacements.rows() == mesh.n_nodes() && value.size() == mesh.n_cells(),
          "deformed_cells_csv: need ", mesh.n_nodes(), " displacements and ", mesh.n_cells(),
          " values, got ", displacements.rows(), " and ", value.size());
  const NodeArray moved = mesh.nodes + scale * displacements;
  const double size = moved.cwiseAbs().maxCoeff();
  const double largest = value.size() > 0 ? value.cwiseAbs().maxCoeff() : 0;
  Table field({"x", "y", "value"});
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell) {
    for (const Eigen::Index corner : {0, 1, 2, 3, 0}) {
      const Eigen::Index node = mesh.cells(cell, corner);
      field.row({number(moved(node, 0), "%.5g"), number(moved(node, 1), "%.5g"),
                 number(value(cell), "%.5g")});
    }
    field.blank_line();
  }
  return field.csv(text("rel 1e-4 abs ", 2e-5 * std::max(size, largest)));
}

std::string deformed_bands_csv(const Mesh& mesh, const NodeArray& displacements,
                               const Eigen::Ref<const Eigen::VectorXd>& value,
                               const Eigen::Ref<const Eigen::VectorXd>& levels, double scale) {
  require(displacements.rows() == mesh.n_nodes() && value.size() == mesh.n_nodes(),
          "deformed_bands_csv: need ", mesh.n_nodes(), " displacements and values, got ",
          displacements.rows(), " and ", value.size());
  const Eigen::Index n_bands = levels.size() - 1;
  require(n_bands >= 1, "deformed_bands_csv: need two levels or more, got ", levels.size());
  const NodeArray moved = mesh.nodes + scale * displacements;
  const double size = moved.cwiseAbs().maxCoeff();
  Table field({"x", "y", "value"});
  for (Eigen::Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (Eigen::Index band = 0; band < n_bands; ++band) {
      Polygon part;
      for (Eigen::Index corner = 0; corner < 4; ++corner) {
        const Eigen::Index node = mesh.cells(cell, corner);
        part.emplace_back(moved(node, 0), moved(node, 1), snapped(value(node), levels));
      }
      if (band > 0) part = beyond(part, levels(band), 1);
      if (band + 1 < n_bands) part = beyond(part, levels(band + 1), -1);
      if (part.size() < 3) continue;
      part.push_back(part.front());
      for (const Eigen::Vector3d& corner : part)
        field.row({number(corner.x(), "%.5g"), number(corner.y(), "%.5g"),
                   number((levels(band) + levels(band + 1)) / 2, "%.5g")});
      field.blank_line();
    }
  return field.csv(text("rel 1e-4 abs ", 2e-5 * size));
}

}  // namespace signorini

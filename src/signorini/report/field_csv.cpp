#include "signorini/report/field_csv.hpp"

#include <algorithm>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

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

}  // namespace signorini

// Chapter 0 - The sides of all cells, as lines of a picture.
#pragma once
#include <string>

#include "finite_elements.hpp"
#include "signorini/core/table.hpp"

namespace ch00 {

/// \param mesh  nodes and cells \param u  x, y of every node in turn [mm] \return the moved nodes, one row each [mm]
inline Points moved(const Mesh& mesh, const VectorXd& u) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
  return mesh.nodes + Eigen::Map<const Rows>(u.data(), mesh.nodes.rows(), 2);
}

/// \param mesh  of which the cells count \param places  of its nodes [mm] \return a closed line for each cell, as csv
inline std::string outline(const Mesh& mesh, const Points& places) {
  signorini::Table lines({"x", "y"});
  for (const auto& cell : mesh.cells.rowwise()) {
    for (const Index corner : {0, 1, 2, 3, 0})
      lines.row({places(cell(corner), 0), places(cell(corner), 1)});
    lines.blank_line();
  }
  return lines.csv();
}

}  // namespace ch00

/// \file
/// A field on the deformed mesh as data for gnuplot.
#pragma once
#include <Eigen/Core>
#include <string>

#include "signorini/mesh/mesh.hpp"

namespace signorini {

/// One closed polygon per cell, with one value, separated by empty lines.
///
/// Columns x, y (deformed position, scaled displacements added), value; for
/// `plot ... using 'x':'y':'value' with polygons fc palette`.
/// \param mesh           of 4- or 8-node cells; only corners are drawn
/// \param displacements  `n_nodes x 2` [length]
/// \param value          `n_cells`, one per cell
/// \param scale          factor on the displacements [-]
/// \return comma separated text with 5 digits, with a tolerance of two units in the last one
/// \throws std::invalid_argument if sizes differ
[[nodiscard]] std::string deformed_cells_csv(const Mesh& mesh, const NodeArray& displacements,
                                             const Eigen::Ref<const Eigen::VectorXd>& value,
                                             double scale = 1);

}  // namespace signorini

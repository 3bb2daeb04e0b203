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

/// Polygons between two levels of a field that is given at the nodes, separated by empty lines.
///
/// Columns as in deformed_cells_csv(), with the middle of the two levels as value. Along the sides of a cell
/// the field is straight, and so is a level line through a cell.
/// \param mesh           of 4- or 8-node cells; only corners are drawn
/// \param displacements  `n_nodes x 2` [length]
/// \param value          `n_nodes`, one per node
/// \param levels         increasing; values below the first belong to the first band, above the last to the last
/// \param scale          factor on the displacements [-]
/// \return comma separated text with 5 digits, with a tolerance of two units in the last one
/// \throws std::invalid_argument if sizes differ or there are fewer than two levels
[[nodiscard]] std::string deformed_bands_csv(const Mesh& mesh, const NodeArray& displacements,
                                             const Eigen::Ref<const Eigen::VectorXd>& value,
                                             const Eigen::Ref<const Eigen::VectorXd>& levels,
                                             double scale = 1);

}  // namespace signorini

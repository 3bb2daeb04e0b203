/// \file
/// A field on the deformed mesh as data for gnuplot.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// One closed polygon per cell, with one value, separated by empty lines.
///
/// Columns x, y (deformed position, scaled displacements added), value; for
/// `plot ... using 'x':'y':'value' with polygons fc palette`.
/// \param mesh           any; only corners are drawn
/// \param displacements  `n_nodes x 2` [length]
/// \param value          `n_cells`, one per cell
/// \param scale          factor on the displacements [-]
/// \return comma separated text with 5 digits, with a tolerance of two units in the last one
/// \throws std::invalid_argument if sizes differ
[[nodiscard]] std::string deformed_cells_csv(const Mesh& mesh, const NodeArray& displacements,
                                             const Eigen::Ref<const Eigen::VectorXd>& value,
                                             double scale = 1);

/// Bands of a field on the deformed mesh: every cell that a level crosses is cut along it.
///
/// Within a quadrilateral the field is linear on each of four triangles about the middle, whose value is the
/// mean of the corners; within a triangle it is linear. One closed polygon per piece, separated by empty lines. Columns x, y (as in
/// deformed_cells_csv()), band: k where k levels are below the field, so 0 below the first one and
/// `n_levels` above the last; for `plot ... using 'x':'y':'band' with polygons fc palette`.
/// \param mesh           any; only corners are drawn
/// \param displacements  `n_nodes x 2` [length]
/// \param value          `n_nodes`, the field at the nodes
/// \param levels         `n_levels`, ascending; one that a value meets to rounding is met exactly
/// \param scale          factor on the displacements [-]
/// \return comma separated text with 5 digits, with a tolerance of two units in the last one
/// \throws std::invalid_argument if sizes differ or the levels do not ascend
[[nodiscard]] std::string deformed_bands_csv(const Mesh& mesh, const NodeArray& displacements,
                                             const Eigen::Ref<const Eigen::VectorXd>& value,
                                             const std::vector<double>& levels, double scale = 1);

/// What presses on a surface, place by place, for arrows in a figure.
///
/// Columns x, y (where an arrow ends), px, py (its vector); figures/style.gp draws them.
/// \param place     `n x 2` on the deformed surface [length]
/// \param normal    `n x 2` the way the pressure pushes [-]: Pairs::normal if the surface is the source's
/// \param pressure  `n` [force/length^2], compression > 0
/// \return comma separated text with 5 digits, with a tolerance of two units in the last one
/// \throws std::invalid_argument if sizes differ
[[nodiscard]] std::string pressure_arrows_csv(const NodeArray& place, const NodeArray& normal,
                                              const Eigen::Ref<const Eigen::VectorXd>& pressure);

}  // namespace signorini

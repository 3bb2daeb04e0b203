/// \file
/// Where a field changes its sign, as data for gnuplot.
#pragma once
#include <Eigen/Core>
#include <string>

#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Where a field on the deformed mesh changes its sign: segments, separated by empty lines.
///
/// Every quadrilateral is cut into four triangles about its middle, which has the mean of its corners, and the
/// field is linear on each. Columns x, y; for `plot ... using 'x':'y' with lines` over
/// deformed_cells_csv().
/// \param mesh           any; only corners count
/// \param displacements  `n_nodes x 2` [length]
/// \param value          `n_nodes`, one per node; zero counts as positive
/// \param scale          factor on the displacements [-]
/// \return comma separated text with 5 digits and the tolerance of deformed_cells_csv(); without a
///   change of sign the names of the columns alone
/// \throws std::invalid_argument if sizes differ
[[nodiscard]] std::string deformed_zero_line_csv(const Mesh& mesh, const NodeArray& displacements,
                                                 const Eigen::Ref<const Eigen::VectorXd>& value,
                                                 double scale = 1);

}  // namespace signorini

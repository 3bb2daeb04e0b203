/// \file
/// Bilinear shape functions, shared by the three four-node elements.
#pragma once
#include "signorini/elasticity/element.hpp"

namespace signorini {

/// \f$ N_k = (1 + \xi_k \xi)(1 + \eta_k \eta) / 4 \f$ of the four corners, and its slopes.
/// \param xi   first coordinate in the reference square [-]
/// \param eta  second coordinate [-]
/// \return 4 values and slopes
[[nodiscard]] Shape bilinear_shape(double xi, double eta);

/// The plain strain operator at the 2 x 2 Gauss points.
/// \param nodes   `4 x 2` positions [length]
/// \param points  receives 4 points
void bilinear_strain(const CellNodes& nodes, StrainPoints& points);

}  // namespace signorini

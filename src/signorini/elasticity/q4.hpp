/// \file
/// Bilinear shape functions, shared by the three four-node elements.
#pragma once
#include "signorini/elasticity/element.hpp"

namespace signorini {

/// N_k = (1 + xi_k xi)(1 + eta_k eta) / 4 and its slopes.
[[nodiscard]] Shape bilinear_shape(double xi, double eta);

/// The plain strain operator at the 2 x 2 Gauss points.
void bilinear_strain(const CellNodes& nodes, StrainPoints& points);

}  // namespace signorini

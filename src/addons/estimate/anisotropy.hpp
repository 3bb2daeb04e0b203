// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// In which direction cells are too coarse.
#pragma once
#include <Eigen/Core>

#include "addons/estimate/recovery.hpp"

namespace signorini {

/// Which share of a cell's part of error_products() more cells along its sides 0 and 2 would remove, not along 1 and 3:
/// by how the recovered stresses of both fields vary that way, corner to corner.
/// \param fields  u, then one or more z
/// \param stress  recovered() of them
/// \return `n_cells x n_z` shares from 0 to 1 [-]; 1/2 where neither way varies, 1 of triangles
[[nodiscard]] Eigen::MatrixXd anisotropic_indicator(const PrimalAndDuals& fields,
                                                    const SmoothStress& stress);

}  // namespace signorini

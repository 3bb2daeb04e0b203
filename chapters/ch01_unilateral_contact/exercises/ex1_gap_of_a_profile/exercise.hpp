/// \file
/// Exercise 1.1 - the gap above a curved floor, and its rows of A. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <functional>

#include "signorini/fem/mesh.hpp"

namespace ex1_1 {

/// Linear gaps of some points: gap = initial_gap - A u.
struct LinearGaps {
  Eigen::VectorXd initial_gap;  ///< `n_c` [length], open > 0, overlap < 0
  Eigen::MatrixXd A;            ///< `n_c x 2 n_c` [-]; u = (x, y of point 0, x, y of point 1, ...)
};

/// Gaps between points and the rigid floor below the curve y = f(x).
///
/// \PaperEq{XuanLi2002, 2} repaired. With the unit normal n out of the floor at the x of the point,
/// the gap is the height of the point above the curve, measured along n:
/// \f[ g = n_y\,(y - f(x)), \f]
/// and a displacement u of the point opens it by n . u.
/// \param points `n_c x 2`  where the points are before loading [length]
/// \param height            f(x) [length]
/// \param slope             f'(x) [-]; of any size and sign
/// \return initial gaps and the matrix A, one row per point
/// \throws signorini::ProblemError if a height or slope is not finite
[[nodiscard]] LinearGaps profile_gaps(const signorini::NodeArray& points,
                                      const std::function<double(double)>& height,
                                      const std::function<double(double)>& slope);

}  // namespace ex1_1

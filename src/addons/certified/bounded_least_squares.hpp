// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Least squares with bounds: how near what weights can give comes to what is wanted.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// Directions that weights from 0 to so much add up, and what they should give.
struct BoundedWeights {
  Eigen::MatrixXd direction;  ///< D `m x k`, one row each
  Eigen::VectorXd most;       ///< of the weights `m`, may be infinite [-]
  Eigen::VectorXd target;     ///< t `k`
};

/// Finds the least \f$ |D^T w - t| \f$ with \f$ 0 \le w \le most \f$ [\ref LawsonHanson1995]: the weight that gains most leaves its
/// bound, the best weights of those at no bound follow, and go towards them as far as the bounds allow.
/// \param all  D, most and t
/// \return \f$ D^T w - t \f$ `k`, with the digits that the difference of two close numbers loses given back
[[nodiscard]] Eigen::VectorXd bounded_least_squares(const BoundedWeights& all);

}  // namespace signorini

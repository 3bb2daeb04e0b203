// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Scaling that rounds nothing.
#pragma once
#include <Eigen/Core>
#include <cmath>

namespace signorini {

/// \param scale  entries > 0
/// \return the nearest powers of two: multiplying by them rounds nothing
[[nodiscard]] inline Eigen::VectorXd powers_of_two(const Eigen::VectorXd& scale) {
  return scale.unaryExpr([](double s) { return std::exp2(std::round(std::log2(s))); });
}

}  // namespace signorini

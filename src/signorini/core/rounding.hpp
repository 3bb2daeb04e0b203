/// \file
/// Numbers and the few words with which sources speak of rounding.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "signorini/core/alignment.hpp"

namespace signorini {

/// The distance from 1 to the next double: twice what one rounding does.
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Half a turn [rad].
constexpr double pi = 3.14159265358979323846;

/// \param part   of something
/// \param whole  which it is measured by
/// \return part / whole; 0 if nothing is measured, even by nothing
inline double ratio(double part, double whole) { return part == 0 ? 0 : part / whole; }

/// \param v  any
/// \return the largest |v_i|, 0 if there are none
inline double largest(const Eigen::Ref<const Eigen::VectorXd>& v) {
  return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff();
}

/// \param scale  entries > 0
/// \return the nearest powers of two: multiplying by them rounds nothing
[[nodiscard]] inline Eigen::VectorXd powers_of_two(const Eigen::VectorXd& scale) {
  return scale.unaryExpr([](double s) { return std::exp2(std::round(std::log2(s))); });
}

}  // namespace signorini

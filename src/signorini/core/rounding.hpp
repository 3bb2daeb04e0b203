/// \file
/// The few words with which the sources of this room speak of rounding.
#pragma once
#include <Eigen/Core>
#include <limits>

namespace signorini {

/// The distance from 1 to the next double: twice what one rounding does.
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// \param part   of something
/// \param whole  which it is measured by
/// \return part / whole; 0 if nothing is measured, even by nothing
inline double ratio(double part, double whole) { return part == 0 ? 0 : part / whole; }

/// \param v  any
/// \return the largest |v_i|, 0 if there are none
inline double largest(const Eigen::Ref<const Eigen::VectorXd>& v) {
  return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff();
}

}  // namespace signorini

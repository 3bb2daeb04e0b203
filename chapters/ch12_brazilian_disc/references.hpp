/// \file
/// Chapter 12 - how far the references for the loaded diameter agree.
#pragma once
#include <cmath>

#include "reading.hpp"
#include "signorini/core/results.hpp"

namespace ch12 {

/// Forces along the radii, with the y components of the pressure of Hertz: pairs that squeeze the disc
/// across a diameter each, by Gauss' rule for an ellipse.
/// \param depth  on the loaded diameter, from the lower contact, at least b [mm]
/// \return stress across it [MPa]
inline double radial_across(double depth) {
  const int n = 100;  // to rounding
  double sum = 0;
  for (int k = 1; k <= n; ++k) {
    const double angle = k * std::acos(-1.0) / (n + 1);
    const double share = 2.0 / (n + 1) * std::sin(angle) * std::sin(angle);
    const double sine = b / R * std::cos(angle), cosine = std::sqrt(1 - sine * sine);
    const Eigen::Vector3d stress =
        line_loaded_disc_stress({R, share * P / cosine}, -sine * (depth - R), cosine * (depth - R));
    sum += cosine * cosine * stress[0] + sine * sine * stress[1] + 2 * sine * cosine * stress[2];
  }
  return sum;
}

/// \param across  stress across the loaded diameter as a function of the depth
/// \return depth where it turns from compression to tension [mm]
template <class Function>
double turning_depth(const Function& across) {
  double low = 2 * b, high = R;
  while (high - low > 1e-12 * R) (across((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return low;
}

/// Adds where tension begins, and what one reference says of another.
/// \param axis     of the solved disc
/// \param results  receives what is found
inline void compare_references(const Diameter& axis, Results& results) {
  const auto plane = [](double z) { return loaded_diameter_stress(plate, R, z)[0]; };
  const auto part = [](double stress) { return 100 * stress / strength; };
  double worst = 0;
  for (Index k = 0; k < axis.depth.size(); ++k) {
    const double z = std::min(axis.depth(k), 2 * R - axis.depth(k));
    if (z >= 2 * b) worst = std::max(worst, std::abs(axis.stress(k, 0) - plane(z)));
  }
  results.add("axis_error_plane", part(worst), "%");
  results.add("plane_at_2b", part(plane(2 * b) - exact_across(2 * b)), "%");
  results.add("radial_at_2b", part(exact_across(2 * b) - radial_across(2 * b)), "%");
  results.add("sign_change_exact", turning_depth(exact_across), "mm");
  results.add("sign_change_radial", turning_depth(radial_across), "mm");
  results.add("sign_change_plane", tension_depth(plate, R), "mm");
  results.add("sign_change_estimate", std::cbrt(R * b * b / 2), "mm");
}

}  // namespace ch12

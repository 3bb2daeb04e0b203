#include <cmath>

#include "exercise.hpp"

namespace ex22_1 {

double error_of_linear_gap(double way, double radius) {
  return way * (way / (std::hypot(radius, way) + radius));
}

double longest_way(double allowed, double radius) {
  return std::sqrt(allowed * (2 * radius + allowed));
}

int stretches(double way, double allowed, double radius) {
  return static_cast<int>(std::ceil(way / longest_way(allowed, radius)));
}

}  // namespace ex22_1

#include <cmath>

#include "exercise.hpp"

namespace ex8_1 {

namespace {

double cosine_less_one(double own, double other) {
  const double root = std::hypot(own, other);
  return own > 0 ? -(other / root) * (other / (root + own)) : own / root - 1;
}

}  // namespace

Slope slope(double a, double b) {
  if (a == 0 && b == 0) return {std::sqrt(0.5) - 1, std::sqrt(0.5) - 1};
  return {cosine_less_one(a, b), cosine_less_one(b, a)};
}

}  // namespace ex8_1

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex11_5 {

Orders orders(double power, double influence, int degree) {
  if (!(power > 0) || !(influence > 0) || !std::isfinite(power) || !std::isfinite(influence))
    throw std::invalid_argument("orders: a power is not positive");
  if (degree < 1) throw std::invalid_argument("orders: the degree is below 1");
  const double p = degree;
  // From everywhere h^p, from the last cells what the power leaves.
  return {std::min(p, power), std::clamp(power - 0.5, 0.0, p), std::min(2 * p, power + influence)};
}

double times_more_cells(double part, double order) {
  if (!(part > 0) || part > 1) throw std::invalid_argument("times_more_cells: no part of an error");
  if (!(order > 0) || !std::isfinite(order))
    throw std::invalid_argument("times_more_cells: the order is not positive");
  return std::pow(part, -2 / order);
}

}  // namespace ex11_5

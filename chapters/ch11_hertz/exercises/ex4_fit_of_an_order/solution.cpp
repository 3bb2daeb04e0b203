#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "exercise.hpp"

namespace ex11_4 {

static void require_row(const std::vector<Mesh>& meshes, double spread) {
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const bool falls = k == 0 || meshes[k].h < meshes[k - 1].h;
    if (!(meshes[k].h > 0) || !std::isfinite(meshes[k].h) || !falls)
      throw std::invalid_argument("fit_of_order: the sizes must be positive and fall");
    if (!std::isfinite(meshes[k].error))
      throw std::invalid_argument("fit_of_order: an error is not finite");
  }
  if (!(spread >= 0)) throw std::invalid_argument("fit_of_order: the spread is negative");
}

// Not a number if the two have no order.
static double order_between(const Mesh& coarse, const Mesh& fine) {
  const bool one_sign =
      (coarse.error > 0 && fine.error > 0) || (coarse.error < 0 && fine.error < 0);
  if (!one_sign) return std::numeric_limits<double>::quiet_NaN();
  return std::log(coarse.error / fine.error) / std::log(coarse.h / fine.h);
}

static double slope(const std::vector<Mesh>& meshes, std::size_t first, std::size_t count) {
  double x_mean = 0, y_mean = 0, products = 0, squares = 0;
  for (std::size_t k = first; k < first + count; ++k) {
    x_mean += std::log(meshes[k].h) / static_cast<double>(count);
    y_mean += std::log(std::abs(meshes[k].error)) / static_cast<double>(count);
  }
  for (std::size_t k = first; k < first + count; ++k) {
    const double x = std::log(meshes[k].h) - x_mean;
    products += x * (std::log(std::abs(meshes[k].error)) - y_mean);
    squares += x * x;
  }
  return products / squares;
}

Fit fit_of_order(const std::vector<Mesh>& meshes, double spread) {
  require_row(meshes, spread);
  Fit best;
  for (std::size_t first = 0; first + 1 < meshes.size(); ++first) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t last = first + 1; last < meshes.size(); ++last) {
      const double order = order_between(meshes[last - 1], meshes[last]);
      if (!(order > 0)) break;
      least = std::min(least, order);
      most = std::max(most, order);
      if (most - least > spread) break;
      const std::size_t count = last - first + 1;
      if (count >= 3 && count >= best.count) best = {0, first, count};
    }
  }
  if (best.count > 0) best.order = slope(meshes, best.first, best.count);
  return best;
}

}  // namespace ex11_4

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "exercise.hpp"

namespace ex13_4 {

Trend trend_of(const std::vector<double>& column) {
  if (column.size() < 3) throw std::invalid_argument("trend_of: needs three rows");
  if (!std::all_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); }))
    throw std::invalid_argument("trend_of: a number is not finite");
  const double* v = &column[column.size() - 3];
  const double before = v[1] - v[0], last = v[2] - v[1];
  Trend trend;
  if (last == 0) {
    trend.fate = Fate::Converges;
    trend.order = std::numeric_limits<double>::infinity();
    trend.limit = v[2];
  } else if (std::abs(last) < std::abs(before)) {
    const double ratio = last / before;
    trend.fate = Fate::Converges;
    trend.order = -std::log2(std::abs(ratio));
    trend.limit = v[2] + last * ratio / (1 - ratio);  // the geometric series of the next steps
  } else if (before * last > 0 && v[2] * last > 0 && v[0] * last >= 0) {
    trend.fate = Fate::Grows;
    trend.power = std::log2(v[2] / v[1]);
  }
  return trend;
}

}  // namespace ex13_4

#include <cmath>
#include <limits>
#include <stdexcept>

#include "exercise.hpp"

namespace ex16_1 {

double order(const std::vector<Point>& line) {
  if (line.size() < 2) throw std::invalid_argument("order: need at least two points");
  double cost = 0, error = 0;
  for (const Point& point : line) {
    if (!(point.cost > 0 && point.error > 0))
      throw std::invalid_argument("order: costs and errors must be above 0");
    cost += std::log(point.cost) / static_cast<double>(line.size());
    error += std::log(point.error) / static_cast<double>(line.size());
  }
  double products = 0, squares = 0;
  for (const Point& point : line) {
    const double x = std::log(point.cost) - cost;
    products += x * (std::log(point.error) - error);
    squares += x * x;
  }
  if (squares == 0) throw std::invalid_argument("order: all points cost the same");
  return -products / squares;
}

double price(const std::vector<Point>& line, double factor) {
  if (!(factor > 1)) throw std::invalid_argument("price: the factor must be above 1");
  const double power = order(line);
  return power > 0 ? std::pow(factor, 1 / power) : std::numeric_limits<double>::infinity();
}

}  // namespace ex16_1

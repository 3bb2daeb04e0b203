#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex12_3 {

static void require_line(const std::vector<Point>& line) {
  if (line.size() < 2) throw std::invalid_argument("a line has two points or more");
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (!std::isfinite(line[k].depth) || !std::isfinite(line[k].stress))
      throw std::invalid_argument("a number of the line is not finite");
    if (k > 0 && !(line[k].depth > line[k - 1].depth))
      throw std::invalid_argument("the depths of a line must rise");
  }
}

// Depth between two stresses of opposite sign where the line is zero.
static double crossing(const Point& a, const Point& b) {
  return a.depth + (b.depth - a.depth) * (a.stress / (a.stress - b.stress));
}

std::optional<double> tension_begins(const std::vector<Point>& line) {
  require_line(line);
  for (std::size_t k = line.size() - 1; k > 0; --k)
    if (line[k - 1].stress <= 0 && line[k].stress > 0) return crossing(line[k - 1], line[k]);
  return std::nullopt;
}

std::optional<double> even_from(const std::vector<Point>& line, double level, double share) {
  require_line(line);
  if (!std::isfinite(level) || !(share >= 0))
    throw std::invalid_argument("even_from: need a finite level and a share that is not negative");
  std::optional<double> from;
  for (std::size_t k = line.size(); k > 0; --k) {
    if (!(std::abs(line[k - 1].stress - level) <= share * std::abs(level))) break;
    from = line[k - 1].depth;
  }
  return from;
}

double pull(const std::vector<Point>& line) {
  require_line(line);
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    Point a = line[k - 1], b = line[k];
    if (a.stress <= 0 && b.stress <= 0) continue;
    if (a.stress < 0) a = {crossing(a, b), 0};
    if (b.stress < 0) b = {crossing(a, b), 0};
    sum += (b.depth - a.depth) * (a.stress + b.stress) / 2;
  }
  return sum;
}

double push(const std::vector<Point>& line) {
  std::vector<Point> turned = line;
  for (Point& point : turned) point.stress = -point.stress;
  return pull(turned);
}

}  // namespace ex12_3

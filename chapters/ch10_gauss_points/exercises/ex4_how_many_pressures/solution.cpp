#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exercise.hpp"

namespace ex10_4 {

static double tolerance(const Interface& nodes) {
  return 1e-9 * (nodes.source.back() - nodes.source.front());
}

// Where the gap may have a corner, its ends included.
static std::vector<double> corners(const Interface& nodes) {
  for (const std::vector<double>* side : {&nodes.source, &nodes.target}) {
    if (side->size() < 2) throw std::invalid_argument("a side needs two nodes");
    for (std::size_t k = 1; k < side->size(); ++k)
      if (!((*side)[k] > (*side)[k - 1])) throw std::invalid_argument("the nodes must rise");
  }
  const double same = tolerance(nodes);
  if (!(std::abs(nodes.source.front() - nodes.target.front()) <= same) ||
      !(std::abs(nodes.source.back() - nodes.target.back()) <= same))
    throw std::invalid_argument("the sides must have the same ends");
  std::vector<double> all = nodes.source;
  all.insert(all.end(), nodes.target.begin(), nodes.target.end());
  std::sort(all.begin(), all.end());
  const auto one = [same](double a, double b) { return b - a <= same; };
  all.erase(std::unique(all.begin(), all.end(), one), all.end());
  return all;
}

int most_felt(const Interface& nodes) { return static_cast<int>(corners(nodes).size()); }

int felt(const Interface& nodes, const std::vector<double>& points) {
  const std::vector<double> places = corners(nodes);
  const double same = tolerance(nodes);
  std::vector<bool> taken(places.size(), false);
  int count = 0;
  for (const double x : points) {
    if (!(x >= places.front() - same && x <= places.back() + same))
      throw std::invalid_argument("felt: a point lies beyond the ends");
    std::size_t k = 0;
    while (k + 1 < places.size() && places[k + 1] <= x + same) ++k;
    if (taken[k]) {
      if (x - places[k] <= same || k + 1 == places.size())
        continue;  // at a corner there is no other
      ++k;
    }
    if (taken[k]) continue;
    taken[k] = true;
    ++count;
  }
  return count;
}

double highest_alone(const std::vector<Point>& rule) {
  if (rule.size() < 2)
    throw std::invalid_argument("highest_alone: fewer than two points leave nothing free");
  double highest = 0;
  for (const Point& point : rule) {
    if (!(point.xi >= -1 && point.xi <= 1))
      throw std::invalid_argument("a place is not on the edge");
    if (!(point.weight > 0)) throw std::invalid_argument("a weight is not positive");
    const double N = (1 + std::abs(point.xi)) / 2;  // at the nearer node
    highest = std::max(highest, 2 / (point.weight * N));
  }
  return highest;
}

}  // namespace ex10_4

#include "addons/along/arc_length.hpp"

#include <limits>

#include "signorini/fem/element.hpp"

namespace signorini {
namespace {

/// Length of a side from its first node to a place. Sixteen points: of a straight side exact, of a parabola to rounding.
double length_to(const SideCurve& side, double xi) {
  const double half = (xi + 1) / 2;
  double length = 0;
  for (const GaussPoint& gauss : gauss_line(16))
    length += half * gauss.weight * side.tangent(half * (gauss.xi + 1) - 1).norm();
  return length;
}

}  // namespace

ArcLength::ArcLength(const Mesh& mesh, const std::string& boundary)
    : sides_(side_curves(mesh, boundary)) {
  for (const SideCurve& side : sides_) {
    before_.push_back(before_.back() + length_to(side, 1));
    boxes_.push_back(side.box());
  }
}

double ArcLength::at(std::size_t side, double xi) const {
  return before_[side] + length_to(sides_[side], xi);
}

double ArcLength::at(const Eigen::Vector2d& x) const {
  double least = std::numeric_limits<double>::infinity();
  double found = 0;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto way = (boxes_[k].col(0) - x).cwiseMax(x - boxes_[k].col(1)).cwiseMax(0);
    if (!(way.norm() < least)) continue;
    const double xi = sides_[k].closest(x);
    const double apart = (sides_[k].point(xi) - AnchoredPoint(x)).norm();
    if (!(apart < least)) continue;
    least = apart;
    found = at(k, xi);
  }
  return found;
}

// Bisection down to neighbouring doubles; the length grows along the side.
std::vector<double> ArcLength::places(const SideCurve& side,
                                      const std::vector<double>& lengths) const {
  const double before = at(side.point(0).position()) - length_to(side, 0);
  const double whole = length_to(side, 1);
  const double rounding = 1e-13 * (whole + before);
  std::vector<double> found;
  for (const double length : lengths) {
    const double wanted = length - before;
    if (!(wanted > rounding && wanted < whole - rounding)) continue;
    double low = -1;
    double high = 1;
    for (double middle = 0; middle > low && middle < high; middle = (low + high) / 2)
      (length_to(side, middle) < wanted ? low : high) = middle;
    found.push_back(high);
  }
  return found;
}

std::map<Eigen::Index, double> ArcLength::of_nodes() const {
  std::map<Eigen::Index, double> lengths;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const std::vector<Eigen::Index>& nodes = sides_[k].nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      lengths.emplace(
          nodes[i], at(k, 2 * static_cast<double>(i) / static_cast<double>(nodes.size() - 1) - 1));
  }
  return lengths;
}

}  // namespace signorini

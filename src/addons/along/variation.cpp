#include "addons/along/variation.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/index.hpp"
#include "signorini/fem/element.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

double place_of(const Variation& variation, const Vector2d& x) {
  if (variation.over == Over::Length) return variation.length->at(x);
  return variation.over == Over::X ? x.x() : x.y();
}

/// The value at a place: linear between two rows, constant beyond the ends; at a jump the later row counts.
VectorXd between_rows(const Variation& table, double place) {
  const std::vector<double>& places = table.places;
  const auto above = std::upper_bound(places.begin(), places.end(), place);
  if (above == places.begin()) return table.values.row(0);
  if (above == places.end()) return table.values.bottomRows(1).transpose();
  const Index high = above - places.begin();
  const double from = places[at(high - 1)];
  const double share = (place - from) / (*above - from);
  return (1 - share) * table.values.row(high - 1) + share * table.values.row(high);
}

/// Where on a side a table has a kink or a jump, increasing, with the ends of the side.
std::vector<double> pieces(const Variation& table, const SideCurve& side) {
  std::vector<double> ends = {-1, 1};
  const auto within = [&](const std::vector<double>& some) {
    for (const double xi : some)
      if (std::abs(xi) < 1) ends.push_back(xi);
  };
  const int axis = table.over == Over::X ? 0 : 1;
  if (table.over == Over::Length)
    within(table.length->places(side, table.places));
  else
    for (const double place : table.places)
      within(
          side.crossings(AnchoredPoint(place * Vector2d::Unit(axis)), Vector2d::Unit(1 - axis), 0));
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

/// On a straight side shape functions, radius and load are polynomials, of degree 2 without the load. Arc length and length of the
/// tangent of a parabola are none: the sixteen points leave less than rounding of them where a side turns by up to 45 degrees.
int points_for(const Variation& variation, const SideCurve& side) {
  const bool straight = side.nodes().size() == 2;
  return straight ? std::max(3, (2 + variation.degree()) / 2 + 1) : 16;
}

}  // namespace

VectorXd Variation::at(const Vector2d& x) const {
  if (!places.empty()) return between_rows(*this, place_of(*this, x));
  VectorXd sum = VectorXd::Zero(values.cols());
  for (std::size_t k = 0; k < powers.size(); ++k)
    sum += std::pow(x.x(), powers[k][0]) * std::pow(x.y(), powers[k][1]) *
           values.row(static_cast<Index>(k)).transpose();
  return sum;
}

int Variation::degree() const {
  int most = places.empty() ? 0 : 1;
  for (const auto& [i, j] : powers) most = std::max(most, i + j);
  return most;
}

ScalarField field_of(const Variation& variation, double scale) {
  if (scale == 0) return {};
  return [variation, scale](const Vector2d& x) { return variation.at(x)(0) / scale; };
}

double largest_size(const Variation& variation, const NodeArray& nodes) {
  double most = variation.places.empty() ? 0 : variation.values.cwiseAbs().maxCoeff();
  for (Index node = 0; node < nodes.rows(); ++node)
    most = std::max(most, std::abs(variation.at(nodes.row(node).transpose())(0)));
  return most > 0 || variation.values.isZero(0) ? most : 1;
}

SideRule rule_of(const Variation& variation) {
  return [variation](const SideCurve& side) {
    const std::vector<double> ends = pieces(variation, side);
    std::vector<GaussPoint> points;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double half = (ends[k] - ends[k - 1]) / 2;
      for (const GaussPoint& gauss : gauss_line(points_for(variation, side)))
        points.push_back({ends[k - 1] + half * (1 + gauss.xi), 0, half * gauss.weight});
    }
    return points;
  };
}

}  // namespace signorini

#include "exercise.hpp"

namespace ex9_1 {

std::optional<Place> facing(const Nodes& positions) {
  const Eigen::Vector2d x1 = positions.row(0).transpose(), x2 = positions.row(1).transpose();
  const Eigen::Vector2d x3 = positions.row(2).transpose(), edge = x2 - x1;
  Place place;
  place.N2 = (x3 - x1).dot(edge) / edge.squaredNorm();
  place.N1 = 1 - place.N2;
  if (place.N1 < 0 || place.N2 < 0) return std::nullopt;
  place.n = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
  place.t = Eigen::Vector2d(place.n.y(), -place.n.x());
  place.gap = (x3 - place.N1 * x1 - place.N2 * x2).dot(place.n);
  return place;
}

Nodes shared_out(const Place& place, double normal, double friction) {
  const Eigen::RowVector2d on3 = (normal * place.n + friction * place.t).transpose();
  Nodes forces;
  forces << -place.N1 * on3, -place.N2 * on3, on3;
  return forces;
}

}  // namespace ex9_1

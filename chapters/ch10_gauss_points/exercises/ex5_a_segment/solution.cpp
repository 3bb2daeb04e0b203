#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace ex10_5 {

using Eigen::Vector2d;

Segment mortar_segment(const Edges& edges) {
  const Vector2d along = edges.b - edges.a;
  const double length = along.norm();
  const auto place = [&](const Vector2d& x) {
    return 2 * (x - edges.a).dot(along) / along.squaredNorm() - 1;
  };
  const double sc = place(edges.c), sd = place(edges.d);
  const double from = std::max(-1.0, std::min(sc, sd)), to = std::min(1.0, std::max(sc, sd));
  if (!(from < to)) return {};
  Segment segment;
  segment.from = from;
  segment.to = to;
  const Vector2d n = Vector2d(along.y(), -along.x()) / length;
  for (const double xi : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
    const double s = (from + to) / 2 + xi * (to - from) / 2;
    const double weight = (to - from) / 2 * length / 2;
    const double r = (s - sc) / (sd - sc);
    const Vector2d psi((1 - 3 * s) / 2, (1 + 3 * s) / 2), N(1 - r, r);
    const Vector2d x = edges.a + (1 + s) / 2 * along;
    const Vector2d faced = N(0) * edges.c + N(1) * edges.d;
    segment.D += weight * psi;
    segment.M += weight * psi * N.transpose();
    segment.gap += weight * (faced - x).dot(n) * psi;
  }
  return segment;
}

}  // namespace ex10_5

#include "exercise.hpp"

namespace ex10_1 {

Element gauss_point(const Edges& edges, double xi, double weight, double pressure, double shear) {
  using Eigen::Vector2d;
  const Vector2d on_source(0.5 * (1 - xi), 0.5 * (1 + xi));
  const Vector2d point = edges.source.transpose() * on_source;
  const double length = (edges.source.row(1) - edges.source.row(0)).norm();

  const Vector2d third = edges.target.row(0).transpose();
  const Vector2d along = edges.target.row(1).transpose() - third;
  const Vector2d normal = Vector2d(along.y(), -along.x()).normalized();
  const Vector2d tangent(normal.y(), -normal.x());
  const double s = (point - third).dot(along) / along.squaredNorm();
  const Vector2d on_target(1 - s, s);

  const Vector2d traction = pressure * normal + shear * tangent;
  const Vector2d force = 0.5 * length * weight * traction;
  Element element{point, (point - third).dot(normal), {}};
  element.force.topRows<2>() = on_source * force.transpose();
  element.force.bottomRows<2>() = -on_target * force.transpose();
  return element;
}

}  // namespace ex10_1

#include "signorini/scene_file/kinds.hpp"

namespace signorini {
namespace {

using Eigen::Vector2d;

/// All that obstacles are described by.
struct Shape {
  Vector2d point = Vector2d::Zero(), normal = Vector2d::Zero(), centre = Vector2d::Zero(),
           shift = Vector2d::Zero();
  double radius = 1, clearance = 0;
};

Key<Shape> centre_key() { return key("centre", &Shape::centre, "length", "of the circle"); }

Key<Shape> radius_key(const char* help) {
  return required(key("radius", &Shape::radius, "length", help, Bound::Positive));
}

}  // namespace

const std::vector<Kind<Obstacle>>& obstacle_kinds() {
  static const std::vector<Kind<Obstacle>> kinds = {
      kind_of<Obstacle, Shape>(
          "half_plane", "everything behind a line",
          {required(key("point", &Shape::point, "length", "on the line")),
           required(key("normal", &Shape::normal, "", "out of the obstacle, of any length"))},
          [](const Shape& s) { return half_plane(s.point, s.normal); }),
      kind_of<Obstacle, Shape>("disc", "a disc; the body lies outside of it",
                               {centre_key(), radius_key("of the disc")},
                               [](const Shape& s) { return disc(s.centre, s.radius); }),
      kind_of<Obstacle, Shape>("hole", "what lies around a circle; the body lies inside of it",
                               {centre_key(), radius_key("of the hole")},
                               [](const Shape& s) { return hole(s.centre, s.radius); }),
      kind_of<Obstacle, Shape>(
          "pin_in_hole", "a round pin in a round hole of the body; its gap is linear in the shift",
          {centre_key(),
           required(key("clearance", &Shape::clearance, "length",
                        "radius of the hole less radius of the pin")),
           key("shift", &Shape::shift, "length", "of the pin from the middle of the hole")},
          [](const Shape& s) { return pin_in_hole(s.centre, s.clearance, s.shift); }),
      kind_of<Obstacle, Shape>(
          "parabola", "everything below a parabola that opens downwards",
          {required(key("point", &Shape::point, "length", "its highest point")),
           radius_key("of curvature there")},
          [](const Shape& s) {
            return profile(
                [s](double x) {
                  return s.point.y() - (x - s.point.x()) * (x - s.point.x()) / (2 * s.radius);
                },
                [s](double x) { return -(x - s.point.x()) / s.radius; });
          })};
  return kinds;
}

Obstacle read_obstacle(const Value& table) {
  return find_kind(table, obstacle_kinds(), {}).make(table);
}

}  // namespace signorini

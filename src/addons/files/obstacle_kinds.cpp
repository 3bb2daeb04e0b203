#include "addons/files/kinds.hpp"

namespace signorini {
namespace {

using Eigen::Vector2d;

/// All that obstacles are described by.
struct Given {
  Vector2d point = Vector2d::Zero(), normal = Vector2d::Zero(), centre = Vector2d::Zero(),
           shift = Vector2d::Zero();
  double radius = 1, clearance = 0;
};

Key<Given> centre_key() { return key("centre", &Given::centre, "length", "of the circle"); }

Key<Given> radius_key(const char* help) {
  return required(key("radius", &Given::radius, "length", help, Bound::Positive));
}

}  // namespace

const std::vector<Kind<Obstacle>>& obstacle_kinds() {
  static const std::vector<Kind<Obstacle>> kinds = {
      kind_of<Obstacle, Given>(
          "half_plane", "everything behind a line",
          {required(key("point", &Given::point, "length", "on the line")),
           required(key("normal", &Given::normal, "", "out of the obstacle, of any length"))},
          [](const Given& s) { return half_plane(s.point, s.normal); }),
      kind_of<Obstacle, Given>("disc", "a disc; the body lies outside of it",
                               {centre_key(), radius_key("of the disc")},
                               [](const Given& s) { return disc(s.centre, s.radius); }),
      kind_of<Obstacle, Given>("hole", "what lies around a circle; the body lies inside of it",
                               {centre_key(), radius_key("of the hole")},
                               [](const Given& s) { return hole(s.centre, s.radius); }),
      kind_of<Obstacle, Given>(
          "pin_in_hole", "a round pin in a round hole of the body; its gap is linear in the shift",
          {centre_key(),
           required(key("clearance", &Given::clearance, "length",
                        "radius of the hole less radius of the pin")),
           key("shift", &Given::shift, "length", "of the pin from the middle of the hole")},
          [](const Given& s) { return pin_in_hole(s.centre, s.clearance, s.shift); }),
      kind_of<Obstacle, Given>(
          "parabola", "everything below a parabola that opens downwards",
          {required(key("point", &Given::point, "length", "its highest point")),
           radius_key("of curvature there")},
          [](const Given& s) {
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

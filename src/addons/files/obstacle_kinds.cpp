#include <algorithm>

#include "addons/along/profiles.hpp"
#include "addons/files/kinds.hpp"
#include "addons/text/text_reader.hpp"

namespace signorini {
namespace {

using Eigen::Vector2d;

/// All that obstacles are described by.
struct Given {
  Vector2d point = Vector2d::Zero(), normal = Vector2d::Zero(), centre = Vector2d::Zero(),
           shift = Vector2d::Zero();
  double radius = 1, clearance = 0;
};

/// A profile as points, of the scene or of a file of its own.
struct Profile {
  std::vector<Vector2d> points;
  Vector2d move = Vector2d::Zero();
  int sources = 0;
};

void read_points(const Value& value, Profile& profile) {
  ++profile.sources;
  if (value.kind != Value::Kind::List)
    value.fail("expected a list of points [x, y], got ", value.shown());
  for (const Value& item : value.items) take(item, profile.points.emplace_back());
}

/// Refuses a comma without a number on either side of it: what is left of the line would be read for another place.
void check_commas(const std::string& content, const std::string& name) {
  TextReader reader(content, name);
  while (reader.next_line()) {
    char before = ',';
    for (const char c : reader.rest_of_line()) {
      if (c == ' ' || c == '\t') continue;
      if (c == ',' && before == ',')
        reader.fail("expected x and y, got a comma without a number before it");
      before = c;
    }
    if (before == ',') reader.fail("expected x and y, got a comma without a number behind it");
  }
}

/// Two numbers in each line, with a blank or a comma between them.
void read_points_of_file(const Value& value, Profile& profile) {
  ++profile.sources;
  constexpr std::size_t largest = std::size_t{1} << 24;
  std::string name;
  take(value, name);
  const std::filesystem::path file = value.origin->folder / name;
  value.origin->files.insert(file);
  std::string content = value.explain([&] { return file_content(file, largest); });
  value.explain([&] { check_commas(content, file.string()); });
  std::replace(content.begin(), content.end(), ',', ' ');
  value.explain([&] {
    TextReader reader(content, file.string());
    while (reader.next_line()) {
      const double x = reader.number(reader.word(), "x");
      const double y = reader.number(reader.word(), "y");
      reader.expect_end_of_line("y");
      profile.points.emplace_back(x, y);
    }
  });
}

/// A kind of profiles. \param made  makes one of its points
Kind<Obstacle> profile_kind(const char* name, const char* help,
                            Obstacle (*made)(const NodeArray& points)) {
  const Keys<Profile> keys = {
      {{"points", "list of [x, y]", "length", "",
        "from the first to the last, the body on the left: of a floor to the right"},
       read_points},
      {{"file", "text", "", "",
        "in place of points: a file with x and y in each line, in the folder of the scene file"},
       read_points_of_file},
      key("move", &Profile::move, "length", "of all points to another place")};
  return kind_of<Obstacle, Profile>(name, help, keys, [made](const Profile& profile) {
    require_input(profile.sources == 1, "expected either points or file, got ",
                  profile.sources == 0 ? "neither" : "both");
    NodeArray points(profile.points.size(), 2);
    for (std::size_t k = 0; k < profile.points.size(); ++k)
      points.row(static_cast<Eigen::Index>(k)) = (profile.points[k] + profile.move).transpose();
    return made(points);
  });
}

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
          "pin_in_hole", "a round pin in a round hole of the body; its gap is linear in the shift, so where bodies move "
          "take a disc",
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
          }),
      profile_kind("polyline", "what lies to the right of straight lines from point to point",
                   polyline),
      profile_kind("spline", "what lies to the right of a smooth curve through points", spline)};
  return kinds;
}

Obstacle read_obstacle(const Value& table) {
  return find_kind(table, obstacle_kinds(), {}).make(table);
}

}  // namespace signorini

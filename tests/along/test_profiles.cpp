// Profiles of points against obstacles that are known exactly.
#include <cmath>
#include <fstream>

#include "addons/along/profiles.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/readings.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using signorini_test::Folder;
using signorini_test::problem_message;

namespace {

using Maker = Obstacle (*)(const NodeArray&);

/// Points of a circle of radius 2 about (1, -2), whose inside is the obstacle: over the top from the left to the right.
NodeArray arc(Index pieces, double from = 2.6, double to = 0.5) {
  NodeArray points(pieces + 1, 2);
  for (Index k = 0; k <= pieces; ++k) {
    const double angle = from + (to - from) * static_cast<double>(k) / static_cast<double>(pieces);
    points.row(k) << 1 + 2 * std::cos(angle), -2 + 2 * std::sin(angle);
  }
  return points;
}

/// The largest errors of gap and normal in front of, on and behind a part of that arc. \param from, to  angles, of the middle at first
std::pair<double, double> errors(const Obstacle& profile, double from = 1.2, double to = 1.9) {
  const Obstacle exact = disc({1, -2}, 2);
  double gap = 0;
  double normal = 0;
  for (const double distance : {1.7, 2.0, 2.4})
    for (int k = 0; k <= 40; ++k) {
      const double angle = from + (to - from) * k / 40;
      const Vector2d x(1 + distance * std::cos(angle), -2 + distance * std::sin(angle));
      gap = std::max(gap, std::abs(profile.look(x).gap - exact.look(x).gap));
      normal = std::max(normal, (profile.look(x).normal - exact.look(x).normal).norm());
    }
  return {gap, normal};
}

}  // namespace

// Closed form: the distance from a line. It is computed from another of its points: two roundings of numbers below 10.
TEST_CASE("a profile of points on a line is the half-plane, also beyond its ends",
          "[profiles][closed-form]") {
  const Maker maker = GENERATE(polyline, spline);
  const Vector2d first(-1, 0.5);
  const Vector2d way = GENERATE(Vector2d(1, 0), Vector2d(0.6, 0.8), Vector2d(-0.3, 0.1));
  NodeArray points(6, 2);
  const double at[] = {0, 0.3, 1, 1.1, 2.5, 4};
  for (Index k = 0; k < 6; ++k) points.row(k) = (first + at[k] * way).transpose();
  const Obstacle profile = maker(points);
  const Obstacle exact = half_plane(first, {-way.y(), way.x()});
  for (const double along : {-3.0, 0.0, 0.2, 1.0, 1.05, 4.0, 6.5})
    for (const double apart : {-0.7, -1e-9, 0.0, 1e-15, 0.3, 2.0}) {
      const Vector2d x = first + along * way + apart * exact.look(first).normal;
      CAPTURE(way.transpose(), along, apart);
      CHECK(profile.look(x).gap == Approx(exact.look(x).gap).margin(4e-15));
      CHECK((profile.look(x).normal - exact.look(x).normal).norm() <= 4e-15);
    }
}

TEST_CASE("a gap to a sloping profile has digits of its own", "[profiles][closed-form]") {
  const Obstacle profile = polyline((NodeArray(3, 2) << 0, 0, 3, 1, 9, 3).finished());
  // One rounding beside a point on a straight stretch.
  const Obstacle flat = polyline((NodeArray(3, 2) << -1, 0, 0.3, 0, 2, 0).finished());
  CHECK(flat.look({0.3 + 0x1p-54, 1e-20}).gap == 1e-20);
  CHECK(flat.look({0.3 + 0x1p-54, -1e-20}).gap == -1e-20);
  for (const double x : {0.75, 2.25, 3.0, 3.75})
    for (const int rise : {1, -2})
      CHECK(profile.look({x, x / 3 + rise * 0x1p-51}).gap ==
            Approx(rise * 0x1p-51 * 3 / std::sqrt(10)).epsilon(1e-14).margin(0));
}

// Closed form: a chord of length h is h^2/8R below its arc, and turns by h/2R; a cubic spline errs by h^4, its normals by h^3.
TEST_CASE("profiles of a circle converge to it: polylines as h^2, splines as h^4",
          "[profiles][closed-form]") {
  const double h = 2 * 2.1 / 40;
  const auto [coarse, turned] = errors(polyline(arc(40)));
  CHECK(coarse <= 1.01 * h * h / 16);
  CHECK(coarse >= 0.8 * h * h / 16);
  CHECK(turned <= 1.01 * h / 4);
  CHECK(coarse / errors(polyline(arc(80))).first == Approx(4).epsilon(0.0001));
  const auto [smooth, smooth_turned] = errors(spline(arc(40)));
  CHECK(smooth / errors(spline(arc(80))).first == Approx(16).epsilon(0.002));
  CHECK(smooth_turned / errors(spline(arc(80))).second == Approx(8).epsilon(0.002));
  CHECK(smooth < 1e-3 * coarse);
}

// Closed form: the second derivative of a natural spline is wrong by the curvature 1/R at its end, and by (sqrt(3) - 2)^j / R at the j-th
// point from there. In the first piece it errs by h^2/6R ((1 - b) - (1 - b)^3 - (2 - sqrt(3)) (b - b^3)), at most 0.393 of h^2/8R;
// so 0.028 of it behind two pieces, and 1.5e-4 behind six.
TEST_CASE("a spline errs by less than half of what a polyline does in its last pieces",
          "[profiles][closed-form]") {
  const double step = 2.1 / 40;
  const Obstacle profile = spline(arc(40));
  const double chord = 4 * step * step / 16;
  CHECK(errors(profile, 0.5, 0.5 + step).first == Approx(0.393 * chord).epsilon(0.001));
  CHECK(errors(profile, 2.6 - step, 2.6).first == Approx(0.393 * chord).epsilon(0.001));
  CHECK(errors(profile, 0.5 + 2 * step, 2.6 - 2 * step).first < 0.04 * chord);
  CHECK(errors(profile, 0.5 + 6 * step, 2.6 - 6 * step).first < 2e-4 * chord);
}

TEST_CASE("a corner is seen from both sides, and from behind", "[profiles]") {
  NodeArray roof(3, 2);
  roof << -1, -1, 0, 0, 1, -1;  // the body above
  const Obstacle ridge = polyline(roof);
  const double half = std::sqrt(0.5);
  CHECK(ridge.look({0, 2}).gap == Approx(2).epsilon(1e-15));
  CHECK((ridge.look({0, 2}).normal - Vector2d(0, 1)).norm() < 1e-15);
  CHECK((ridge.look({0.3, 1}).normal - Vector2d(0.3, 1).normalized()).norm() < 1e-15);
  CHECK(ridge.look({2, 0}).gap == Approx(2 * half).epsilon(1e-15));
  CHECK((ridge.look({2, 0}).normal - Vector2d(half, half)).norm() < 1e-15);
  CHECK(ridge.look({0.1, -1}).gap == Approx(-0.9 * half).epsilon(1e-15));
  CHECK((ridge.look({0, 0}).normal - Vector2d(0, 1)).norm() < 1e-15);
  NodeArray valley = roof;
  valley.col(1) *= -1;
  const Obstacle groove = polyline(valley);
  CHECK(groove.look({0, 1}).gap == Approx(half).epsilon(1e-15));
  CHECK(groove.look({0, -2}).gap == Approx(-2).epsilon(1e-15));
  CHECK((groove.look({0, -2}).normal - Vector2d(0, 1)).norm() < 1e-15);
}

TEST_CASE("a closed polyline is an obstacle all round", "[profiles]") {
  NodeArray square(5, 2);
  square << 0, 0, 0, 1, 1, 1, 1, 0, 0, 0;  // clockwise: outside is on the left
  const Obstacle box = polyline(square);
  CHECK(box.look({0.5, 1.25}).gap == Approx(0.25).epsilon(1e-15));
  CHECK(box.look({-0.5, 0.5}).gap == Approx(0.5).epsilon(1e-15));
  CHECK(box.look({-3, -4}).gap == Approx(5).epsilon(1e-15));
  CHECK((box.look({-3, -4}).normal - Vector2d(-0.6, -0.8)).norm() < 1e-15);
  CHECK(box.look({0.5, 0.4}).gap == Approx(-0.4).epsilon(1e-15));
}

// A block that is pressed onto a disc as its own profile: with h, pressures come to those of the disc.
TEST_CASE("contact with a spline of a circle is that with the circle", "[profiles][contact]") {
  const auto force = [](const Obstacle& obstacle) {
    Scene scene = parse_scene(
                      "[[body]]\nname = \"block\"\nmesh = { kind = \"block\", size = [2, 1], "
                      "cells = [16, 8], corner = [0, -0.02] }\n"
                      "material = { youngs_modulus = 1000, poisson_ratio = 0.3 }\nfixed = \"top\"\n"
                      "[[contact]]\nsource = \"bottom\"\n"
                      "target = { kind = \"disc\", centre = [1, -2], radius = 2 }\n",
                      "name", ".")
                      .scene;
    scene.contacts[0].target = obstacle;
    return solved(scene, "block").solution.contact.force.sum();
  };
  const double exact = force(disc({1, -2}, 2));
  CHECK(exact > 1);
  const double coarse = std::abs(force(polyline(arc(101))) - exact) / exact;
  const double fine = std::abs(force(polyline(arc(404))) - exact) / exact;
  CHECK(coarse < 0.01);
  CHECK(fine < coarse / 8);
  CHECK(std::abs(force(spline(arc(101))) - exact) < 1e-5 * exact);
}

TEST_CASE("profiles come from a scene or from a file of points", "[profiles][scene_file]") {
  const Folder folder;
  std::ofstream(folder.path() / "floor.csv") << "# x, y\n-1, 0\n1,0.5\n\n3 0.5\n";
  const auto target = [&](const std::string& keys) {
    const std::string text =
        "[[body]]\nmesh = { kind = \"block\", size = [2, 1], cells = [2, 1], corner = [0, 1] }\n"
        "material = { youngs_modulus = 1, poisson_ratio = 0.3 }\nfixed = \"top\"\n"
        "[[contact]]\nsource = \"bottom\"\ntarget = { " +
        keys + " }\n";
    const Scene scene = parse_scene(text, "name", folder.path()).scene;
    return std::get<Obstacle>(scene.contacts[0].target);
  };
  const auto told = [&](const std::string& keys) {
    return problem_message([&] { static_cast<void>(target(keys)); });
  };
  const Obstacle filed = target("kind = \"polyline\", file = \"floor.csv\", move = [0, 0.25]");
  const Obstacle listed =
      target("kind = \"polyline\", points = [[-1, 0.25], [1, 0.75], [3, 0.75]]");
  CHECK(filed.name == "polyline");
  CHECK(filed.look({2, 1}).gap == Approx(0.25).epsilon(1e-15));
  CHECK(filed.look({0.3, 1}).gap == listed.look({0.3, 1}).gap);
  CHECK(target("kind = \"spline\", file = \"floor.csv\"").name == "spline");
  CHECK_THAT(told("kind = \"polyline\""),
             ContainsSubstring("expected either points or file, got neither"));
  CHECK_THAT(told("kind = \"polyline\", points = [[0, 0], [1, 0]], file = \"floor.csv\""),
             ContainsSubstring("got both"));
  CHECK_THAT(told("kind = \"polyline\", points = [[0, 0]]"),
             ContainsSubstring("needs two points or more, got 1"));
  CHECK_THAT(told("kind = \"spline\", points = [[0, 0], [0, 0], [1, 0]]"),
             ContainsSubstring("the points 1 and 2 are the same, (0, 0): leave one of them out"));
  CHECK_THAT(told("kind = \"spline\", points = [[0, 0], [1, 1], [0, 2], [0, 0]]"),
             ContainsSubstring("leave out the last point, or take a polyline"));
  CHECK_THAT(told("kind = \"polyline\", points = [[0, 0], [3, 1], [-3, -1]]"),
             ContainsSubstring("behind point 2, (3, 1), the profile goes back the way it came"));
  CHECK_THAT(told("kind = \"polyline\", file = \"flor.csv\""), ContainsSubstring("flor.csv"));
  std::ofstream(folder.path() / "bad.csv") << "1 2\n1 two\n";
  CHECK_THAT(told("kind = \"polyline\", file = \"bad.csv\""),
             ContainsSubstring("bad.csv:2: y: expected a finite number, got 'two'"));
}

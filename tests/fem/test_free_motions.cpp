#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/free_motions.hpp"
#include "meshes/reshape.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

Mesh plate() { return block("plate", {0, 0}, {3, 2}, 3, 2); }

/// What free_motions() says, a sentence per motion.
std::vector<std::string> sentences(const Mesh& mesh, const Unknowns& unknowns) {
  std::vector<std::string> all;
  for (const FreeMotion& motion : free_motions(mesh, unknowns)) all.push_back(in_words(motion));
  return all;
}

}  // namespace

TEST_CASE("a body of revolution can move along its axis and no other way", "[free_motions]") {
  const Mesh tube = moved(plate(), {1, 0});
  const auto motions = [&tube](const std::vector<Support>& supports) {
    return free_motions(tube, number_unknowns(tube, supports, PlaneState::Axial),
                        PlaneState::Axial);
  };
  const std::vector<FreeMotion> free = motions({});
  REQUIRE(free.size() == 1);
  CHECK_THAT(in_words(free[0]), ContainsSubstring("move freely in direction y"));
  const Unknowns unknowns = number_unknowns(tube, {}, PlaneState::Axial);
  for (Eigen::Index node = 0; node < tube.n_nodes(); ++node) {
    CHECK(free[0].shape.coeff(unknowns.number(node, 0)) == 0);
    CHECK(free[0].shape.coeff(unknowns.number(node, 1)) == 1);
  }
  CHECK(motions({prescribed("left", Axis::X, 0)}).size() == 1);
  CHECK(motions({symmetric("bottom")}).empty());
}

TEST_CASE("a free body moves in both directions and turns", "[free_motions]") {
  const std::vector<std::string> motions = sentences(plate(), number_unknowns(plate(), {}));
  REQUIRE(motions.size() == 3);
  for (const std::string& motion : motions) CHECK_THAT(motion, StartsWith("body 'plate' (6 cells"));
  CHECK_THAT(motions[0], ContainsSubstring("move freely in direction x"));
  CHECK_THAT(motions[1], ContainsSubstring("move freely in direction y"));
  CHECK_THAT(motions[2], ContainsSubstring("turn freely about (1.5, 1)"));
}

TEST_CASE("a body on rollers moves along them and in no other way", "[free_motions]") {
  const auto only = [](const char* boundary) {
    const std::vector<std::string> found =
        sentences(plate(), number_unknowns(plate(), {symmetric(boundary)}));
    return found.size() == 1 ? found[0] : "";
  };
  CHECK_THAT(only("bottom"), ContainsSubstring("can move freely in direction x") &&
                                 !ContainsSubstring("direction y") && !ContainsSubstring("turn"));
  CHECK_THAT(only("left"), ContainsSubstring("can move freely in direction y") &&
                               !ContainsSubstring("direction x") && !ContainsSubstring("turn"));
}

TEST_CASE("a direction is told to the right, whichever way a motion goes", "[free_motions]") {
  FreeMotion free;
  free.body = "it";
  free.size = 1;
  for (const double way : {1.0, -1.0}) {
    free.motion = way * Eigen::Vector3d(0.6, -0.8, 0);
    CHECK(in_words(free) == "it can move freely in direction (0.6, -0.8)");
  }
}

TEST_CASE("a body held at one point turns about it", "[free_motions]") {
  Unknowns unknowns = number_unknowns(plate(), {});
  SECTION("a hinge at node 6") {
    unknowns.number.row(6).setConstant(-1);
    const std::vector<std::string> motions = sentences(plate(), unknowns);
    REQUIRE(motions.size() == 1);
    CHECK_THAT(motions[0], ContainsSubstring("can turn freely about (2, 1)"));
  }
  SECTION("x held at (0, 0) and y at (3, 2): the centre is where the two normals meet") {
    unknowns.number(0, 0) = -1;
    unknowns.number(11, 1) = -1;
    const std::vector<std::string> motions = sentences(plate(), unknowns);
    REQUIRE(motions.size() == 1);
    CHECK_THAT(motions[0], ContainsSubstring("can turn freely about (3, ") &&
                               !ContainsSubstring("move freely"));
  }
}

TEST_CASE("what a body does is said alike in every unit of length", "[free_motions]") {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    const Mesh scaled = mapped(plate(), [unit](const Vector2d& x) { return unit * x; });
    Unknowns unknowns = number_unknowns(scaled, {});
    unknowns.number.row(0).setConstant(-1);
    const std::vector<std::string> motions = sentences(scaled, unknowns);
    INFO(unit);
    REQUIRE(motions.size() == 1);
    CHECK_THAT(motions[0], Catch::Matchers::EndsWith("can turn freely about (0, 0)"));
  }
  const Mesh tiny = mapped(plate(), [](const Vector2d& x) { return 1e-6 * x; });
  const std::vector<std::string> slides =
      sentences(tiny, number_unknowns(tiny, {symmetric("bottom")}));
  REQUIRE(slides.size() == 1);
  CHECK_THAT(slides[0], Catch::Matchers::EndsWith("can move freely in direction x"));
}

TEST_CASE("a body that is held cannot move", "[free_motions]") {
  const auto held = [](const std::vector<Support>& supports) {
    return free_motions(plate(), number_unknowns(plate(), supports)).empty();
  };
  CHECK(held({fixed("left")}));
  CHECK(held({symmetric("left"), symmetric("bottom")}));
  CHECK_FALSE(held({symmetric("left"), symmetric("right")}));
}

TEST_CASE("of two bodies in one mesh the free one is named", "[free_motions]") {
  Mesh both = plate();
  const Mesh second =
      mapped(plate(), [](const Vector2d& x) { return Vector2d(x.x() + 10, x.y()); });
  const Index n = both.n_nodes();
  both.nodes.conservativeResize(2 * n, 2);
  both.nodes.bottomRows(n) = second.nodes;
  both.cells.conservativeResize(12, 4);
  both.cells.bottomRows(6) = second.cells.array() + n;
  const std::vector<std::string> motions = sentences(both, number_unknowns(both, {fixed("left")}));
  REQUIRE(motions.size() == 3);
  for (const std::string& motion : motions)
    CHECK_THAT(motion, ContainsSubstring("6 cells around (11.5, 1)"));
  CHECK(free_motions(both, number_unknowns(both, {})).size() == 6);
}

TEST_CASE("a node straight below the pivot does not move up or down", "[free_motions]") {
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const double x = 0.1 + 0.0137 * k;
    const Mesh mesh = block("block", {x, 1}, {1, 0.5}, 4, 2);
    const Unknowns unknowns = number_unknowns(mesh, {prescribed_at("top", {x + 1, 1.5}, Axis::X),
                                                     prescribed_at("top", {x, 1.5}, Axis::Y)});
    const std::vector<FreeMotion> motions = free_motions(mesh, unknowns);
    REQUIRE(motions.size() == 1);
    CHECK(motions[0].shape.coeffs().abs().maxCoeff() > 0.1);
    CHECK(motions[0].shape.coeff(unknowns.number(0, 1)) == 0);
  }
}

namespace {

/// Supports of the plate, and how many motions they leave it.
struct Held {
  const char* what;
  std::function<void(Unknowns&)> hold;
  std::size_t left;
};

/// The plate has four nodes in a row and three rows.
const std::vector<Held>& ways_to_hold() {
  static const auto x = [](Unknowns& all, Index node) { all.number(node, 0) = -1; };
  static const auto y = [](Unknowns& all, Index node) { all.number(node, 1) = -1; };
  static const std::vector<Held> all = {
      {"nothing", [](Unknowns&) {}, 3},
      {"one node in x", [](Unknowns& u) { x(u, 5); }, 2},
      {"two nodes in x, one above the other", [](Unknowns& u) { x(u, 1), x(u, 9); }, 1},
      {"two nodes in x, side by side", [](Unknowns& u) { x(u, 4), x(u, 7); }, 2},
      {"a row in y", [](Unknowns& u) { y(u, 0), y(u, 1), y(u, 2), y(u, 3); }, 1},
      {"a column in y", [](Unknowns& u) { y(u, 1), y(u, 5), y(u, 9); }, 2},
      {"a hinge", [](Unknowns& u) { x(u, 6), y(u, 6); }, 1},
      {"a hinge and x beside it", [](Unknowns& u) { x(u, 4), y(u, 4), x(u, 7); }, 1},
      {"a hinge and y beside it", [](Unknowns& u) { x(u, 4), y(u, 4), y(u, 7); }, 0},
      {"a hinge and y above it", [](Unknowns& u) { x(u, 2), y(u, 2), y(u, 10); }, 1},
      {"three normals through one node", [](Unknowns& u) { x(u, 4), x(u, 7), y(u, 1), y(u, 9); },
       1},
      {"three normals past each other", [](Unknowns& u) { x(u, 0), x(u, 11), y(u, 1); }, 0}};
  return all;
}

/// A quarter turn takes the components of the supports with it.
Unknowns turned(const Unknowns& unknowns) {
  Unknowns other = unknowns;
  other.number.col(0) = unknowns.number.col(1);
  other.number.col(1) = unknowns.number.col(0);
  return other;
}

}  // namespace

TEST_CASE(
    "supports leave the same motions wherever the body is, however it lies and how large it is",
    "[free_motions][far]") {
  // Rounding must show: cos 90 degrees is 6e-17, and the sides are no whole numbers.
  const double c = std::cos(pi / 2), s = std::sin(pi / 2);
  for (const Held& held : ways_to_hold())
    for (const double size : {1e-3, 0.7, 1e3})
      for (const double away : {0.0, 1e3, 1e6})
        for (const int quarters : {0, 1, 2, 3}) {
          CAPTURE(held.what, size, away, quarters);
          Unknowns unknowns = number_unknowns(plate(), {});
          held.hold(unknowns);
          Mesh mesh = plate();
          for (int k = 0; k < quarters; ++k) {
            mesh = mapped(mesh, [&](const Vector2d& x) {
              return Vector2d(c * x.x() - s * x.y(), s * x.x() + c * x.y());
            });
            unknowns = turned(unknowns);
          }
          mesh = mapped(mesh, [&](const Vector2d& x) {
            return Vector2d(size * (x.x() / 3 + 0.6 * away), size * (x.y() / 3 - 0.8 * away));
          });
          const std::vector<FreeMotion> motions = free_motions(mesh, unknowns);
          CHECK(motions.size() == held.left);
          for (const FreeMotion& motion : motions) CHECK(motion.shape.coeffs().abs().maxCoeff() > 0.1);
        }
}

TEST_CASE("two rollers as close as can be told hold a body that is near, and not one that is far",
          "[free_motions][far]") {
  const double close = 1e-8;  // of the size
  const auto motions = [&](double away) {
    const Mesh mesh = mapped(plate(), [&](const Vector2d& x) {
      return Vector2d(x.x() + away, x.y() > 1.5 ? 2 : close * x.y());
    });
    Unknowns unknowns = number_unknowns(mesh, {});
    unknowns.number(0, 0) = unknowns.number(4, 0) = -1;
    return free_motions(mesh, unknowns).size();
  };
  CHECK(motions(0) == 1);
  CHECK(motions(1e9) == 2);  // there a coordinate is rounded to 1e-7
}

#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/elasticity/free_motions.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/mesh/reshape.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

Mesh plate() { return block("plate", {0, 0}, {3, 2}, 3, 2); }

/// What free_motions() says, a sentence per motion.
std::vector<std::string> sentences(const Mesh& mesh, const Unknowns& unknowns) {
  std::vector<std::string> all;
  for (const FreeMotion& motion : free_motions(mesh, unknowns)) all.push_back(motion.sentence);
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
  CHECK_THAT(free[0].sentence, ContainsSubstring("move freely in direction y"));
  const Unknowns unknowns = number_unknowns(tube, {}, PlaneState::Axial);
  for (Eigen::Index node = 0; node < tube.n_nodes(); ++node) {
    CHECK(free[0].shape(unknowns.number(node, 0)) == 0);
    CHECK(free[0].shape(unknowns.number(node, 1)) == 1);
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
    CHECK(motions[0].shape.cwiseAbs().maxCoeff() > 0.1);
    CHECK(motions[0].shape(unknowns.number(0, 1)) == 0);
  }
}

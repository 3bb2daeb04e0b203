#include <limits>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/block.hpp"

using ex18_1::Needs;
using ex18_1::needs_of;
using ex18_1::Step;
using ex18_1::step;
using namespace signorini;
using Eigen::Index;
using Names = std::vector<std::string>;
using Counts = std::vector<Index>;

namespace {

/// A block in a corner of two walls: below it a rough one, on its right a smooth one.
Scene in_a_corner(Index cells_x, Index cells_y) {
  Scene scene;
  scene.bodies[0].mesh = block("block", {0, 0}, {1, 1}, cells_x, cells_y);
  scene.contacts = {{{"right", "block"}, half_plane({1, 0}, {-1, 0})},
                    {{"bottom", "block"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[1].friction = Friction{0.5, 0};
  scene.bodies[0].loads.edges = {{"top", 1, {}}, {"left", 1, {}}};
  return scene;
}

}  // namespace

TEST_CASE("ex18.1 held out: two contacts, of which one rubs", "[ex18.1]") {
  for (const Index n : {2, 5}) {
    const Index m = n + 3;
    CAPTURE(n, m);
    const Needs needs = needs_of(in_a_corner(n, m));
    CHECK(needs.unknowns == 2 * (n + 1) * (m + 1));
    CHECK(needs.gaps == (n + 1) + (m + 1));
    CHECK(needs.gaps_of == Counts{m + 1, n + 1});
    CHECK(needs.slips == n + 1);
    CHECK(needs.slips_of == Counts{0, n + 1});
    CHECK(needs.amplitudes == 3);
    CHECK(needs.on == Names{"edge loads", "contact", "friction", "rigid motions"});
  }
}

// What supports give cannot move: neither an unknown, nor a slip, nor a rigid motion.
TEST_CASE("ex18.1 held out: a support takes unknowns, slips and amplitudes away", "[ex18.1]") {
  const Scene free = in_a_corner(4, 3);
  Scene held = free;
  held.bodies[0].supports = {prescribed("bottom", Axis::X, 0)};
  const Step taken = step(free, held);
  CHECK(taken.unknowns == -5);
  CHECK(taken.rows == -5 - 1);    // all slips, and the gap of the corner
  CHECK(taken.amplitudes == -1);  // it may still rise, and turn about a place on its bottom
  CHECK(needs_of(held).gaps_of == Counts{3, 5});
  CHECK(needs_of(held).slips_of == Counts{0, 0});
}

TEST_CASE("ex18.1 held out: a body without contact", "[ex18.1]") {
  Scene scene = in_a_corner(3, 2);
  scene.contacts.clear();
  scene.bodies[0].supports = {fixed("bottom")};
  const Needs needs = needs_of(scene);
  CHECK(needs.unknowns == 16);
  CHECK(needs.gaps == 0);
  CHECK(needs.gaps_of == decltype(needs.gaps_of){});
  CHECK(needs.slips_of == decltype(needs.slips_of){});
  CHECK(needs.on == Names{"edge loads"});
  CHECK(step(scene, in_a_corner(3, 2)).switched_on ==
        Names{"contact", "friction", "rigid motions"});
}

// A load that is not a number is found when it is integrated, which is not done here.
TEST_CASE("ex18.1 held out: nothing is assembled", "[ex18.1]") {
  Scene scene = in_a_corner(3, 2);
  scene.bodies[0].loads.body_force = [](const Eigen::Vector2d& /*x*/) {
    return Eigen::Vector2d(std::numeric_limits<double>::quiet_NaN(), 0);
  };
  CHECK_THROWS_AS(solve(scene), ProblemError);
  CHECK(needs_of(scene).on.front() == "body force");
}

TEST_CASE("ex18.1 held out: what is refused is refused here, too", "[ex18.1]") {
  Scene scene = in_a_corner(3, 2);
  scene.contacts[1].friction = Friction{-0.5, 0};
  CHECK_THROWS_AS(needs_of(scene), ProblemError);
  scene.contacts.clear();
  CHECK_THROWS_AS(step(in_a_corner(3, 2), scene), ProblemError);
}

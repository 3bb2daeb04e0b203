// What chapter 22 says of its loop.
#include "../chapters/ch22_bodies_that_move/bowl.hpp"
#include "../chapters/ch22_bodies_that_move/scenes.hpp"
#include "catch_compat.hpp"
#include "support/moving_blocks.hpp"

using namespace ch22;

namespace {

// The scene of the add-on's tests, held by hand.
Two moving_blocks_by_hand() {
  const Scene scene = signorini_test::moving_blocks();
  return {held(scene.bodies[0].mesh, 1000, "bottom"), held(scene.bodies[1].mesh, 1000, "top"),
          "bottom", 0.3};
}

}  // namespace

// Both end where the same equations hold: the chapter's loop at moves of 1e-12, the add-on at its certificate. Displacements of 3
// beside strains of 1e-2 leave forces 1e-12 * 3 / 1e-2 of their size, times a modulus over a stress.
TEST_CASE("the loop of the chapter has the forces of the add-on, step by step", "[motion]") {
  const Assembled bodies = assembled(moving_blocks_by_hand());
  NodeArray u = at_rest(bodies);
  Index k = 0;
  const PathEnd end =
      solve_steps(signorini_test::moving_blocks(), [&](const Model&, const signorini::Step& theirs) {
        const Place ours = step(bodies, u, {3.0 * double(k) / 12, -0.01});
        REQUIRE(ours.arrived);
        u = ours.u;
        CAPTURE(k++);
        REQUIRE(ours.contact.force.size() == theirs.solution.contact.force.size());
        const double size = theirs.solution.contact.force.maxCoeff();
        CHECK((ours.contact.force - theirs.solution.contact.force).cwiseAbs().maxCoeff() <=
              1e-9 * size);
        CHECK((ours.contact.friction - theirs.solution.contact.friction).cwiseAbs().maxCoeff() <=
              1e-9 * size);
      });
  CHECK(end.status == SolveStatus::Solved);
  CHECK(k == 13);
}

TEST_CASE("the frozen loop of a node shrinks errors by stiffness of geometry over that of matter",
          "[motion][closed-form]") {
  for (const double weight : {0.1, 0.3, 0.5, 0.8}) {
    CAPTURE(weight);
    Node end{{0, 0}, 0};
    for (int k = 0; k < 20; ++k) end = next(end, weight, true);
    Node now{{0, 0}, 0};
    double last = 1;
    double rate = 0;
    for (int k = 0; k < 100 && last > 1e-9; ++k) {
      now = next(now, weight, false);
      const double error = (now.u - end.u).norm();
      rate = error / last;
      last = error;
    }
    REQUIRE(last <= 1e-9);
    // What the square of an error of 1e-8 leaves.
    CHECK(rate == Approx(end.force / (radius * stiffness)).epsilon(1e-6));
  }
}

TEST_CASE("with the normal's turning the error of a node is squared", "[motion]") {
  for (const double weight : {0.5, 1.5, 5.0}) {
    Node end{{0, 0}, 0};
    for (int k = 0; k < 30; ++k) end = next(end, weight, true);
    Node now{{0, 0}, 0};
    double last = 1;
    for (int k = 0; k < 8; ++k) {
      now = next(now, weight, true);
      const double error = (now.u - end.u).norm();
      CAPTURE(weight, k, last, error);
      if (k > 1) CHECK(error <= 4 * last * last + 1e-14);
      last = error;
    }
    CHECK(last < 1e-14);
  }
}

// A block at a depth of 5 % of its height, with friction and without: the moves of the step that drags it.
TEST_CASE("frozen forces leave a quarter of each move, and six corrections a thousandth", "[motion]") {
  for (const double friction : {0.0, 0.3}) {
    CAPTURE(friction);
    Two of = blocks(1);
    of.friction = friction;
    const Assembled bodies = assembled(of);
    const auto moves = [&](int corrections) {
      const Place pressed = step(bodies, at_rest(bodies), {0, -0.05}, 60, corrections);
      const Place dragged = step(bodies, pressed.u, {0.1, -0.05}, 60, corrections);
      CHECK(pressed.arrived);
      CHECK(dragged.arrived);
      return dragged.moves;
    };
    const std::vector<double> frozen = moves(0), corrected = moves(6);
    CHECK(frozen.size() <= 25);
    CHECK(frozen.size() > 10);
    CHECK(corrected.size() <= 6);
    for (std::size_t k = corrected.size() - 2; k < corrected.size(); ++k) {
      CAPTURE(k, corrected[k - 1], corrected[k]);
      CHECK(corrected[k] <= 2e-3 * corrected[k - 1] + rounding);
    }
  }
}

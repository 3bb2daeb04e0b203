// Random scenes of bodies that move, by the arithmetic of the tests.
#include "catch_compat.hpp"
#include "support/random_outcomes.hpp"

using namespace signorini;
using namespace signorini_test;

TEST_CASE("random bodies that move are never silently wrong, and mostly solved",
          "[motion][random]") {
  int unsolved = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Trial trial = try_scene(seed, RandomScenes::Moving);
    CAPTURE(seed, trial.text);
    CHECK_FALSE(is_fault(trial.outcome));
    if (trial.outcome != Outcome::Solved) ++unsolved;
  }
  CHECK(unsolved <= 3);
}

TEST_CASE("that check notices forces and places that are a little off", "[motion][random]") {
  int forces = 0;  // some tools never touch
  int places = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto wrong = [seed](void (*change)(Solution & solution)) {
      return try_scene(seed, RandomScenes::Moving, "", change).outcome == Outcome::Wrong;
    };
    forces += wrong([](Solution& solution) { solution.refined.force *= 1 + 1e-6; });
    places += wrong([](Solution& solution) {
      for (NodeArray& moved : solution.displacements) moved *= 1 + 1e-6;
    });
  }
  CAPTURE(forces, places);
  CHECK(forces >= 14);
  CHECK(places >= 14);
}

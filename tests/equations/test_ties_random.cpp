// Random scenes with ties.
#include "addons/equations/bonds.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/solution.hpp"
#include "support/random_scenes.hpp"

using namespace signorini;

// Two bodies of every kind in the place of the contact between them, some of them sliding, with loads, heat, springs and
// friction elsewhere: what is solved holds, and what is not says why.
TEST_CASE("random scenes with ties are solved and certified, or refused", "[ties][random]") {
  int held = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    const Scene scene = signorini_test::random_scene(seed, signorini_test::RandomScenes::Tied).scene;
    if (!scene.bonds) continue;
    try {
      const Solution solution = solve(scene);
      if (solution.contact.report.status != SolveStatus::Solved) continue;
      CHECK(solution.certificate.holds());
      ++held;
    } catch (const ProblemError&) {
    }
  }
  CHECK(held >= 20);
}

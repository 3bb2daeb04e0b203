// Random scenes of all kinds: none may be called solved and be wrong, by arithmetic of another kind.
#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "support/random_outcomes.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

using Counts = std::array<int, n_outcomes>;

int of(const Counts& counts, Outcome outcome) { return counts[static_cast<std::size_t>(outcome)]; }

/// Solves the scenes of the seeds below `count` with a solver, empty for the default.
Counts outcomes(RandomScenes kind, const std::string& solver, std::uint64_t count) {
  Counts counts{};
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Trial trial = try_scene(seed, kind, solver);
    CAPTURE(seed, solver, trial.text, trial.errors.worst());
    CHECK_FALSE(is_fault(trial.outcome));
    ++counts[static_cast<std::size_t>(trial.outcome)];
  }
  return counts;
}

/// Scenes that a method gave up on, and said so.
int given_up(const Counts& counts) {
  return of(counts, Outcome::Ray) + of(counts, Outcome::Limit) + of(counts, Outcome::Breakdown);
}

/// How many of the scenes of the first seeds are right, once a solution has been spoilt.
int right_when(RandomScenes kind, void (*spoilt)(Solution&)) {
  int right = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Outcome outcome = try_scene(seed, kind, "", spoilt).outcome;
    right += outcome == Outcome::Solved || outcome == Outcome::Hovers || outcome == Outcome::Unsaid;
  }
  return right;
}

/// The largest number, or null if all vanish.
double* largest_of(Eigen::VectorXd& numbers) {
  double* const begin = numbers.data();
  double* const end = begin + numbers.size();
  double* const found =
      std::max_element(begin, end, [](double a, double b) { return std::abs(a) < std::abs(b); });
  return found != end && *found != 0 ? found : nullptr;
}

}  // namespace

TEST_CASE("no random scene is solved and wrong, and what is not solved says so", "[random]") {
  const Counts counts = outcomes(RandomScenes::Frictionless, "", 300);
  CHECK(of(counts, Outcome::Solved) >= 200);
  CHECK(of(counts, Outcome::Refused) + of(counts, Outcome::Escaped) <= 60);
  CHECK(of(counts, Outcome::Infeasible) == 0);
  CHECK(of(counts, Outcome::Unsaid) <= 6);
  CHECK(given_up(counts) <= 6);
}

TEST_CASE("no random body of revolution is solved and wrong, and what is not solved says so",
          "[random][axial]") {
  const Counts counts = outcomes(RandomScenes::Revolved, "", 150);
  CHECK(of(counts, Outcome::Solved) >= 100);
  CHECK(of(counts, Outcome::Infeasible) == 0);
  CHECK(given_up(counts) <= 3);
}

TEST_CASE("nor is one on triangles", "[random]") {
  const Counts counts = outcomes(RandomScenes::Triangles, "", 300);
  CHECK(of(counts, Outcome::Solved) >= 200);
  CHECK(of(counts, Outcome::Refused) + of(counts, Outcome::Escaped) <= 60);
  CHECK(of(counts, Outcome::Infeasible) == 0);
  CHECK(of(counts, Outcome::Unsaid) <= 6);
  CHECK(given_up(counts) <= 6);
}

// 10 000 of them under the sanitizers: random_scenes any default 0 10000.
TEST_CASE(
    "a scene of any kind, however odd or wrong, is solved and right, refused in clear words, or "
    "says why not",
    "[random][effects]") {
  const Counts counts = outcomes(RandomScenes::Any, "", 200);
  CHECK(of(counts, Outcome::Solved) >= 50);
  CHECK(of(counts, Outcome::Refused) >= 80);
}

TEST_CASE(
    "what no scene may have is in some random scenes, and a message without a way out is unclear",
    "[random]") {
  int wrong = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    wrong += random_scene(seed, RandomScenes::Any).wrong;
  CHECK(wrong >= 25);
  CHECK(is_clear("mesh 'block' has no cells: make it with a generator"));
  CHECK_FALSE(is_clear("mesh 'block' has no cells"));
  CHECK_FALSE(is_clear("thickness must be positive"));  // whose?
}

TEST_CASE("no random scene with friction is solved and wrong, and what is not solved says so",
          "[random][friction]") {
  const Counts counts = outcomes(RandomScenes::Frictional, "", 150);
  CHECK(of(counts, Outcome::Solved) >= 110);
  CHECK(of(counts, Outcome::Refused) + of(counts, Outcome::Escaped) <= 25);
  CHECK(of(counts, Outcome::Infeasible) == 0);
  CHECK(given_up(counts) <= 12);
}

TEST_CASE("refinement ends neither before its forces are exact nor with loads that rounding makes",
          "[random]") {
  // The first two stopped a sweep early and were called breakdowns, the others threw.
  for (const std::uint64_t seed : {1516, 6750, 10809, 13714}) {
    const Trial trial = try_scene(seed, RandomScenes::Frictionless);
    CAPTURE(seed, trial.text);
    CHECK((trial.outcome == Outcome::Solved || trial.outcome == Outcome::Hovers ||
           trial.outcome == Outcome::Unsaid));
    CHECK(trial.errors.worst() <= 1e-15);
  }
}

TEST_CASE("bodies that nothing pushes rest where they only touch, with no force of rounding size",
          "[random]") {
  // Of the frictional ones all but the first two, of the others all have no load.
  const auto rests = [](std::uint64_t seed, RandomScenes kind) {
    const Trial trial = try_scene(seed, kind);
    CAPTURE(seed, trial.text);
    CHECK((trial.outcome == Outcome::Solved || trial.outcome == Outcome::Hovers));
    CHECK(trial.errors.worst() <= 1e-14);
  };
  for (const std::uint64_t seed : {3116, 12380, 11337, 16772, 17444, 18041, 21250})
    rests(seed, RandomScenes::Frictional);
  for (const std::uint64_t seed : {3650, 5185, 10038, 14974, 18825, 20276})
    rests(seed, RandomScenes::Frictionless);
}

// A disc with its rim held above a plane: its forces of 1e-61 are rounding of a gap of 1e-5, and need not be in balance.
TEST_CASE("forces that no two doubles resolve are not asked for their balance", "[random]") {
  const Trial trial = try_scene(910795, RandomScenes::Frictionless);
  CAPTURE(trial.text, trial.errors.balance);
  CHECK_FALSE(is_fault(trial.outcome));
  CHECK(trial.errors.balance == 0);
}

// A ring under loads in balance rests on a single pair, which carries 1e-28 of the load: how far it comes down is open.
TEST_CASE("a lone force that is rounding of the loads holds no body", "[random]") {
  const Trial trial = try_scene(23480, RandomScenes::Any);
  CAPTURE(trial.text);
  CHECK(trial.outcome != Outcome::Disputed);
  CHECK_FALSE(is_fault(trial.outcome));
}

TEST_CASE("neither a method that rounding leads astray nor a set that cannot be refined is the end",
          "[random]") {
  for (const std::uint64_t seed : {11348, 21732}) {
    const Trial trial = try_scene(seed, RandomScenes::Frictionless);
    CAPTURE(seed, trial.text);
    CHECK(trial.outcome == Outcome::Solved);
    CHECK(trial.errors.worst() <= 1e-12);
  }
  // Twice as many Gauss points as nodes, and a beam 300 times as long as thick: how it is told to slide decides, to the last
  // bit, whether a set is found that can be refined.
  CHECK_FALSE(is_fault(try_scene(15570, RandomScenes::Frictionless).outcome));
  // Rings, node over node, that only rounding of the normals held.
  const Trial turns = try_scene(6165, RandomScenes::Frictionless);
  CAPTURE(turns.text);
  CHECK(turns.outcome == Outcome::Refused);
}

// A check that sees no fault of a millionth is none. Scenes without forces, gaps or slips, or with small ones
// beside the loads and displacements, stay right.
TEST_CASE("the check of random scenes sees a millionth of any number, and false names",
          "[random]") {
  const auto nothing = [](Solution&) {};
  const auto force = [](Solution& s) {
    if (double* const most = largest_of(s.refined.force)) *most *= 1 + 1e-6;
  };
  const auto displacement = [](Solution& s) {
    if (double* const most = largest_of(s.refined.displacement)) *most *= 1 + 1e-6;
  };
  const auto gap = [](Solution& s) {
    if (double* const most = largest_of(s.contact.gap)) *most *= 1 + 1e-6;
  };
  const auto status = [](Solution& s) {
    for (ContactStatus& now : s.contact.contact_status)
      now = friction_sign(now) != 0 ? ContactStatus::Stick : now;
  };
  for (const RandomScenes kind :
       {RandomScenes::Frictionless, RandomScenes::Frictional, RandomScenes::Paths}) {
    const int right = right_when(kind, nothing);
    CHECK(right >= 40);
    CHECK(right_when(kind, force) <= right / 4);
    CHECK(right_when(kind, displacement) <= right / 4);
    CHECK(right_when(kind, gap) <= right / 2);
    if (kind != RandomScenes::Frictionless) CHECK(right_when(kind, status) <= 2 * right / 3);
  }
}

TEST_CASE("no random scene with the rarer effects is solved and wrong", "[random][effects]") {
  const Counts counts = outcomes(RandomScenes::Varied, "", 150);
  CHECK(of(counts, Outcome::Solved) >= 100);
  CHECK(of(counts, Outcome::Refused) + of(counts, Outcome::Escaped) <= 30);
  CHECK(of(counts, Outcome::Infeasible) == 0);
  CHECK(given_up(counts) <= 9);
}

// The laws of every step hold for the slip since the step before, summed anew from the displacements; the work that was put
// in is found again in strains and friction. 1200 of them: random_scenes paths default 0 1200.
TEST_CASE("no step of a random path with friction is solved and wrong",
          "[random][friction][steps]") {
  const Counts counts = outcomes(RandomScenes::Paths, "", 60);
  CHECK(of(counts, Outcome::Solved) >= 40);
  CHECK(of(counts, Outcome::Refused) + of(counts, Outcome::Escaped) <= 12);
  CHECK(of(counts, Outcome::Infeasible) == 0);
  CHECK(given_up(counts) <= 3);
}

// Each had a step whose pair carried the shear that cohesion allows, with nothing that presses it, and was told open.
TEST_CASE("a pair of a random path that carries shear is closed", "[random][friction][steps]") {
  for (const std::uint64_t seed : {50791, 60753, 62886}) {
    const Trial trial = try_scene(seed, RandomScenes::Paths);
    CAPTURE(seed, trial.text);
    CHECK(trial.outcome != Outcome::Wrong);
    CHECK(trial.errors.worst() <= 1e-12);
  }
}

TEST_CASE("a ray says what is known and which friction to take less of", "[random][friction]") {
  int rays = 0;
  for (const std::uint64_t seed : {35, 47, 91}) {
    const Scene scene = random_scene(seed, RandomScenes::Frictional).scene;
    const Solution solution = solve(scene);
    if (solution.contact.report.status != SolveStatus::Ray) continue;
    ++rays;
    Ledger ledger;
    const Model model = build(scene, ledger);
    CAPTURE(seed, solution.contact.reason);
    CHECK_FALSE(model.modes.empty());
    const std::string most =
        text("largest friction coefficient is ", model.law.coefficient.maxCoeff(), ", of pair ");
    CHECK_THAT(solution.contact.reason, ContainsSubstring("proves nothing") &&
                                            ContainsSubstring(most) &&
                                            ContainsSubstring("hold the bodies"));
  }
  CHECK(rays > 0);
}

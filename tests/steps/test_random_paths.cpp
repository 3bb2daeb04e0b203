// Random paths gone again: to the same bits, from a state on the way, in other units, with nodes in another order.
#include <utility>

#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "support/hertz.hpp"
#include "support/paths.hpp"
#include "support/random_scenes.hpp"
#include "support/same_scenes.hpp"
#include "support/sample.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

/// All that a path told, and how it ended.
struct Record {
  std::vector<std::string> states;  ///< as written
  std::vector<PathState> steps;
  std::vector<Index> iterations;
  std::string end;
};

Record record(const Scene& scene, const PathState& from = {}) {
  Record result;
  try {
    const PathEnd end = solve_steps(
        scene,
        [&](const Model&, const Step& step) {
          result.steps.push_back(step.state);
          result.states.push_back(written(step.state));
          result.iterations.push_back(step.solution.contact.report.iterations);
        },
        from);
    result.end = text(to_string(end.status), ' ', end.halvings, ' ', end.reason);
  } catch (const ProblemError& error) {
    result.end = error.what();
  }
  return result;
}

}  // namespace

TEST_CASE("a random path repeats to the bit, and goes on from a state on its way",
          "[random][steps]") {
  Index restarts = 0;
  for (std::uint64_t seed = 100; seed < 140; seed += sample_step) {
    const Scene scene = random_scene(seed, RandomScenes::Paths).scene;
    const Record first = record(scene);
    const Record again = record(scene);
    CAPTURE(seed, first.end);
    CHECK(again.states == first.states);
    CHECK(again.iterations == first.iterations);
    CHECK(again.end == first.end);
    if (first.states.size() < 3) continue;
    const std::size_t stop = 1 + seed % (first.states.size() - 2);
    const Record rest = record(scene, read_state(first.states[stop], "saved"));
    ++restarts;
    CHECK(rest.states ==
          std::vector<std::string>(first.states.begin() + stop + 1, first.states.end()));
  }
  CHECK(restarts >= 25 / sample_step);
}

TEST_CASE("a random path in units of other powers of two has the same bits, scaled",
          "[random][steps][units]") {
  const double length = 0x1p-20;
  const double force = 0x1p16;
  for (std::uint64_t seed = 140; seed < 180; ++seed) {
    const Scene scene = random_scene(seed, RandomScenes::Paths).scene;
    const Record first = record(scene);
    const Record other = record(in_units(scene, length, force));
    CAPTURE(seed, first.end, other.end);
    CHECK(other.iterations == first.iterations);
    REQUIRE(other.steps.size() == first.steps.size());
    for (std::size_t k = 0; k < first.steps.size(); ++k) {
      const PathState& a = first.steps[k];
      const PathState& b = other.steps[k];
      CHECK(b.contact_status == a.contact_status);
      CHECK(b.slip == length * a.slip);
      CHECK(b.dissipation == force * length * a.dissipation);
      CHECK(b.solution.force == force * a.solution.force);
      CHECK(b.solution.displacement == length * a.solution.displacement);
    }
  }
}

// Where no pair is at an edge that rounding decides.
TEST_CASE(
    "a path in other units, or with nodes in another order, does the same in as many iterations",
    "[steps][friction][units][invariance]") {
  Scene disc = hertz();
  disc.bodies[0].loads.edges[0].history = "load";
  disc.contacts[0].friction = Friction{0.3, 0};
  disc.path = Path{equal_steps(5, 5), {{"load", {0, 3, 5}, {0, 1.2, 0.4}}}};
  for (const Scene& scene : {slab(4, {1, -0.5, 0.25}), disc}) {
    const Record first = record(scene);
    REQUIRE(first.steps.size() >= 5);
    const Record shuffled = record(renumbered(scene, 3).scene);
    std::vector<std::pair<Record, Eigen::Vector2d>> others = {{shuffled, {1, 1}}};
    for (const double length : {1e3, 1e-6})
      for (const double force : {1.0, 1e-5})
        others.push_back({record(in_units(scene, length, force)), {length, force}});
    for (const auto& [other, unit] : others) {
      CAPTURE(unit.transpose());
      CHECK(other.iterations == first.iterations);
      REQUIRE(other.steps.size() == first.steps.size());
      for (std::size_t k = 0; k < first.steps.size(); ++k) {
        const PathState& a = first.steps[k];
        const PathState& b = other.steps[k];
        CHECK(b.contact_status == a.contact_status);
        const Eigen::VectorXd& force = a.solution.force;
        CHECK((b.solution.force / unit.y() - force).norm() <= 1e-11 * force.norm());
        CHECK((b.slip / unit.x() - a.slip).norm() <= 1e-11 * a.slip.norm());
      }
    }
  }
}

// Pairs that slid are then at their bounds and do not move: slips of rounding size have either sign.
TEST_CASE("a step in which nothing changes is solved, and nothing moves",
          "[random][steps][friction]") {
  std::vector<Scene> scenes = {slab(2, {1, -1})};
  for (const std::uint64_t seed : {195, 308, 766, 950})
    scenes.push_back(random_scene(seed, RandomScenes::Paths).scene);
  for (const Scene& scene : scenes) {
    Ledger ledger;
    Model model = build(scene, ledger);
    CondensedPath path = condense_path(model, ledger);
    PathState state;
    for (const double time : scene.path->times) {
      const Step moved = step(state, time, model, path, {});
      REQUIRE(moved.solution.contact.report.status == SolveStatus::Solved);
      // The same loads again: the state is as if it were of an earlier time.
      PathState past = moved.state;
      past.time = state.time;
      const Step again = step(past, time, model, path, {});
      REQUIRE(again.solution.contact.report.status == SolveStatus::Solved);
      const auto pushed = [&](const Step& now) {
        return Eigen::VectorXd(model.programme.A.transpose() * now.state.solution.force);
      };
      const Eigen::VectorXd& slip = moved.state.slip;
      CHECK((pushed(again) - pushed(moved)).norm() <= 1e-9 * pushed(moved).norm());
      CHECK((again.state.slip - slip).norm() <= 1e-9 * slip.norm());
      state = moved.state;
    }
  }
}

#include <algorithm>

#include "../chapters/ch15_friction_remembers/blocks.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex15_6;
using namespace signorini;

namespace {

// A high block on another one, pressed and pushed aside: it lifts off behind. Walking along the top of the lower one, places
// come from right to left.
Scene stacked(double unit, const Friction& law) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = block("upper", {unit, 0}, {2 * unit, 2 * unit}, 10, 10);
  scene.bodies[1].mesh = block("lower", {0, -2 * unit}, {4 * unit, 2 * unit}, 14, 5);
  for (Body& body : scene.bodies) body.material = {1000, 0.3, PlaneState::Strain, 1};
  scene.bodies[1].supports = {fixed("bottom")};
  scene.bodies[0].loads.edges = {
      {"top", 5, [](const Eigen::Vector2d&) { return Eigen::Vector2d(1.2, 0); }}};
  scene.contacts = {{{"top", "lower"}, Side{"bottom", "upper"}}};
  scene.contacts[0].friction = law;
  return scene;
}

Breach check(const SolvedScene& run, const std::vector<Pair>& pairs) {
  const ContactState& state = run.solution.contact;
  REQUIRE(pairs.size() == static_cast<std::size_t>(state.force.size()));
  const std::vector<State> states = states_of(pairs);
  for (std::size_t i = 1; i < pairs.size(); ++i) CHECK(pairs[i - 1].x <= pairs[i].x);
  for (std::size_t k = 0; k < state.frictional_pairs.size(); ++k) {
    const double x = run.model.pairs.position(state.frictional_pairs[k], 0);
    const auto pair =
        std::find_if(pairs.begin(), pairs.end(), [x](const Pair& each) { return each.x == x; });
    REQUIRE(pair != pairs.end());
    const State found = states[static_cast<std::size_t>(pair - pairs.begin())];
    const ContactStatus contact_status = status_of_slip(state, Eigen::Index(k));
    CAPTURE(x, to_string(contact_status));
    CHECK(found == (contact_status == ContactStatus::Open    ? State::Open
                    : contact_status == ContactStatus::Stick ? State::Stick
                                                             : State::Slide));
    CHECK(pair->friction == state.friction(static_cast<Eigen::Index>(k)));
  }
  return breach_of(pairs);
}

}  // namespace

TEST_CASE("ex15.6 held out: two blocks, in any unit, with and without cohesion", "[ex15.6]") {
  for (const double unit : {1e-9, 1.0, 1e9})
    for (const Friction& law : {Friction{0.4, 0}, Friction{0.3, 0.5}, Friction{0, 4}}) {
      CAPTURE(unit, law.coefficient, law.cohesion);
      const SolvedScene run = solved(stacked(unit, law), "two blocks");
      const std::vector<Pair> pairs = pairs_of(run);
      const Breach breach = check(run, pairs);
      CHECK(std::max({breach.cone, breach.sliding, breach.against}) < 1e-12);
      double bound = 0, expected = 0;
      for (const Pair& pair : pairs) bound += pair.bound;
      for (const Eigen::Index i : run.solution.contact.active())
        expected += law.coefficient * run.solution.contact.force(i) +
                    law.cohesion * run.model.pairs.weight(i);
      CHECK(bound == Approx(expected).epsilon(1e-12));
      CHECK(run.solution.contact.active().size() < pairs.size());
    }
}

// On a line of symmetry a pair cannot slide: it has no slip, and is there all the same.
TEST_CASE("ex15.6 held out: a pair that cannot slide", "[ex15.6]") {
  Scene scene;
  Body& half = scene.bodies[0];
  half.mesh = block("half", {0, 0}, {3, 1}, 6, 3);
  half.material = {1000, 0.3, PlaneState::Strain, 1};
  half.supports = {symmetric("left")};
  half.loads.edges = {{"top", 2, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{0.02, 0};
  const SolvedScene run = solved(scene, "half of a block");
  REQUIRE(run.solution.contact.frictional_pairs.size() == 6);
  const std::vector<Pair> pairs = pairs_of(run);
  static_cast<void>(check(run, pairs));
  REQUIRE(pairs.size() == 7);
  CHECK(pairs[0].x == 0);
  CHECK(pairs[0].bound == 0);
  CHECK(states_of(pairs)[0] == State::Stick);
  CHECK(states_of(pairs)[6] == State::Slide);
}

TEST_CASE("ex15.6 held out: nothing moves, and nothing presses", "[ex15.6]") {
  const std::vector<Pair> still = {{0, 0, 3, 1, 0, 1.5}, {1, 0, 2, -1, 0, 1}};
  CHECK(states_of(still) == std::vector<State>{State::Stick, State::Stick});
  const std::vector<Pair> loose = {{0, 2, 0, 0, 1, 0}, {1, 3, 0, 0, -1, 0}};
  CHECK(states_of(loose) == std::vector<State>{State::Open, State::Open});
  for (const std::vector<Pair>& pairs : {still, loose, std::vector<Pair>{}}) {
    const Breach breach = breach_of(pairs);
    CHECK(breach.cone == 0);
    CHECK(breach.sliding == 0);
    CHECK(breach.against == 0);
  }
}

// A pair that is open may move along the wall, but no pair has friction it.
TEST_CASE("ex15.6 held out: friction across a gap breaks the law", "[ex15.6]") {
  const std::vector<Pair> pairs = {{0, 0, 10, 2, 0, 5}, {1, 0.5, 0, -1, 1, 0}};
  CHECK(breach_of(pairs).cone == Approx(0.1).epsilon(1e-12));
  CHECK(breach_of(pairs).against == 0);
}

TEST_CASE("ex15.6 held out: the block on an incline, just before it slides", "[ex15.6]") {
  const SolvedScene run =
      solved(ch15::incline(0.999 * std::atan(0.4), Friction{0.4, 0}), "the incline");
  const Breach breach = check(run, pairs_of(run));
  CHECK(std::max({breach.cone, breach.sliding, breach.against}) < 1e-12);
}

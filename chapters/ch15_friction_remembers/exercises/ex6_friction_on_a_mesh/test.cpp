#include <algorithm>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "meshes/block.hpp"

using namespace ex15_6;
using namespace signorini;

// Half of the square of the chapter, on fewer cells: in mm and MPa.
static Scene square(Eigen::Index cells) {
  Scene scene;
  Body& block = scene.bodies[0];
  block.mesh = signorini::block("block", {0, 0}, {40, 40}, cells, cells);
  block.material = {1.3e5, 0.2, PlaneState::Strain, 1};
  block.supports = {symmetric("right"), prescribed_at("bottom", {40, 0}, Axis::Y)};
  block.loads.edges = {{"top", 50, {}}, {"left", 150, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{1, 0};
  return scene;
}

// As the library says it, from left to right: the pairs of the square stand in that order.
static std::vector<State> known(const SolvedScene& run) {
  std::vector<State> states;
  for (const ContactStatus contact_status : run.solution.contact.contact_status)
    states.push_back(contact_status == ContactStatus::Open    ? State::Open
                     : contact_status == ContactStatus::Stick ? State::Stick
                                                              : State::Slide);
  return states;
}

TEST_CASE("ex15.6 three pairs by hand", "[ex15.6]") {
  const std::vector<Pair> pairs = {
      {0, 0.2, 1e-17, 0, 0.1, 0}, {1, 0, 10, 5, -0.1, 5}, {2, -1e-17, 20, 3, 1e-16, 10}};
  CHECK(states_of(pairs) == std::vector<State>{State::Open, State::Slide, State::Stick});
  const Breach breach = breach_of(pairs);
  CHECK(breach.cone == Approx(0).margin(1e-14));
  CHECK(breach.sliding == Approx(0).margin(1e-14));
  CHECK(breach.against == Approx(0).margin(1e-14));
}

TEST_CASE("ex15.6 one pair for each way to break the law", "[ex15.6]") {
  const std::vector<Pair> good = {{0, 0, 20, -10, 0.2, 10}, {1, 0, 10, 4, 0, 5}};
  std::vector<Pair> pairs = good;
  pairs[1].friction = -6;
  CHECK(breach_of(pairs).cone == Approx(0.05).epsilon(1e-12));
  CHECK(breach_of(pairs).sliding == 0);
  pairs = good;
  pairs[1].slip = -0.1;
  CHECK(breach_of(pairs).sliding == Approx(0.05).epsilon(1e-12));
  CHECK(breach_of(pairs).against == 0);
  pairs = good;
  pairs[0].slip = -0.1;
  CHECK(breach_of(pairs).against == Approx(0.5).epsilon(1e-12));
  CHECK(breach_of(pairs).cone == 0);
}

TEST_CASE("ex15.6 the square sticks, slides and opens", "[ex15.6]") {
  for (const Eigen::Index cells : {8, 16}) {
    CAPTURE(cells);
    const SolvedScene run = solved(square(cells), "the square");
    const std::vector<Pair> pairs = pairs_of(run);
    const std::vector<State> states = states_of(pairs);
    CHECK(std::count(states.begin(), states.end(), State::Open) == cells / 8);
    CHECK(std::count(states.begin(), states.end(), State::Stick) == cells / 4);
    CHECK(states == known(run));
    const Breach breach = breach_of(pairs);
    CHECK(std::max({breach.cone, breach.sliding, breach.against}) < 1e-12);
    double friction = 0, bound = 0;
    for (const Pair& pair : pairs) friction += pair.friction, bound += pair.bound;
    CHECK(friction == Approx(run.solution.contact.friction.sum()).epsilon(1e-12));
    CHECK(bound == Approx(run.solution.contact.force.sum()).epsilon(1e-12));
  }
}

TEST_CASE("ex15.6 what is not solved has no pairs to read", "[ex15.6]") {
  SolvedScene run = solved(square(4), "the square");
  run.solution.contact.report.status = SolveStatus::IterationLimit;
  CHECK_THROWS_AS(pairs_of(run), std::invalid_argument);
}

TEST_CASE("ex15.6 cohesion raises the bound of what is closed", "[ex15.6]") {
  Scene scene = square(8);
  scene.contacts[0].friction = Friction{1, 2};
  for (const Pair& pair : pairs_of(solved(scene, "the square")))
    if (pair.bound != 0) CHECK(pair.bound > pair.force);
}

// Beside a gap of 1000 one of 0.5 is rounding, and the force of 0.1 is the largest of all.
TEST_CASE("ex15.6 lengths and forces are not compared as numbers", "[ex15.6]") {
  const std::vector<Pair> pairs = {{0, 1000, 0, 0, 0, 0}, {1, 0.5, 0.1, 0, 0, 0.1}};
  CHECK(states_of(pairs) == std::vector<State>{State::Open, State::Stick});
}

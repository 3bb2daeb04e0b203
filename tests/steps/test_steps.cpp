// Load steps: what must not depend on how a path is gone, and what a step costs.
#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/problem/scaled.hpp"
#include "support/cantilever.hpp"
#include "support/checked_path.hpp"
#include "support/hertz.hpp"
#include "support/paths.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::VectorXd;

TEST_CASE("without friction many proportional steps end where one does", "[steps]") {
  Scene scene = cantilever("q4_incompatible", 30, 3);
  scene.bodies[0].temperature = Temperature{};
  const Solution whole = solve(scene);
  scene.bodies[0].loads.edges[0].history = "pressure";
  for (const int count : {1, 7, 20}) {
    scene.path = Path{equal_steps(count), {proportional("pressure")}};
    const std::vector<Step> steps = steps_of(scene);
    REQUIRE(steps.size() == static_cast<std::size_t>(count));
    const Solution& last = steps.back().solution;
    CHECK(last.contact.active() == whole.contact.active());
    CHECK((last.contact.force - whole.contact.force).norm() <= 1e-12 * whole.contact.force.norm());
    CHECK((last.displacements[0] - whole.displacements[0]).norm() <=
          1e-12 * whole.displacements[0].norm());
  }
}

TEST_CASE("a disc that contact alone holds: twice the load and back again", "[steps]") {
  Scene scene = hertz();
  scene.bodies[0].loads.edges[0].history = "load";
  scene.path = Path{{1, 2, 3}, {{"load", {1, 2, 3}, {1, 2, 1}}}};
  const std::vector<Step> steps = steps_of(scene);
  const VectorXd& first = steps[0].state.solution.force;
  CHECK(std::abs(steps[1].state.solution.force.sum() / first.sum() - 2) < 1e-10);
  CHECK(steps[1].solution.contact.active().size() > steps[0].solution.contact.active().size());
  CHECK((steps[2].state.solution.force - first).norm() <= 1e-10 * first.norm());
}

TEST_CASE("what is known of the matrices of a path changes no bit", "[steps]") {
  Scene apart = cantilever("q4_incompatible", 20, 3);  // a second body that meets nothing
  apart.bodies.push_back(apart.bodies[0]);
  apart.bodies[0].mesh.name = "beam";
  apart.bodies[1].mesh.name = "other";
  apart.bodies[1].mesh.nodes.col(1).array() += 100;
  apart.bodies[1].loads.edges[0].pressure *= 1e-9;
  apart.contacts[0].source.body = "beam";
  Scene rough = cantilever("q4_incompatible", 30, 3);
  rough.contacts[0].friction = Friction{0.3};
  for (Scene scene : {cantilever("q4_incompatible", 30, 3), hertz(), apart, rough}) {
    for (Body& body : scene.bodies)
      for (EdgeLoad& load : body.loads.edges) load.history = "load";
    scene.path = Path{equal_steps(3), {proportional("load")}};
    std::vector<Step> ends[2];
    for (const bool known : {true, false}) {
      Ledger ledger;
      Model model = build(scene, ledger);
      CondensedPath path = condense_path(model, ledger);
      CHECK(path.condensed.known.connected == (scene.bodies.back().mesh.name != "other"));
      if (!known) path.condensed.known = {};
      const PathEnd end = solve_steps(
          model, path, ledger, [&](const Model&, const Step& step) { ends[known].push_back(step); },
          {});
      REQUIRE(end.status == SolveStatus::Solved);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Solution& with = ends[1][k].solution;
      const Solution& without = ends[0][k].solution;
      CHECK(with.contact.force == without.contact.force);
      CHECK(with.refined.displacement == without.refined.displacement);
      CHECK(with.refined.displacement_low == without.refined.displacement_low);
      CHECK(with.certificate.worst() == without.certificate.worst());
      CHECK(with.contact.uniqueness == without.contact.uniqueness);
      CHECK(with.notes == without.notes);
    }
  }
}

TEST_CASE("the compliance of a path is equilibrated once, and asked once whether it excludes other solutions",
          "[steps]") {
  Scene scene = cantilever("q4_incompatible", 30, 3);
  scene.contacts[0].friction = Friction{0.3};
  scene.bodies[0].loads.edges[0].history = "load";
  scene.path = Path{equal_steps(4), {proportional("load")}};
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  REQUIRE(path.condensed.known.scaled);
  ScaledProblem& scaled = *path.condensed.known.scaled;
  const double* first = nullptr;
  VectorXd last = VectorXd::Zero(model.programme.A.rows());
  const PathEnd end = solve_steps(model, path, ledger, [&](const Model&, const Step& step) {
    if (first == nullptr) first = scaled.compliance.data();
    CHECK(scaled.compliance.data() == first);
    CHECK(scaled.free != last);
    const bool told = step.state.steps > 1;  // and takes the word for it, whatever is true
    CHECK(scaled.excludes_others == told);
    CHECK(step.solution.contact.uniqueness == (told ? Uniqueness::Proved : Uniqueness::Unknown));
    scaled.excludes_others = true;
    last = scaled.free;
  }, {});
  CHECK(end.status == SolveStatus::Solved);
}

TEST_CASE("every kind of load follows its history: a step is the scene with scaled loads",
          "[steps]") {
  Scene stepped = slab(1, {});
  Body& body = stepped.bodies[0];
  body.material.expansion = 1e-3;
  body.supports = {prescribed("left", Axis::X, -0.01), prescribed("right", Axis::X, 0.02),
                   prescribed_at("bottom", {4, 0}, Axis::Y, 0.003)};
  body.supports[1].history = "one";
  body.supports[2].history = "two";
  body.springs = {{"left", {0, 3}}};
  body.temperature = Temperature{2, {1, -0.5}, "one"};
  body.loads.edges = {
      {"top", 5, [](const Eigen::Vector2d& x) { return Eigen::Vector2d(0.3 * x.x(), 0); }}};
  body.loads.edges[0].history = "two";
  body.loads.edges.push_back({"top", 1, {}});
  body.loads.points = {{{0, 1}, {0.5, -1}, "one"}};
  body.loads.body_force = [](const Eigen::Vector2d& x) { return Eigen::Vector2d(0, -x.x()); };
  body.loads.body_force_history = "one";
  stepped.contacts[0].interference = 0.002;
  stepped.contacts[0].interference_history = "one";
  stepped.path = Path{{1}, {{"one", {1, 2}, {0.3, -0.7}}, {"two", {1, 2}, {0.9, 1.6}}}};
  const Scene now = at_time(stepped, 1);
  const Solution expected = solve(now);
  require_solved(expected, "the slab");
  Ledger ledger;
  const Model fresh = build(now, ledger);
  Model model = build(stepped, ledger);
  set_time(1, model);
  CHECK((model.programme.load - fresh.programme.load).norm() <=
        1e-13 * fresh.programme.load.norm());
  CHECK((model.programme.initial_gap - fresh.programme.initial_gap).norm() <=
        1e-13 * fresh.programme.initial_gap.norm());
  CHECK((model.unknowns.held - fresh.unknowns.held).norm() <= 1e-15);
  const Solution found = steps_of(stepped).front().solution;
  CHECK(found.contact.active() == expected.contact.active());
  CHECK((found.displacements[0] - expected.displacements[0]).norm() <=
        1e-11 * expected.displacements[0].norm());
}

TEST_CASE("a hundred steps along a line keep their digits, and cost no solve", "[steps]") {
  Scene scene = cantilever("q4_incompatible", 60, 6);
  scene.bodies[0].loads.edges[0].history = "pressure";
  const History history{"pressure", {0, 1}, {0.5, 0.505}};
  scene.path = Path{{1}, {history}};
  const std::vector<Step> once = steps_of(scene);
  scene.path = Path{equal_steps(100), {history}};
  const std::vector<Step> steps = steps_of(scene);
  REQUIRE(steps.size() == 100);
  for (std::size_t k = 3; k < steps.size(); ++k) {
    REQUIRE(steps[k].state.contact_status == once[0].state.contact_status);
    CHECK(steps[k].solution.ledger.counted("refinement", "solves") == 0);
  }
  const PrimalDual& one = once[0].state.solution;
  const PrimalDual& last = steps.back().state.solution;
  // The two loads that tell all others are rounded, and a hundred times their difference has that a hundred times.
  const double rounding = 100 * epsilon;
  CHECK((last.force - one.force).norm() / one.force.norm() <= rounding);
  CHECK((last.displacement - one.displacement).norm() / one.displacement.norm() <= rounding);
}

// What is expected of a load that vanishes is rounding, and no place to begin from.
TEST_CASE("a load is taken off again in many steps, and through zero", "[steps]") {
  const double friction = GENERATE(0.0, 0.3);
  const double size = GENERATE(1.0, 1e-3);  // of the load: the smaller one closes no gap
  Scene scene = cantilever("q4_incompatible", 20, 3);
  scene.bodies[0].loads.edges[0].history = "press";
  if (friction > 0) scene.contacts[0].friction = Friction{friction};
  scene.path = Path{equal_steps(16, 4), {{"press", {0, 1, 2, 4}, {0, size, 0, -0.5 * size}}}, 0};
  const std::vector<Step> steps = steps_of(scene);
  REQUIRE(steps.size() == 16);
  for (const Step& step : steps) CHECK(step.solution.certificate.holds());
  CHECK(steps[7].state.solution.displacement.isZero(0));
}

// Whatever pairs do, forces have the digits of a step of which nothing is expected.
TEST_CASE("steps that are expected have the digits of steps that are not", "[steps]") {
  const double friction = GENERATE(0.0, 0.3);
  Scene scene = cantilever("q4_incompatible", 120, 4);
  scene.bodies[0].loads.edges[0].history = "press";
  if (friction > 0) scene.contacts[0].friction = Friction{friction};
  scene.path = Path{equal_steps(40), {proportional("press")}};
  long long with = 0, without = 0;
  for (const TakenTwice& one : steps_taken_twice(scene, 1e-12)) {
    const Ledger &ledger = one.step.solution.ledger, &blind = one.blind.solution.ledger;
    CHECK(ledger.counted("refinement", "sets") <= blind.counted("refinement", "sets"));  // what is refused is refused at once
    with += ledger.counted("refinement", "solves");
    without += blind.counted("refinement", "solves");
  }
  CAPTURE(with, without);
  CHECK(with < without);
}

TEST_CASE("a few steps behind the last change of pairs a step costs no triangular solve, and no other more than four", "[steps]") {
  Scene beam = cantilever("q4_incompatible", 60, 6);
  beam.bodies[0].loads.edges[0].history = "pressure";
  beam.path = Path{equal_steps(20), {proportional("pressure")}};
  for (const bool turns : {false, true}) {
    const std::vector<Step> steps = steps_of(turns ? slab(8, {1, -1}) : beam);
    int same = 0, free_of_charge = 0;  // steps in a row in which no pair changed, and those that cost nothing
    for (std::size_t k = 1; k < steps.size(); ++k) {
      CAPTURE(k);
      const long long solves = steps[k].solution.ledger.counted("refinement", "solves");
      CHECK(solves <= 4);
      // The pairs that did the same last time are no search.
      const bool kept = steps[k].state.contact_status == steps[k - 1].state.contact_status;
      same = kept ? same + 1 : 0;
      free_of_charge += solves == 0 ? 1 : 0;
      if (!turns && same > 2) CHECK(solves == 0);
      CHECK((!kept || steps[k].solution.ledger.counted("contact", "iterations") == 1));
      CHECK(steps[k].solution.ledger.seconds("factor") == 0);
      CHECK(steps[k].solution.ledger.seconds("condensation") == 0);
    }
    if (!turns) CHECK(free_of_charge >= 5);
  }
}

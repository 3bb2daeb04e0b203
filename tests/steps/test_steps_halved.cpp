// Steps that are not solved at once: halves, and where a path ends.
#include <cmath>
#include <limits>
#include <vector>

#include "catch_compat.hpp"
#include "support/paths.hpp"

using namespace signorini;
using namespace signorini_test;

TEST_CASE("a path whose body is pulled away ends where it last touches", "[steps]") {
  // Held by contact alone: pulled up, the slab leaves the ground for ever.
  Scene scene = slab(1, {});
  scene.contacts[0].friction.reset();
  scene.bodies[0].supports = {prescribed("right", Axis::X, 0)};
  scene.bodies[0].loads.edges[0].history = "press";
  scene.path = Path{{1, 2}, {{"press", {0, 1, 2}, {0, 1, -1}}}, 3};
  std::vector<double> times;
  const PathEnd end =
      solve_steps(scene, [&](const Model&, const Step& step) { times.push_back(step.state.time); });
  CHECK(end.status != SolveStatus::Solved);
  REQUIRE(end.limit.has_value());
  CHECK(*end.limit == Approx(1.5).epsilon(1e-14));
  CHECK(times == std::vector<double>{1, end.state.time});
  CHECK(end.state.time <= *end.limit);
  CHECK(*end.limit - end.state.time < 1e-9);
  CHECK(end.halvings == 0);
  CHECK_THAT(end.reason, ContainsSubstring("Contact holds the loads"));  // there is no friction
  // Of a single step nothing is said that means the whole load.
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  const Step failed = step({}, 2, model, path, {});
  CHECK_FALSE(failed.solution.unbounded_direction.empty());
  CHECK_FALSE(failed.solution.limit.has_value());
  CHECK_THAT(why_unsolved(failed.solution), !ContainsSubstring("of this load"));
}

// One pair with cohesion c. While it slides forward its friction pulls it off the wall, which it would overlap without:
// unless it is pressed hard, neither is a solution. Pressed hard on its way, it slides, and then sticks at the end.
TEST_CASE("a step without a solution may have one in two halves: the observer sees both",
          "[steps][friction][closed-form]") {
  Scene scene = slider({"along", {1}, {0}}, {1, 2});
  Body& body = scene.bodies[0];
  body.mesh.nodes.row(2) << 1, 1;  // what pulls the tip up presses it on the wall
  scene.contacts[0].friction = Friction{0, 1};
  Ledger ledger;
  const Model model = build(scene, ledger);
  const double c = model.law.cohesion(0);
  const double k = model.programme.stiffness.coeff(1, 1);
  const double rho = -model.programme.stiffness.coeff(0, 1) / k;
  REQUIRE(rho > 0);
  body.loads.points[0].history = "onto";
  scene.path->histories = {
      {"along", {1, 1.5, 2}, {0, 5.5 * c, 5 * c}},
      {"onto", {1, 1.5, 2}, {2 * rho * c, (10 - 5.5) * rho * c, (0.8 - 5) * rho * c}}};
  std::vector<Step> steps;
  const auto keep = [&](const Model&, const Step& step) { steps.push_back(step); };
  const PathEnd end = solve_steps(scene, keep);
  REQUIRE(end.status == SolveStatus::Solved);
  CHECK(end.halvings == 1);
  REQUIRE(steps.size() == 3);
  // What was tried in vain is of the step that came of it.
  const auto iterations = [&](std::size_t n) { return steps[n].solution.ledger.counted("contact", "iterations"); };
  CHECK(iterations(1) > steps[1].solution.contact.report.iterations);
  CHECK(iterations(2) == steps[2].solution.contact.report.iterations);
  const double time[] = {1, 1.5, 2};
  const double pressed[] = {2, 9, 0.3};
  const double shear[] = {0, -1, -0.5};
  const double slip[] = {0, 4.5, 4.5};
  const ContactStatus contact_status[] = {ContactStatus::Stick, ContactStatus::SlipForward,
                                          ContactStatus::Stick};
  for (std::size_t n = 0; n < 3; ++n) {
    CAPTURE(n);
    CHECK(steps[n].state.time == time[n]);
    CHECK(steps[n].state.contact_status[0] == contact_status[n]);
    CHECK(steps[n].state.solution.force(0) == Approx(pressed[n] * rho * c).epsilon(1e-12));
    CHECK(steps[n].state.solution.force(1) == Approx(shear[n] * c).epsilon(1e-12).margin(1e-15));
    CHECK(steps[n].state.slip(0) == Approx(slip[n] * c / k).epsilon(1e-12).margin(1e-15));
  }
  scene.path->halvings = 0;
  steps.clear();
  const PathEnd stopped = solve_steps(scene, keep);
  CHECK(stopped.status != SolveStatus::Solved);
  CHECK(stopped.state.time == 1);
  CHECK(steps.size() == 1);
  // The same within four neighbouring doubles: it has no more than two halves, however many are allowed.
  const double end_time = 1 + 4 * std::numeric_limits<double>::epsilon();
  scene.path = Path{{1, end_time}, scene.path->histories, 80};
  for (History& history : scene.path->histories) {
    history.times = {1, end_time};
    history.values = {history.values.front(), history.values.back()};
  }
  for (History& history : scene.path->histories) {  // the jump comes with the last double
    history.times.insert(history.times.begin() + 1, std::nextafter(end_time, 0));
    history.values.insert(history.values.begin() + 1, history.values.front());
  }
  const PathEnd closest = solve_steps(scene);
  CHECK(closest.status != SolveStatus::Solved);
  CHECK(closest.state.time == std::nextafter(end_time, 0));
  CHECK(closest.halvings <= 4);
}

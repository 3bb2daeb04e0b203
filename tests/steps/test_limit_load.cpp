// Loads beyond what friction can hold: refused, with the limit.
#include <cmath>

#include "addons/steps/steps.hpp"
#include "addons/steps/steps_limit.hpp"
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/block.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

constexpr double width = 4;

/// A block that rests on the ground by its own weight, 1 per area; so flat that all of it touches.
Scene resting(Friction friction, double angle = 0, double height = 0.25) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("block", {0, 0}, {width, height}, 12, 3);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  body.loads.body_force = [angle](const Eigen::Vector2d&) {
    return Eigen::Vector2d(std::sin(angle), -std::cos(angle));
  };
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = friction;
  return scene;
}

/// The same with all loads times a factor.
Scene loaded(Scene scene, double factor) {
  const VectorField weight = scene.bodies[0].loads.body_force;
  scene.bodies[0].loads.body_force = [weight, factor](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(factor * weight(x));
  };
  return scene;
}

/// The same, pulled along by a force that grows to `pull` until time 1, and is constant then.
Scene pulled(Scene scene, double pull, std::vector<double> times) {
  scene.bodies[0].loads.edges = {
      {"bottom", 0, [pull](const Eigen::Vector2d&) { return Eigen::Vector2d(pull / width, 0); },
       "pull"}};
  scene.path = Path{std::move(times), {proportional("pull")}};
  return scene;
}

}  // namespace

TEST_CASE("a block on an incline holds until tan t = mu", "[friction][limit][closed-form]") {
  for (const double mu : {0.1, 0.5}) {
    const double angle = std::atan(mu);
    CAPTURE(mu);
    const Solution held = solve(resting(Friction{mu, 0}, angle - 1e-10));
    CHECK(held.contact.report.status == SolveStatus::Solved);
    CHECK_FALSE(held.limit.has_value());
    const Solution slides = solve_to_limit(resting(Friction{mu, 0}, angle + 1e-10));
    CHECK(slides.contact.report.status == SolveStatus::Infeasible);
    REQUIRE(slides.limit.has_value());
    CHECK(*slides.limit == 0);  // so does half of its weight
    CHECK_THAT(why_unsolved(slides), ContainsSubstring("no part of this load"));
  }
}

TEST_CASE("a block on an incline with cohesion holds until W sin t = c A + mu W cos t",
          "[friction][limit][closed-form]") {
  const double angle = 0.7;
  for (const Friction& friction :
       {Friction{0.3, 0.1}, Friction{0, 0.1}, Friction{0, 0.1, "tresca"}}) {
    const double most =
        friction.cohesion / (std::sin(angle) - friction.coefficient * std::cos(angle)) / 0.25;
    CAPTURE(friction.coefficient, most);
    const Scene scene = resting(friction, angle);
    const Solution slides = solve_to_limit(scene);
    CHECK(slides.contact.report.status == SolveStatus::Infeasible);
    REQUIRE(slides.limit.has_value());
    CHECK(*slides.limit == Approx(most).epsilon(1e-12).margin(0));
    CHECK_THAT(message_of<NotSolved>([&] { require_solved(slides, "the block"); }),
               ContainsSubstring("at most " + text(most)));
    CHECK(solve(loaded(scene, (1 - 1e-10) * *slides.limit)).contact.report.status ==
          SolveStatus::Solved);
    CHECK(solve(loaded(scene, (1 + 1e-10) * *slides.limit)).contact.report.status ==
          SolveStatus::Infeasible);
  }
}

TEST_CASE("a path ends at the load from which on friction holds nothing",
          "[friction][limit][steps][closed-form]") {
  const double mu = 0.3;
  for (const std::vector<double>& times : {std::vector<double>{1}, {0.25, 0.5, 0.75, 1}, {3}}) {
    const double weight = 0.25 * width;
    const double pull = 2 * mu * weight;  // so the limit is half of it
    const Scene scene = pulled(resting(Friction{mu, 0}), pull, times);
    std::vector<double> solved;
    const PathEnd end = solve_steps(
        scene, [&](const Model&, const Step& step) { solved.push_back(step.state.time); });
    CAPTURE(times.size(), times.back(), end.reason);
    CHECK(end.status == SolveStatus::Infeasible);
    REQUIRE(end.limit.has_value());
    CHECK(*end.limit == Approx(0.5).epsilon(1e-13).margin(0));
    CHECK(end.state.time <= *end.limit);
    CHECK(end.state.time > (1 - 1e-9) * *end.limit);
    CHECK(solved.back() == end.state.time);
    CHECK(end.halvings == 0);
    const Eigen::Index pairs = end.state.solution.force.size() / 2;
    const double friction = end.state.solution.force.tail(pairs).cwiseAbs().sum();
    CHECK(friction == Approx(mu * weight).epsilon(1e-9).margin(0));
    Scene whole = scene;  // without halves no step but those that are given
    whole.path->halvings = 0;
    const PathEnd stopped = solve_steps(whole);
    CHECK(*stopped.limit == Approx(0.5).epsilon(1e-13).margin(0));
    CHECK(stopped.state.steps == (times.size() == 4 ? 2 : 0));
    CHECK_THAT(end.reason,
               ContainsSubstring("until time 0.5 at most") && ContainsSubstring("last good state"));
  }
}

TEST_CASE("a limit between rows of a history, and none of loads that nothing held to begin with",
          "[friction][limit][steps]") {
  // To and fro within one step: it is the way there that fails, not the end.
  Scene scene = pulled(resting(Friction{0.3, 0}), 0.6 * 0.25 * width, {1});
  scene.path->histories[0] = {"pull", {0, 0.4, 1}, {0, 1, 1.1}};
  PathEnd end = solve_steps(scene);
  REQUIRE(end.limit.has_value());
  CHECK(*end.limit == Approx(0.2).epsilon(1e-13).margin(0));
  scene.path->histories[0] = {"pull", {0}, {1}};
  end = solve_steps(scene);
  CHECK(end.status != SolveStatus::Solved);
  CHECK_FALSE(end.limit.has_value());
  CHECK(end.state.steps == 0);
}

// Statics takes all pairs for closed. Here the uphill edge lifts off before, and what is open has no cohesion.
TEST_CASE(
    "a step that fails without a proof is halved, then the path ends with the last good state",
    "[friction][limit][steps]") {
  const double angle = 0.7;
  Scene scene = loaded(resting(Friction{0, 0.2}, angle, 1), 0.2 / std::sin(angle));
  scene.bodies[0].loads.body_force_history = "weight";
  scene.path = Path{{1}, {proportional("weight")}, 3};
  std::vector<double> times;
  const PathEnd end =
      solve_steps(scene, [&](const Model&, const Step& step) { times.push_back(step.state.time); });
  CHECK(end.status != SolveStatus::Solved);
  REQUIRE(end.limit.has_value());
  REQUIRE_FALSE(times.empty());
  CHECK(end.state.time >= *end.limit - 1e-10);
  CHECK(end.state.time <= *end.limit);
  CHECK(end.state.time == times.back());
  CHECK(end.state.time > 0.9);
  CHECK(end.state.time < 0.99);
  CHECK(end.halvings > 3);
  CHECK_THAT(end.reason, ContainsSubstring("last good state") &&
                             ContainsSubstring("halved 3 times") &&
                             ContainsSubstring("nothing is found beyond"));
  // Every other number of halvings leads to the same limit.
  scene.path->halvings = 5;
  CHECK(*solve_steps(scene).limit == Approx(*end.limit).epsilon(1e-9).margin(0));
}

TEST_CASE("a load beyond what is held, without a proof: the limit is found by growing it",
          "[friction][limit]") {
  const double angle = 0.7;
  const Scene full =  // as much as statics could hold
      loaded(resting(Friction{0, 0.2}, angle, 1), 0.2 / std::sin(angle));
  CHECK_FALSE(
      solve(full).limit.has_value());  // found by load steps, which the library does not know
  const Solution slides = solve_to_limit(full);
  CHECK(slides.contact.report.status != SolveStatus::Solved);
  CHECK(slides.unbounded_direction.empty());
  REQUIRE(slides.limit.has_value());
  CHECK(*slides.limit < 0.99);
  CHECK_THAT(why_unsolved(slides), ContainsSubstring(text(*slides.limit)) &&
                                       ContainsSubstring("nothing is found beyond"));
  for (const std::string& note : slides.notes)
    CHECK(note.find("load steps solve it") == std::string::npos);
  CHECK(solve(loaded(full, (1 - 1e-9) * *slides.limit)).contact.report.status ==
        SolveStatus::Solved);
  CHECK(solve(loaded(full, (1 + 1e-9) * *slides.limit)).contact.report.status !=
        SolveStatus::Solved);
}

TEST_CASE("a body that contact alone holds is followed to where it lifts off", "[limit][steps]") {
  Scene scene = resting(Friction{});
  scene.bodies[0].supports = {prescribed("left", Axis::X, 0)};
  scene.contacts[0].friction.reset();
  scene.bodies[0].loads.edges = {
      {"bottom", 0, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0, 0.5); }, "lift"}};
  scene.path = Path{{0.3, 1}, {proportional("lift")}};
  const PathEnd end = solve_steps(scene);
  CHECK(end.status == SolveStatus::Infeasible);
  REQUIRE(end.limit.has_value());
  CHECK(*end.limit == Approx(0.5).epsilon(1e-13).margin(0));
  CHECK(end.state.time > 0.5 - 1e-9);
  CHECK(end.state.steps == 2);
}

// Pressed by given displacements, so that no statics bounds the pressure: what holds the block is what its walls press.
TEST_CASE("a block wedged between walls is pulled out when all of it slides",
          "[friction][limit][steps]") {
  const double mu = 0.2;
  Scene scene = resting(Friction{mu, 0}, 0, 1);
  Body& body = scene.bodies[0];
  body.loads = {};
  scene.contacts.push_back({{"top"}, half_plane({0, 1}, {0, -1})});
  for (ContactSpec& contact : scene.contacts) {
    contact.friction = Friction{mu, 0};
    contact.interference = 0.001;
  }
  body.loads.edges = {
      {"right", 0, [](const Eigen::Vector2d&) { return Eigen::Vector2d(10, 0); }, "pull"}};
  scene.path = Path{{0.01, 1}, {proportional("pull")}};
  const PathEnd end = solve_steps(scene);
  CAPTURE(end.reason);
  CHECK(end.status != SolveStatus::Solved);
  REQUIRE(end.limit.has_value());
  CHECK(end.state.time >= *end.limit - 1e-10);
  const Eigen::VectorXd& force = end.state.solution.force;
  const Eigen::Index pairs = force.size() / 2;
  CHECK(force.tail(pairs).cwiseAbs().sum() == Approx(10 * end.state.time).epsilon(1e-11).margin(0));
  CHECK(force.tail(pairs).cwiseAbs().sum() ==
        Approx(mu * force.head(pairs).sum()).epsilon(1e-8).margin(0));
}

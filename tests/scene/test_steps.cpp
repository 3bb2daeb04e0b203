// Load steps: a slider by hand, and what must not depend on how a path is gone.
#include <cmath>
#include <limits>
#include <sstream>

#include "catch_compat.hpp"
#include "signorini/core/text_reader.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/scene/steps.hpp"
#include "support/cantilever.hpp"
#include "support/message.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double mu = 0.5;

/// One triangle, whose tip is pressed by 1 along x on a wall and pulled along y by `pull`: by symmetry its stiffness
/// is diagonal, so that the pressure on the wall is 1 whatever happens along it.
Scene slider(const History& pull, const std::vector<double>& times) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh.name = "slider";
  body.mesh.nodes.resize(3, 2);
  body.mesh.nodes << 0, -1, 2, 0, 0, 1;
  body.mesh.cells.resize(1, 3);
  body.mesh.cells << 0, 1, 2;
  body.mesh.boundaries = {{"tip", {{0, 0}}}, {"root", {{0, 2}}}};
  body.material = {100, 0.25, PlaneState::Stress, 1};
  body.supports = {fixed("root")};
  body.loads.points = {{{2, 0}, {1, 0}}, {{2, 0}, {0, 1}, pull.name}};
  scene.contacts = {{{"tip"}, half_plane({2, 0}, {-1, 0})}};
  scene.contacts[0].friction = Friction{mu, 0};
  scene.path = Path{times, {pull}};
  return scene;
}

/// A slab on rough ground that bends, pressed first and dragged to and fro.
Scene slab(int steps_per_leg, const std::vector<double>& drag) {
  BlockSpec spec;
  spec.name = "slab";
  spec.size = {4, 1};
  spec.cells_x = 16;
  spec.cells_y = 4;
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = make_block(spec);
  body.material = {1000, 0.3, PlaneState::Strain, 1};
  Support pulled = prescribed("right", Axis::X, 0.01);
  pulled.history = "drag";
  body.supports = {pulled};
  body.loads.edges = {{"top", 5, {}}};
  body.loads.edges[0].history = "press";
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  scene.contacts[0].friction = Friction{0.4, 0};
  const int legs = static_cast<int>(drag.size());
  History press{"press", {0, 1}, {0, 1}};
  History move{"drag", {1}, {0}};
  for (int leg = 0; leg < legs; ++leg) {
    move.times.push_back(leg + 2);
    move.values.push_back(drag[static_cast<std::size_t>(leg)]);
  }
  scene.path = Path{equal_steps(steps_per_leg * (legs + 1), legs + 1), {press, move}};
  return scene;
}

std::vector<Step> steps_of(const Scene& scene, const PathState& from = {}) {
  std::vector<Step> steps;
  const PathEnd end = solve_steps(
      scene, [&](const Model&, const Step& step) { steps.push_back(step); }, from);
  INFO(end.reason);
  REQUIRE(end.status == Status::Solved);
  REQUIRE(end.halvings == 0);
  return steps;
}

bool same(const Step& one, const Step& other) {
  const PathState& a = one.state;
  const PathState& b = other.state;
  return a.time == b.time && a.motion == b.motion && a.slip == b.slip &&
         a.increment == b.increment && a.dissipation == b.dissipation &&
         a.solution.displacement == b.solution.displacement &&
         a.solution.displacement_low == b.solution.displacement_low &&
         a.solution.force == b.solution.force &&
         one.solution.displacements == other.solution.displacements;
}

std::string written(const PathState& state) {
  std::ostringstream out;
  write_state(state, out);
  return out.str();
}

}  // namespace

TEST_CASE("a spring slider goes round its loop: force, slip and dissipation by hand",
          "[steps][friction][closed-form]") {
  const double bound = mu * 1;
  const History pull{"pull", {0, 1, 3, 5}, {0, 2 * bound, -2 * bound, 2 * bound}};
  const Scene scene = slider(pull, equal_steps(40, 5));
  Ledger ledger;
  const Model model = build(scene, ledger);
  const double k = model.programme.stiffness.coeff(1, 1);  // of the tip along y
  REQUIRE(model.programme.stiffness.coeff(0, 1) == Approx(0).margin(1e-14 * k));
  double place = 0;  // of the tip
  double lost = 0;
  double area = 0;  // of pull over place
  double last_place = 0;
  double last_pull = 0;
  WorkMeter meter;
  double lost_before_loop = 0;
  double area_before_loop = 0;
  const PathEnd end = solve_steps(scene, [&](const Model& at, const Step& step) {
    const double force = pull.at(step.state.time);
    // The tip moves no further than friction lets it: |force - k place| <= bound.
    const double before = place;
    place = std::min(std::max(place, (force - bound) / k), (force + bound) / k);
    lost += bound * std::abs(place - before);
    CAPTURE(step.state.time);
    CHECK(step.solution.displacements[0](1, 1) == Approx(place).margin(1e-14));
    CHECK(step.state.dissipation(0) == Approx(lost).margin(1e-14));
    CHECK(std::abs(step.state.slip(0)) == Approx(std::abs(place)).margin(1e-14));
    CHECK(step.state.solution.force(0) == Approx(1).epsilon(1e-13));
    const double now = step.solution.displacements[0](1, 1);
    area += 0.5 * (force + last_pull) * (now - last_place);
    last_place = now;
    last_pull = force;
    meter.add(at, step);
    const Work& work = meter.work();
    CHECK(work.put_in() == Approx(work.strain + work.dissipation).epsilon(1e-12).margin(1e-15));
    CHECK(std::abs(work.between) <= 1e-15);  // every kink is at the end of a step
    if (step.state.time == 1) {
      lost_before_loop = step.state.dissipation(0);
      area_before_loop = area;
    }
  });
  REQUIRE(end.status == Status::Solved);
  CHECK(end.state.steps == 40);
  const double loop = end.state.dissipation(0) - lost_before_loop;
  CHECK(loop == Approx(4 * bound * bound / k).epsilon(1e-12));
  CHECK(area - area_before_loop == Approx(loop).epsilon(1e-10));
}

TEST_CASE("work put in = strain energy + dissipation + what steps do not resolve, at every step",
          "[steps][friction]") {
  double between[2];
  int k = 0;
  for (const int steps : {8, 32}) {
    Scene scene = slab(steps, {1, -1, 1});
    scene.contacts[0].interference = 1e-3;
    WorkMeter meter;
    double most = 0;
    double worst = 0;
    const PathEnd end = solve_steps(scene, [&](const Model& model, const Step& step) {
      meter.add(model, step);
      const Work& work = meter.work();
      worst =
          std::max(worst, std::abs(work.put_in() - work.strain - work.dissipation - work.between));
      most = std::max(most, work.put_in());
    });
    REQUIRE(end.status == Status::Solved);
    CHECK(worst <= 1e-12 * most);
    CHECK(meter.work().dissipation > 0.5 * most);
    CHECK(meter.work().supports > 0.1 * most);
    between[k++] = std::abs(meter.work().between) / most;
  }
  CHECK(between[0] > 1e-6);
  CHECK(between[1] < 0.5 * between[0]);
}

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
    CHECK(last.contact.active == whole.contact.active);
    CHECK((last.contact.force - whole.contact.force).norm() <= 1e-12 * whole.contact.force.norm());
    CHECK((last.displacements[0] - whole.displacements[0]).norm() <=
          1e-12 * whole.displacements[0].norm());
  }
}

TEST_CASE("every kind of load follows its history: a step is the scene with scaled loads",
          "[steps]") {
  const auto scene_with = [](double f, double h, bool path) {
    const std::string one = path ? "one" : "";
    const std::string two = path ? "two" : "";
    Scene scene = slab(1, {});
    scene.path.reset();
    Body& body = scene.bodies[0];
    body.material.expansion = 1e-3;
    body.supports = {prescribed("left", Axis::X, -0.01), prescribed("right", Axis::X, f * 0.02),
                     prescribed_at("bottom", {4, 0}, Axis::Y, h * 0.003)};
    body.supports[1].history = one;
    body.supports[2].history = two;
    body.springs = {{"left", {0, 3}}};
    body.temperature = Temperature{f * 2, {f * 1, f * -0.5}, one};
    body.loads.edges = {{"top", h * 5, [h](const Eigen::Vector2d& x) {
                           return h * Eigen::Vector2d(0.3 * x.x(), 0);
                         }}};
    body.loads.edges[0].history = two;
    body.loads.edges.push_back({"top", 1, {}});
    body.loads.points = {{{0, 1}, {f * 0.5, f * -1}, one}};
    body.loads.body_force = [f](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(0, -f * x.x());
    };
    body.loads.body_force_history = one;
    scene.contacts[0].interference = f * 0.002;
    scene.contacts[0].interference_history = one;
    return scene;
  };
  Scene stepped = scene_with(1, 1, true);
  stepped.path = Path{{1}, {{"one", {1, 2}, {0.3, -0.7}}, {"two", {1, 2}, {0.9, 1.6}}}};
  const Scene now = scene_with(0.3, 0.9, false);
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
  CHECK(found.contact.active == expected.contact.active);
  CHECK((found.displacements[0] - expected.displacements[0]).norm() <=
        1e-11 * expected.displacements[0].norm());
}

TEST_CASE("a stuck path that turns back has the same bits on its way back", "[steps][friction]") {
  Scene scene = slab(4, {1, 0, 1, 0});
  scene.contacts[0].friction = Friction{100, 0};
  scene.bodies[0].supports = {prescribed("right", Axis::X, 0)};
  scene.bodies[0].loads.edges.push_back(
      {"top", 0, [](const Eigen::Vector2d&) { return Eigen::Vector2d(0.5, 0); }, "drag"});
  const std::vector<Step> steps = steps_of(scene);
  REQUIRE(steps.size() == 20);
  const Index rub = steps[3].state.slip.size();
  REQUIRE(rub > 10);
  for (std::size_t k = 4; k < 8; ++k) {  // out, and the next way out
    CHECK(steps[k].state.solution.force == steps[k + 8].state.solution.force);
    CHECK(steps[k].state.solution.displacement == steps[k + 8].state.solution.displacement);
  }
  for (std::size_t k = 8; k < 11; ++k)  // back
    CHECK(steps[k].state.solution.force == steps[14 - k].state.solution.force);
  for (std::size_t k = 4; k < 20; ++k) {
    CHECK(steps[k].state.increment == VectorXd::Zero(rub));
    CHECK(steps[k].state.slip == steps[3].state.slip);
  }
}

// The node that the support drags has no unknown along the ground: its slip is given, its friction acts on the support.
TEST_CASE("a node that a support drags over the ground rubs at its bound", "[steps][friction]") {
  const std::vector<Step> steps = steps_of(slab(4, {1, -1}));
  for (std::size_t k = 4; k < steps.size(); ++k) {
    const ContactState& contact = steps[k].solution.contact;
    const Index last = contact.slip.size() - 1;
    const double given = k < 8 ? 0.0025 : -0.005;
    CAPTURE(k);
    CHECK(contact.slip(last) == Approx(given).epsilon(1e-12));
    CHECK(
        contact.friction(last) ==
        Approx(given > 0 ? -0.4 * contact.force(last) : 0.4 * contact.force(last)).epsilon(1e-13));
  }
}

TEST_CASE("a path goes on from a state that was written and read, to the same bits",
          "[steps][friction]") {
  const Scene scene = slab(4, {1, -0.5});
  const std::vector<Step> all = steps_of(scene);
  const std::vector<Step> again = steps_of(scene);
  for (std::size_t k = 0; k < all.size(); ++k) CHECK(same(all[k], again[k]));
  for (const std::size_t stop : {0, 5, 9}) {
    const PathState saved = read_state(written(all[stop].state), "saved");
    CHECK(written(saved) == written(all[stop].state));
    const std::vector<Step> rest = steps_of(scene, saved);
    REQUIRE(rest.size() == all.size() - stop - 1);
    for (std::size_t k = 0; k < rest.size(); ++k) CHECK(same(rest[k], all[stop + 1 + k]));
  }
}

TEST_CASE("steps after the first cost at most four triangular solves", "[steps]") {
  Scene beam = cantilever("q4_incompatible", 60, 6);
  beam.bodies[0].loads.edges[0].history = "pressure";
  beam.path = Path{equal_steps(20), {proportional("pressure")}};
  for (const Scene& scene : {beam, slab(8, {1, -1})}) {
    const std::vector<Step> steps = steps_of(scene);
    for (std::size_t k = 1; k < steps.size(); ++k) {
      CAPTURE(k);
      CHECK(steps[k].solution.ledger.counted("refinement", "solves") <= 4);
      CHECK(steps[k].solution.ledger.seconds("factor") == 0);
      CHECK(steps[k].solution.ledger.seconds("condensation") == 0);
    }
  }
}

TEST_CASE("a step that fails is halved, then the path ends with the last good state", "[steps]") {
  // Held by contact alone: pulled up, the slab leaves the ground for ever.
  Scene scene = slab(1, {});
  scene.contacts[0].friction.reset();
  scene.bodies[0].supports = {prescribed("right", Axis::X, 0)};
  scene.bodies[0].loads.edges[0].history = "press";
  scene.path = Path{{1, 2}, {{"press", {0, 1, 2}, {0, 1, -1}}}, 3};
  std::vector<double> times;
  const PathEnd end =
      solve_steps(scene, [&](const Model&, const Step& step) { times.push_back(step.state.time); });
  CHECK(end.status != Status::Solved);
  REQUIRE(times.size() > 1);
  CHECK(times.front() == 1);
  CHECK(end.state.time == times.back());
  CHECK(end.state.time <= 1.5);  // without a load it still touches
  CHECK(end.state.time > 1.4);
  CHECK(end.halvings > 3);
  CHECK_THAT(end.reason,
             ContainsSubstring("last good state") && ContainsSubstring("halved 3 times"));
}

TEST_CASE("steps that cannot be meant are refused", "[steps]") {
  const Scene good = slab(2, {1});
  const auto message = [&](const auto& change) {
    Scene scene = good;
    change(scene);
    return problem_message([&] { static_cast<void>(plan(scene)); });
  };
  CHECK(message([](Scene&) {}).empty());
  CHECK_THAT(message([](Scene& s) { s.path->times = {}; }), ContainsSubstring("got none"));
  CHECK_THAT(message([](Scene& s) { s.path->times = {1, 1}; }), ContainsSubstring("1 follows 1"));
  CHECK_THAT(message([](Scene& s) {
               s.path->times = {0, 1};
             }),
             ContainsSubstring("needs a time > 0"));
  CHECK_THAT(message([](Scene& s) { s.path->times = {std::numeric_limits<double>::infinity()}; }),
             ContainsSubstring("finite"));
  CHECK_THAT(message([](Scene& s) { s.path->halvings = -1; }), ContainsSubstring("got -1"));
  CHECK_THAT(message([](Scene& s) { s.path->histories[1].name = "press"; }),
             ContainsSubstring("'press'"));
  CHECK_THAT(message([](Scene& s) { s.path->histories[1].name = ""; }),
             ContainsSubstring("needs a name"));
  CHECK_THAT(message([](Scene& s) { s.path->histories[1].values = {1}; }),
             ContainsSubstring("1 values"));
  CHECK_THAT(message([](Scene& s) { s.path->histories[1].values[0] = NAN; }),
             ContainsSubstring("finite"));
  CHECK_THAT(message([](Scene& s) {
               s.path->histories[1].times = {2, 1};
             }),
             ContainsSubstring("1 follows 2"));
  CHECK_THAT(message([](Scene& s) { s.bodies[0].loads.edges[0].history = "pres"; }),
             ContainsSubstring("'pres'") && ContainsSubstring("'press', 'drag'"));
  CHECK_THAT(problem_message([&] { static_cast<void>(solve(good)); }),
             ContainsSubstring("solve_steps()"));
  Scene bare = good;
  bare.path.reset();
  for (EdgeLoad& load : bare.bodies[0].loads.edges) load.history.clear();
  CHECK_THAT(problem_message([&] { static_cast<void>(solve_steps(bare)); }),
             ContainsSubstring("no load steps"));
}

TEST_CASE("a state of another scene, and a step of no size, are refused", "[steps]") {
  const Scene scene = slab(2, {1});
  const PathState state = steps_of(scene)[2].state;
  const auto message = [&](const Scene& other, const PathState& from) {
    return problem_message([&] { static_cast<void>(solve_steps(other, {}, from)); });
  };
  Scene softer = scene;
  softer.bodies[0].material.youngs_modulus *= 0.999;
  CHECK_THAT(message(softer, state),
             ContainsSubstring("another scene") && ContainsSubstring("do not solve"));
  CHECK_THAT(message(slider(proportional("pull"), {1}), state), ContainsSubstring("another scene"));
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  for (const double time : {state.time, 0.5 * state.time})
    CHECK_THAT(problem_message([&] { static_cast<void>(step(state, time, model, path, {})); }),
               ContainsSubstring("after time"));
  const std::string text = written(state);
  const auto read = [](const std::string& content) {
    return problem_message([&] { static_cast<void>(read_state(content, "s")); });
  };
  CHECK(read(text).empty());
  CHECK_THAT(read(text.substr(0, text.size() / 2)), ContainsSubstring("s:"));
  CHECK_THAT(read("time 1\n"), ContainsSubstring("signorini-state-1"));
  CHECK_THAT(read(text + "1\n"), ContainsSubstring("end of the file"));
  std::string wrong = text;
  wrong[wrong.find("\ns\n") + 1] = 'x';
  CHECK_THAT(read(wrong), ContainsSubstring("o, s, f or b"));
}

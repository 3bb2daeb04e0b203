// States of a path: turned back, saved, refused.
#include <algorithm>
#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "support/message.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

bool same(const Step& one, const Step& other) {
  const PathState& a = one.state;
  const PathState& b = other.state;
  return a.time == b.time && a.contact_status == b.contact_status && a.slip == b.slip &&
         a.increment == b.increment && a.dissipation == b.dissipation &&
         a.solution.displacement == b.solution.displacement &&
         a.solution.displacement_low == b.solution.displacement_low &&
         a.solution.force == b.solution.force &&
         one.solution.displacements == other.solution.displacements;
}

}  // namespace

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
  CHECK_THAT(problem_message([&] { static_cast<void>(solve(bare)); }),
             ContainsSubstring("'press'") && ContainsSubstring("no load steps"));
  CHECK_THAT(problem_message([&] { static_cast<void>(solve_steps(bare)); }),
             ContainsSubstring("no load steps"));
  Ledger ledger;
  Model model = build(good, ledger);
  model.path.histories[0].name = "pres";
  CHECK_THAT(problem_message([&] { set_time(1, model); }), ContainsSubstring("'press'"));
}

TEST_CASE("states of older versions are read, and gone on from", "[steps]") {
  const Scene scene = slab(2, {1});
  const std::vector<Step> all = steps_of(scene);
  const std::string text = written(all[1].state);
  // Forces had one part, and of bodies that stay no way was known. The oldest had no line at the end.
  const std::string kept = text.substr(text.find('\n'), text.find("force-low") - text.find('\n'));
  const std::string first = "signorini-state-1" + kept, second = "signorini-state-2" + kept + "end\n";
  CHECK_THAT(problem_message([&] { static_cast<void>(read_state(first + "end\n", "s")); }),
             ContainsSubstring("expected the end of the file, got 'end'"));
  for (const std::string& older : {first, second}) {
    std::vector<Step> rest;
    const PathEnd end =
        solve_steps(scene, [&](const Model&, const Step& step) { rest.push_back(step); },
                    read_state(older, "s"));
    REQUIRE(end.status == SolveStatus::Solved);
    REQUIRE(rest.size() + 2 == all.size());
    const Eigen::VectorXd& force = all.back().state.solution.force;
    CHECK((end.state.solution.force - force).norm() <= 1e-13 * force.norm());
  }
}

TEST_CASE("a state that lacks one of two parts is refused", "[steps]") {
  Scene scene = cantilever("q4_incompatible", 20, 3);
  scene.bodies[0].loads.edges[0].history = "press";
  scene.path = Path{equal_steps(20), {proportional("press")}};
  const PathState state = steps_of(scene)[17].state;
  REQUIRE(state.way.force_low.size() > 0);
  const auto refused = [&](const char* part, auto&& change) {
    PathState changed = state;
    change(changed);
    CHECK_THAT(problem_message([&] { static_cast<void>(solve_steps(scene, {}, changed)); }),
               ContainsSubstring("another scene") && ContainsSubstring(part));
  };
  refused("displacement", [](PathState& s) { s.solution.displacement_low.resize(0); });
  refused("way", [](PathState& s) { s.way.displacement_low.resize(0); });
  refused("way", [](PathState& s) { s.way.displacement.resize(0); });
  refused("way", [](PathState& s) { s.way.force.conservativeResize(3); });
  PathState lost = state;
  lost.solution.force_low(0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(problem_message([&] { static_cast<void>(solve_steps(scene, {}, lost)); }),
             ContainsSubstring("not finite"));
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
  PathState unbegun = state;
  unbegun.steps = 0;
  CHECK_THAT(message(scene, unbegun), ContainsSubstring("before the first step is empty"));
  PathState late;
  late.time = 0.5;
  CHECK_THAT(message(scene, late), ContainsSubstring("of time 0.5 and has 0 numbers"));
  PathState lost = state;
  lost.dissipation(0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(message(scene, lost), ContainsSubstring("not finite"));
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  CHECK_THAT(problem_message([&] { static_cast<void>(step(unbegun, 1, model, path, {})); }),
             ContainsSubstring("before the first step is empty"));
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
  // However little is missing of what it says.
  for (const std::size_t kept : {text.size() - 2, text.size() - 5})
    CHECK_THAT(
        read(text.substr(0, kept)),
        ContainsSubstring("expected a line 'end', without which a part of the file is missing"));
  for (const std::size_t kept : {text.size() - 6, text.size() - 9})
    CHECK_THAT(read(text.substr(0, kept)), ContainsSubstring("way-force-low"));
  const auto with = [&](const std::string& key, const std::string& value) {
    const std::size_t at = text.find(key) + key.size();
    return text.substr(0, at) + value + text.substr(text.find('\n', at));
  };
  CHECK_THAT(read(with("\nsteps ", "0")), ContainsSubstring("s:2:") && ContainsSubstring("steps"));
  for (const char* const time : {"0", "-5"})
    CHECK_THAT(read(with("\ntime ", time)),
               ContainsSubstring("s:3: time: expected a number > 0, got " + std::string(time)));
  for (const char* const time : {"nan", "inf"})
    CHECK_THAT(read(with("\ntime ", time)), ContainsSubstring("finite"));
  // Whatever a byte is changed to: refused, or a state that can be gone on from.
  Random random(15);
  int refused = 0;
  for (int sample = 0; sample < 400; ++sample) {
    std::string odd = text;
    const int at = random.whole(0, static_cast<int>(std::min<std::size_t>(odd.size(), 400)) - 1);
    odd[static_cast<std::size_t>(at)] = "0159-.e\n sfbo"[random.whole(0, 13)];
    CAPTURE(odd);
    refused += !problem_message([&] { check_state(read_state(odd, "s"), model); }).empty();
  }
  CHECK(refused > 100);
  std::string wrong = text;
  wrong[wrong.find("\ns\n") + 1] = 'x';
  CHECK_THAT(read(wrong), ContainsSubstring("o, s, f or b"));
}

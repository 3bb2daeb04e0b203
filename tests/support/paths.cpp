#include "support/paths.hpp"

#include <sstream>

#include "catch_compat.hpp"
#include "meshes/block.hpp"

using namespace signorini;

namespace signorini_test {

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
  scene.contacts[0].friction = Friction{slider_friction, 0};
  scene.path = Path{times, {pull}};
  return scene;
}

Scene slab(int steps_per_leg, const std::vector<double>& drag) {
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = block("slab", {0, 0}, {4, 1}, 16, 4);
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

std::vector<Step> steps_of(const Scene& scene, const PathState& from) {
  std::vector<Step> steps;
  const PathEnd end = solve_steps(
      scene, [&](const Model&, const Step& step) { steps.push_back(step); }, from);
  INFO(end.reason);
  REQUIRE(end.status == SolveStatus::Solved);
  REQUIRE(end.halvings == 0);
  return steps;
}

std::vector<TakenTwice> steps_taken_twice(const Scene& scene, double part) {
  Ledger ledger;
  Model model = build(scene, ledger);
  CondensedPath path = condense_path(model, ledger);
  std::vector<TakenTwice> all;
  PathState state;
  for (const double time : scene.path->times) {
    PathState blind = state;
    blind.way = {};
    const Step other = step(blind, time, model, path, {});
    const Step next = step(state, time, model, path, {});
    REQUIRE(next.solution.contact.report.status == SolveStatus::Solved);
    const Eigen::VectorXd& force = next.state.solution.force;
    REQUIRE(other.state.solution.force.size() == force.size());
    CHECK((other.state.solution.force - force).cwiseAbs().maxCoeff() <= part * force.cwiseAbs().maxCoeff());
    all.push_back({state, next, other});
    state = next.state;
  }
  return all;
}

std::string written(const PathState& state) {
  std::ostringstream out;
  write_state(state, out);
  return out.str();
}

}  // namespace signorini_test

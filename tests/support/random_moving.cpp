#include "support/random_moving.hpp"

#include <cmath>

#include "addons/steps/histories.hpp"
#include "meshes/split.hpp"
#include "signorini/fem/block.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Vector2d;

/// Units and place of a scene.
struct Units {
  double length;
  double stress;
  Vector2d shift;
  bool upright;

  [[nodiscard]] Vector2d turned(const Vector2d& v) const {
    return upright ? Vector2d(-v.y(), v.x()) : v;
  }
  [[nodiscard]] Mesh placed(const Mesh& mesh) const {
    return mapped(mesh,
                  [this](const Vector2d& x) -> Vector2d { return length * turned(x + shift); });
  }
};

Body drawn_body(Draws& draw, const Units& units, Mesh mesh, double stiffness, PlaneState state) {
  Body body;
  if (mesh.order() == MeshOrder::Linear && draw.chance(4)) {
    mesh = split(mesh);
    draw.say(" in triangles");
  } else if (mesh.order() == MeshOrder::Linear) {
    body.element = draw.pick({"q4", "q4_bbar", "q4_incompatible"});
  }
  body.mesh = units.placed(mesh);
  const double nu = body.element == "q4_bbar" ? 0.45 : draw.pick({0.0, 0.3});
  body.material = {units.stress * stiffness, nu, state, 1};
  draw.say(" '", body.mesh.name, "' E ", stiffness, " nu ", nu, " ", body.element);
  return body;
}

/// A load of the top of the tool, or displacements that are given there.
void press_and_drag(Draws& draw, const Units& units, double strain, double way, bool loaded,
                    Body& tool) {
  const Axis along = units.upright ? Axis::Y : Axis::X;
  const Axis across = units.upright ? Axis::X : Axis::Y;
  const double down = (units.upright ? 1 : -1) * strain * units.length;
  tool.supports = {prescribed("top", along, way * units.length)};
  tool.supports[0].history = "drag";
  draw.say("; strain ", strain, loaded ? " by load" : "", ", way ", way);
  if (loaded) {
    tool.loads.edges = {{"top", strain * tool.material.youngs_modulus, {}, "press"}};
  } else {
    tool.supports.push_back(prescribed("top", across, down));
    tool.supports[1].history = "press";
  }
}

Path drawn_path(Draws& draw) {
  const int steps = draw.whole(2, 11);
  const bool back = draw.chance(5);
  draw.say("; ", steps, " steps", back ? " to and fro" : "");
  std::vector<double> times = {1};
  for (const double time : equal_steps(steps)) times.push_back(1 + time);
  return {times,
          {{"press", {0, 1}, {0, 1}},
           back ? History{"drag", {1, 1.5, 2}, {0, 0.5, -0.5}} : History{"drag", {1, 2}, {0, 1}}}};
}

}  // namespace

Scene random_moving(Draws& draw) {
  const Units units{draw.decade(-3, 3), draw.decade(-3, 3),
                    Vector2d(draw.pick({0.0, 0.0, 10.0, 100.0}), draw.pick({0.0, -7.0})),
                    draw.chance(4)};
  const MeshOrder order = draw.chance(3) ? MeshOrder::Quadratic : MeshOrder::Linear;
  const PlaneState state = draw.chance(5) ? PlaneState::Stress : PlaneState::Strain;
  draw.say("length ", units.length, " stress ", units.stress, " shift ", units.shift.transpose(),
           units.upright ? " upright" : "", order == MeshOrder::Quadratic ? " quadratic" : "");
  const double wave = draw.pick({0.0, 0.0, 2e-4, 1e-3});
  const double round = draw.pick({0.0, 0.05, 0.3});
  const double start = draw.sixteenths(16, 32);
  const double gap = draw.pick({0.0, 0.0, 1e-4, -1e-4});
  const double width = draw.sixteenths(8, 20);
  Mesh base = block("base", {0, -1}, {6, 1}, draw.whole(10, 40), draw.whole(2, 4), order);
  base = mapped(base, [=](const Vector2d& x) -> Vector2d {
    return {x.x(), x.y() + wave * (x.y() + 1) * (std::cos(2 * (x.x() - start - width / 2)) - 1)};
  });
  Mesh tool = block("tool", {start, 0}, {width, 1}, draw.whole(2, 8), draw.whole(2, 5), order);
  tool = mapped(tool, [=](const Vector2d& x) -> Vector2d {
    const double s = x.x() - start - width / 2;
    return {x.x(), x.y() + gap + round * s * s * (1 - x.y())};
  });
  draw.say("; wave ", wave, " round ", round, " gap ", gap, ";");
  Scene scene;
  scene.bodies = {drawn_body(draw, units, base, draw.decade(-3, 3), state),
                  drawn_body(draw, units, tool, 1, state)};
  scene.bodies[0].supports = {fixed("bottom")};
  const double mu = draw.pick({0.0, 0.1, 0.3, 0.5});
  // Where the top of the tool is loaded it may tip, and much friction would turn it.
  const bool loaded = draw.chance(3) && mu <= 0.1 && round == 0;
  // So far that it stays pressed beside the waves.
  const double strain = draw.decade(-6, -3) * draw.whole(1, 3) + 2 * wave + std::abs(gap);
  press_and_drag(draw, units, strain, draw.sixteenths(1, 40), loaded, scene.bodies[1]);
  const Side of_base{"top", "base"};
  const Side of_tool{"bottom", "tool"};
  const bool base_source = draw.chance(4);
  scene.contacts = {{base_source ? of_base : of_tool, base_source ? of_tool : of_base}};
  const double cohesion = draw.chance(1) ? 1e-5 * units.stress : 0;
  if (mu > 0 || cohesion > 0) scene.contacts[0].friction = Friction{mu, cohesion};
  draw.say("; source ", base_source ? "base" : "tool", ", mu ", mu, ", c ", cohesion);
  scene.path = drawn_path(draw);
  scene.moves = true;
  return scene;
}

}  // namespace signorini_test

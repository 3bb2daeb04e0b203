#include "support/random_moving.hpp"

#include <algorithm>
#include <cmath>

#include "addons/steps/histories.hpp"
#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/strain_laws.hpp"

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

/// Laws of the two bodies; null: its strains are small.
struct Laws {
  const StrainLaw* base = nullptr;
  const StrainLaw* tool = nullptr;

  [[nodiscard]] bool any() const { return base != nullptr || tool != nullptr; }
};

Laws drawn_laws(Draws& draw) {
  Laws laws;
  if (draw.chance(8)) return laws;
  const int which = draw.whole(0, 3);
  const auto law = [&] { return find_strain_law(draw.pick({"neo_hooke", "st_venant_kirchhoff"})); };
  if (which != 1) laws.base = law();
  if (which != 2) laws.tool = law();
  return laws;
}

/// E of the base over that of the tool: one whose strains are small is stiff beside one whose strains are not.
double drawn_stiffness(Draws& draw, const Laws& laws) {
  if (!laws.any() || (laws.base != nullptr && laws.tool != nullptr)) return draw.decade(-3, 3);
  return laws.base != nullptr ? draw.decade(-3, -2) : draw.decade(2, 3);
}

Body drawn_body(Draws& draw, const Units& units, Mesh mesh, double stiffness, PlaneState state,
                const StrainLaw* law) {
  Body body;
  const bool linear = mesh.order() == MeshOrder::Linear;
  if ((linear || law != nullptr) && draw.chance(4)) {
    mesh = split(mesh);
    draw.say(" in triangles");
  } else if (linear) {
    body.element = law != nullptr ? draw.pick({"q4", "q4_bbar", "q4_bbar"})
                                  : draw.pick({"q4", "q4_bbar", "q4_incompatible"});
  }
  body.mesh = units.placed(mesh);
  const double nu = body.element == "q4_bbar" ? draw.pick({0.45, 0.49}) : draw.pick({0.0, 0.3});
  body.material = {units.stress * stiffness, nu, state, 1};
  body.material.law = law;
  draw.say(" '", body.mesh.name, "' E ", stiffness, " nu ", nu, " ", body.element, " ",
           law != nullptr ? law->name : "small");
  return body;
}

/// By how much of its height the tool is pressed, without waves and gaps.
double drawn_strain(Draws& draw, const Laws& laws) {
  const double small = draw.decade(-6, -3) * draw.whole(1, 3);
  if (!laws.any()) return small;
  const auto gives_way = [](const StrainLaw* law) {
    return law != nullptr && law == find_strain_law("st_venant_kirchhoff");
  };
  if (gives_way(laws.base) || gives_way(laws.tool)) return draw.pick({1e-3, 0.01, 0.03, 0.1});
  return draw.pick({1e-3, 0.01, 0.03, 0.1, 0.2});
}

/// A load of the top of the tool, or displacements that are given there.
/// \param stiffness  of the softer body over that of the tool
void press_and_drag(Draws& draw, const Units& units, double strain, double way, bool loaded,
                    double stiffness, Body& tool) {
  const Axis along = units.upright ? Axis::Y : Axis::X;
  const Axis across = units.upright ? Axis::X : Axis::Y;
  const double down = (units.upright ? 1 : -1) * strain * units.length;
  tool.supports = {prescribed("top", along, way * units.length)};
  tool.supports[0].history = "drag";
  draw.say("; strain ", strain, loaded ? " by load" : "", ", way ", way);
  if (loaded) {
    tool.loads.edges = {{"top", strain * stiffness * tool.material.youngs_modulus, {}, "press"}};
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
  // A ring on its way along the inside of another one.
  const bool round = units.upright && units.shift.y() < 0 && draw.chance(8);
  const PlaneState state = round            ? PlaneState::Axial
                           : draw.chance(5) ? PlaneState::Stress
                                            : PlaneState::Strain;
  const Laws laws = drawn_laws(draw);
  draw.say("length ", units.length, " stress ", units.stress, " shift ", units.shift.transpose(),
           units.upright ? " upright " : " ", to_string(state),
           order == MeshOrder::Quadratic ? " quadratic" : "");
  const double wave = draw.pick({0.0, 0.0, 2e-4, 1e-3});
  const double bulge = draw.pick({0.0, 0.05, 0.3});
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
    return {x.x(), x.y() + gap + bulge * s * s * (1 - x.y())};
  });
  draw.say("; wave ", wave, " bulge ", bulge, " gap ", gap, ";");
  Scene scene;
  const double stiffness = drawn_stiffness(draw, laws);
  scene.bodies = {drawn_body(draw, units, base, stiffness, state, laws.base)};
  scene.bodies.push_back(drawn_body(draw, units, tool, 1, state, laws.tool));
  scene.bodies[0].supports = {fixed("bottom")};
  const double mu = draw.pick({0.0, 0.1, 0.3, 0.5});
  // Where the top of the tool is loaded it may tip, and much friction would turn it.
  const bool loaded = draw.chance(3) && mu <= 0.1 && bulge == 0;
  // So far that it stays pressed beside the waves.
  const double strain = drawn_strain(draw, laws) + 2 * wave + std::abs(gap);
  press_and_drag(draw, units, strain, draw.sixteenths(1, 40), loaded,
                 laws.any() ? std::min(1.0, stiffness) : 1, scene.bodies[1]);
  const Side of_base{"top", "base"};
  const Side of_tool{"bottom", "tool"};
  const bool base_source = draw.chance(4);
  scene.contacts = {{base_source ? of_base : of_tool, base_source ? of_tool : of_base}};
  const double cohesion = draw.chance(1) ? 1e-5 * units.stress : 0;
  if (mu > 0 || cohesion > 0) scene.contacts[0].friction = Friction{mu, cohesion};
  draw.say("; source ", base_source ? "base" : "tool", ", mu ", mu, ", c ", cohesion);
  scene.path = drawn_path(draw);
  scene.moves = !laws.any() || draw.chance(8);  // laws move bodies, told so or not
  return scene;
}

}  // namespace signorini_test

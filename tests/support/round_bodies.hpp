// Round bodies under loads that change with the polygon that a mesh makes of them: weight, whirling, pressure on curved
// sides. What they are asked for is known in closed form, or from cells of eight nodes.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "addons/estimate/goal.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"
#include "meshes/disc.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/scene.hpp"
#include "support/meshes.hpp"
#include "support/spheres.hpp"

namespace signorini_test {

/// A round body, what it is asked for, and what the answer is.
struct RoundBody {
  std::string name;
  signorini::Goal goal;
  /// Of so many cells, times what the first mesh has, and with any element.
  std::function<signorini::Scene(const std::string& element, Eigen::Index times)> scene;
  std::optional<double> truth = {};  ///< nothing: that of a fine mesh of cells of eight nodes
};

namespace round_bodies {

using signorini::pi;
constexpr double modulus = 1000, ratio = 0.3;

inline signorini::VectorField weight(double specific) {
  return [=](const Eigen::Vector2d&) -> Eigen::Vector2d { return {0, -specific}; };
}

/// A ring of radii 1 and 2 in a rigid hole, in the plane or about the axis.
inline signorini::Scene ring_in_hole(const std::string& element, Eigen::Index times,
                                     signorini::PlaneState state, double hole_radius) {
  signorini::AnnulusSpec spec;
  spec.cells_angle = 6 * times;
  spec.cells_radius = 3 * times;
  spec.sector = signorini::Sector::Quarter;
  const signorini::Element& cell = signorini::find_element(element);
  spec.order = order_of(cell);
  signorini::Scene scene;
  signorini::Body& ring = scene.bodies.front();
  ring.mesh = fitting(signorini::make_annulus(spec), cell);
  ring.element = element;
  ring.material = {modulus, ratio, state, 1};
  ring.supports = {signorini::symmetric("symmetry"), signorini::symmetric("symmetry_y")};
  if (state == signorini::PlaneState::Axial) ring.supports = {signorini::symmetric("symmetry")};
  scene.contacts = {{{"outer"}, signorini::hole({0, 0}, hole_radius)}};
  return scene;
}

/// The right half of a disc, or a ball, of radius 1.
inline signorini::Scene round_weight(const std::string& element, Eigen::Index times,
                                     signorini::PlaneState state, double specific) {
  signorini::DiscSpec spec;
  spec.core_cells = 2 * times;
  spec.layers = 2 * times;
  spec.part = signorini::DiscPart::Right;
  const signorini::Element& cell = signorini::find_element(element);
  spec.order = order_of(cell);
  signorini::Scene scene;
  signorini::Body& disc = scene.bodies.front();
  disc.mesh = fitting(signorini::make_disc(spec), cell);
  disc.element = element;
  disc.material = {modulus, ratio, state, 1};
  if (state != signorini::PlaneState::Axial) disc.supports = {signorini::symmetric("axis")};
  disc.loads.body_force = weight(specific);
  scene.contacts = {{{"rim"}, signorini::half_plane({0, -1}, {0, 1})}};
  return scene;
}

inline std::vector<RoundBody> rings() {
  using namespace signorini;
  const double E = plane_strain_modulus(modulus, ratio), nu = plane_strain_ratio(ratio);
  const Ring ring{1, 2, E, nu};
  const double gap = 0.02, inside = 60;
  // The pressure of the hole leaves u(2) = gap.
  const double free = ring_displacement(ring, {inside, 0}, 2);
  const double held = (free - gap) / -ring_displacement(ring, {0, 1}, 2);
  const auto pressed = [=](const std::string& element, Eigen::Index times) {
    Scene scene = ring_in_hole(element, times, PlaneState::Strain, 2 + gap);
    scene.bodies[0].loads.edges = {{"inner", inside, {}}};
    return scene;
  };
  const double inner = ring_displacement(ring, {inside, held}, 1);
  // The same with a traction instead.
  const auto pulled = [=](const std::string& element, Eigen::Index times) {
    Scene scene = pressed(element, times);
    scene.bodies[0].loads.edges = {
        {"inner", 0, [=](const Eigen::Vector2d& x) -> Eigen::Vector2d { return inside * x; }}};
    return scene;
  };
  // Whirling: a ring that turns by itself, pressed back by the hole.
  const double whirl = 40;
  const auto whirling = [=](const std::string& element, Eigen::Index times) {
    Scene scene = ring_in_hole(element, times, PlaneState::Strain, 2 + gap);
    scene.bodies[0].loads.body_force = [=](const Eigen::Vector2d& x) -> Eigen::Vector2d {
      return whirl * x;
    };
    return scene;
  };
  const auto whirled = [=](double r) {
    const double a2 = 1, b2 = 4, r2 = r * r;
    return (3 + nu) / 8 * whirl * (1 - nu) * r / E *
           (a2 + b2 + (1 + nu) / (1 - nu) * a2 * b2 / r2 - (1 + nu) / (3 + nu) * r2);
  };
  const double bears = (whirled(2) - gap) / -ring_displacement(ring, {0, 1}, 2);
  const double turned = whirled(1) + ring_displacement(ring, {0, bears}, 1);
  const Goal moved{"inner", Displacement{"", Axis::X, "inner", {}}};
  const Goal force{"normal_force", NormalForce{}};
  return {{"ring under pressure", force, pressed, held * 2 * pi / 2},
          {"ring under pressure", moved, pressed, inner * 2 / pi},
          {"ring under traction", moved, pulled, inner * 2 / pi},
          {"whirling ring", force, whirling, bears * 2 * pi / 2},
          {"whirling ring", moved, whirling, turned * 2 / pi}};
}

inline std::vector<RoundBody> shells() {
  using namespace signorini;
  const HollowSphere shell{1, 2, modulus, ratio};
  const double gap = 0.02, inside = 80;
  const double free = sphere_displacement(shell, {inside, 0}, 2);
  const double held = (free - gap) / -sphere_displacement(shell, {0, 1}, 2);
  const auto pressed = [=](const std::string& element, Eigen::Index times) {
    Scene scene = ring_in_hole(element, times, PlaneState::Axial, 2 + gap);
    scene.bodies[0].loads.edges = {{"inner", inside, {}}};
    return scene;
  };
  const double inner = sphere_displacement(shell, {inside, held}, 1);
  return {{"shell under pressure", {"normal_force", NormalForce{}}, pressed, held * 8 * pi},
          {"shell under pressure",
           {"inner", Displacement{"", Axis::Y, "inner", {}}},
           pressed,
           inner / 2}};
}

inline std::vector<RoundBody> weights() {
  using namespace signorini;
  const Goal force{"normal_force", NormalForce{}};
  const auto disc = [](const std::string& element, Eigen::Index times) {
    return round_weight(element, times, PlaneState::Strain, 5);
  };
  const auto ball = [](const std::string& element, Eigen::Index times) {
    return round_weight(element, times, PlaneState::Axial, 20);
  };
  const auto sunk = [](const std::string& element, Eigen::Index times) {
    Scene scene = round_weight(element, times, PlaneState::Strain, 20);
    scene.contacts[0].target = hole({0, 0.02}, 1.02);
    return scene;
  };
  const auto in_cup = [](const std::string& element, Eigen::Index times) {
    Scene scene = round_weight(element, times, PlaneState::Axial, 20);
    scene.contacts[0].target = hole({0, 0.05}, 1.05);
    return scene;
  };
  return {{"disc on a plane", force, disc, 5 * pi / 2},
          {"ball on a plane", force, ball, 20 * 4 * pi / 3},
          {"disc in a hole", force, sunk, {}},
          {"ball in a cup", {"sinking", Displacement{"", Axis::Y, "", {{0, 1}}}}, in_cup, {}}};
}

/// Hertz's ball: contact reaches a hundredth of its radius.
inline std::vector<RoundBody> balls() {
  using namespace signorini;
  const double radius = 50, width = 0.5;
  PointContact contact{radius, modulus / (1 - ratio * ratio), 0};
  contact.force = 4 * contact.modulus * width * width * width / (3 * radius);
  const auto scene = [=](const std::string& element, Eigen::Index times) {
    PressedDiscSpec spec;
    spec.radius = radius;
    spec.core = {2, 2};
    spec.core_columns = spec.core_rows = 6 * times;
    spec.layers = 6 * times;
    const Element& cell = find_element(element);
    spec.order = order_of(cell);
    Scene made;
    Body& ball = made.bodies.front();
    ball.mesh = fitting(make_pressed_disc(spec), cell);
    ball.element = element;
    ball.material = {modulus, ratio, PlaneState::Axial, 1};
    ball.loads.edges = {{"middle", contact.force / (pi * radius * radius), {}}};
    made.contacts = {{{"rim"}, half_plane({0, 0}, {0, 1})}};
    return made;
  };
  return {{"Hertz's ball", {"peak", PeakPressure{}}, scene, hertz_peak_pressure(contact)},
          {"Hertz's ball", {"width", HalfWidth{}}, scene, hertz_radius(contact)}};
}

}  // namespace round_bodies

/// What a body is asked for, in closed form or of so many times the cells, of eight nodes.
inline double truth_of(const RoundBody& body, Eigen::Index times) {
  if (body.truth) return *body.truth;
  const signorini::SolvedScene run = signorini::solved(body.scene("q8", times), body.name);
  return signorini::value(run.model, run.solution, body.goal);
}

/// All of them.
inline std::vector<RoundBody> all_round_bodies() {
  std::vector<RoundBody> all;
  for (const auto& some : {round_bodies::rings(), round_bodies::shells(), round_bodies::weights(),
                           round_bodies::balls()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace signorini_test

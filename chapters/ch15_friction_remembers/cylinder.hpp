/// \file
/// A half cylinder on a plate of its own material: pressed down and pushed sideways.
#pragma once
#include <cmath>
#include <vector>

#include "meshes/hertz_meshes.hpp"
#include "meshes/reshape.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "slider.hpp"

namespace ch15 {

using Eigen::Index;

constexpr double R = 50;                                  // radius [mm]
constexpr double depth = 0.03;                            // its middle is pressed down by [mm]
constexpr double mu = 0.3;                                // [-]
const Material resin{4000, 0.35, PlaneState::Strain, 1};  // E [MPa], nu, ., 1 mm
/// Pressed until time 1.
inline const History pressing{"press", {0, 1}, {0, 1}};

/// Both bodies, pressed by the history "press". \param times  of the steps \param press  whose end is 1
/// \param push  what comes sideways, see by_force() and by_hand() \return the scene
inline Scene cylinder(const std::vector<double>& times, const History& press, const History& push) {
  HertzMeshSpec spec;
  spec.core = 0.95;
  spec.disc_cells = spec.plate_cells = spec.disc_layers = spec.plate_layers = 16;
  spec.disc_rows = spec.plate_rows = 12;
  const HertzMeshes halves = make_hertz_meshes(spec);
  const auto whole = [](const Mesh& half) {
    return joined(half, "axis", mirrored(half, MirrorLine::Upright), "axis");
  };
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = whole(halves.disc);
  scene.bodies[1].mesh = whole(halves.plate);
  for (Body& body : scene.bodies) body.material = resin;
  scene.bodies[0].supports = {prescribed("middle", Axis::Y, -depth)};
  scene.bodies[0].supports[0].history = press.name;
  scene.bodies[1].supports = {fixed("base")};
  scene.contacts = {
      {{"rim", scene.bodies[0].mesh.name}, Side{"surface", scene.bodies[1].mesh.name}}};
  scene.contacts[0].friction = Friction{mu, 0};
  scene.path = Path{times, {press, push}};
  return scene;
}

/// \param scene  of the cylinder \return with the push as a force on its middle [N/mm]
inline Scene by_force(Scene scene) {
  scene.bodies[0].loads.edges = {
      {"middle", 0, [](const Eigen::Vector2d& /*x*/) { return Eigen::Vector2d(0.5 / R, 0); }}};
  scene.bodies[0].loads.edges[0].history = scene.path->histories[1].name;
  return scene;
}

/// \param scene  of the cylinder \return with the push as the way of its middle [mm]
inline Scene by_hand(Scene scene) {
  scene.bodies[0].supports.push_back(prescribed("middle", Axis::X, 1));
  scene.bodies[0].supports[1].history = scene.path->histories[1].name;
  return scene;
}

/// \param start  of the first step \param end  of the last \param n  steps per unit of time \return their ends
inline std::vector<double> steps_between(double start, double end, int n) {
  std::vector<double> times;
  for (int i = 1; i <= std::lround(n * (end - start)); ++i) times.push_back(start + double(i) / n);
  return times;
}

/// \param n  steps per unit of time \return pressed in one step, then pushed until time 6
inline std::vector<double> push_times(int n) {
  std::vector<double> times = {1};
  for (const double time : steps_between(1, 6, n)) times.push_back(time);
  return times;
}

/// \param model  of the cylinder \param step  of it \return shear on the plate at all pairs [MPa]
inline Eigen::VectorXd shear_of(const Model& model, const Step& step) {
  return -step.solution.contact.friction.cwiseQuotient(model.pairs.weight);
}

}  // namespace ch15

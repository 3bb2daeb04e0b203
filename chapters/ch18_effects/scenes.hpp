/// \file
/// A cylinder on rock or on a plate, and what may be switched on besides.
#pragma once
#include <vector>

#include "addons/effects/register.hpp"        // heat, and what the plan says is off
#include "addons/frontal/frontal_factor.hpp"  // the factor whose operations are counted
#include "closed_form/hertz_fit.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/hertz_meshes.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "signorini/scene/readings.hpp"

namespace signorini {

// [data]
constexpr double R = 50;                                        // radius of the cylinder [mm]
constexpr double P = 41.76;                                     // load on all of it [N/mm]
const Material resin{4000, 0.35, PlaneState::Strain, 1, 6e-5};  // E [MPa], nu, ., 1 mm, alpha [1/K]
constexpr double specific_weight = 1.2e-5;                      // of resin [N/mm^3]
constexpr double friction = 0.3;                                // mu [-]
constexpr double warmer = 100;                                  // by so much [K]
constexpr double thin = 3;                                      // thickness of a thin plate [mm]
// [data]
/// Free expansion in plane strain, (1 + nu) alpha Delta T [-].
const double thermal = (1 + resin.poisson_ratio) * resin.expansion * warmer;
const double stiff = plane_strain_modulus(resin.youngs_modulus, resin.poisson_ratio);  // E' [MPa]

/// Right halves of both bodies. \param thickness  of the plate [mm] \return fine where they touch
inline HertzMeshes meshes(double thickness) {
  HertzMeshSpec spec;
  spec.radius = R;
  spec.plate.y() = thickness;
  spec.disc_cells = spec.plate_cells = 40;
  spec.disc_rows = spec.plate_rows = 20;
  spec.disc_layers = spec.plate_layers = 20;
  return make_hertz_meshes(spec);
}

// [rungs]
/// 1. The cylinder on rock, its middle pushed down. \param depth  by so much [mm]
inline Scene on_rock(double depth) {
  Scene scene;
  Body& disc = scene.bodies[0];
  disc.mesh = meshes(95).disc;
  disc.material = resin;
  disc.supports = {symmetric("axis"), prescribed("middle", Axis::Y, -depth)};
  scene.contacts = {{{"rim", "disc"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// 2. A second body: a plate in the place of the rock. \param scene  with the cylinder alone
inline Scene with_plate(Scene scene, double thickness = 95) {
  Body& plate = scene.bodies.emplace_back();
  plate.mesh = meshes(thickness).plate;
  plate.material = resin;
  plate.supports = {symmetric("axis"), fixed("base")};
  scene.contacts[0].target = Side{"surface", "plate"};
  return scene;
}
// [rungs]

// [changes]
/// 3. Pressed by a load and held by contact alone. \param scene  with a pushed cylinder
inline Scene floating(Scene scene) {
  scene.bodies[0].supports = {symmetric("axis")};
  scene.bodies[0].loads.edges = {{"middle", P / (2 * R), {}}};
  return scene;
}

/// 4. Friction. \param scene  any
inline Scene with_friction(Scene scene) {
  scene.contacts[0].friction = Friction{friction, 0};
  return scene;
}

/// 5. A warm cylinder. \param scene  any
inline Scene heated(Scene scene) {
  scene.bodies[0].temperature = Temperature{warmer, {0, 0}};
  return scene;
}
// [changes]

/// Its own weight. \param scene  any
inline Scene with_weight(Scene scene) {
  scene.bodies[0].loads.body_force = [](const Eigen::Vector2d& /*x*/) {
    return Eigen::Vector2d(0, -specific_weight);
  };
  return scene;
}

/// Largest pressure of the ellipse that fits the nodes best. \param run  solved \return [MPa]
inline double peak_pressure(const SolvedScene& run) {
  const Pairs& pairs = run.model.pairs;
  std::vector<double> x, pressure;
  for (Eigen::Index k = 0; k < pairs.weight.size(); ++k) {
    x.push_back(pairs.position(k, 0));
    pressure.push_back(run.solution.pressure(k));
  }
  return fit_hertz(x, pressure).peak_pressure;
}

}  // namespace signorini

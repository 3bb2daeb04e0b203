// A hub on a hollow shaft as a scene, with a choice of effects.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "meshes/ring.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini_test {

/// Cells of each of the two quarters.
struct FitCells {
  Eigen::Index angle = 6;
  Eigen::Index radius = 6;
  signorini::MeshOrder order = signorini::MeshOrder::Quadratic;
};

/// Quarters of shaft (body 0) and hub (body 1) with the interference alone.
/// \tparam Fit  with bore, radius, outside, modulus, ratio, interference
template <typename Fit>
signorini::Scene bare_fit(const Fit& fit, const FitCells& cells = {}) {
  using namespace signorini;
  Scene scene;
  scene.bodies.resize(2);
  const double radii[] = {fit.bore, fit.radius, fit.outside};
  for (std::size_t ring = 0; ring < 2; ++ring) {
    AnnulusSpec spec;
    spec.name = ring == 0 ? "shaft" : "hub";
    spec.inner_radius = radii[ring];
    spec.outer_radius = radii[ring + 1];
    spec.cells_angle = cells.angle;
    spec.cells_radius = cells.radius;
    spec.sector = Sector::Quarter;
    spec.order = cells.order;
    Body& body = scene.bodies[ring];
    body.mesh = make_annulus(spec);
    body.material = {fit.modulus, fit.ratio, PlaneState::Stress, 1};
    body.supports = {symmetric("symmetry"), symmetric("symmetry_y")};
  }
  scene.contacts = {{{"outer", "shaft"}, Side{"inner", "hub"}}};
  scene.contacts[0].interference = fit.interference;
  return scene;
}

/// The same with some of the effects of a fit. \param on  their names
template <typename Fit>
signorini::Scene fit_with(const Fit& fit, const std::vector<std::string>& on) {
  using namespace signorini;
  const auto has = [&on](const char* name) {
    return std::find(on.begin(), on.end(), name) != on.end();
  };
  Scene scene = bare_fit(fit);
  if (has("body force"))
    for (Body& body : scene.bodies)
      body.loads.body_force = [k = fit.density * fit.speed * fit.speed](
                                  const Eigen::Vector2d& x) -> Eigen::Vector2d { return k * x; };
  if (has("edge loads")) scene.bodies[1].loads.edges = {{"outer", fit.pressure, {}}};
  if (has("temperature")) {
    scene.bodies[0].material.expansion = fit.shaft_expansion;
    scene.bodies[0].temperature = Temperature{fit.shaft_warmer};
    scene.bodies[1].material.expansion = fit.hub_expansion;
    scene.bodies[1].temperature = Temperature{fit.hub_warmer};
  }
  if (has("friction")) scene.contacts[0].friction = Friction{fit.friction, 0};
  return scene;
}

/// Mean pressure between shaft and hub.
inline double mean_pressure(const signorini::SolvedScene& run) {
  return run.solution.contact.force.sum() / run.model.pairs.weight.sum();
}

}  // namespace signorini_test

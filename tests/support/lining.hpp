// A ring in a ring (Lin et al., section 3.4) as a scene, in cm and MPa, with its closed form.
#pragma once
#include <string>

#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"
#include "meshes/ring.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// Quarters of two rings and their meshes. The defaults have 120 nodes and 90 cells.
struct Lining {
  double radii[4] = {60, 68, 68.15, 76.15};  ///< [cm]
  double inside = 180;                       ///< pressure on the inner rim [MPa]
  double outside = 0;                        ///< pressure on the outer rim [MPa]
  Eigen::Index cells_angle = 9;              ///< of each ring
  Eigen::Index cells_radius = 5;             ///< of each ring
  std::string element = "q4_incompatible";
  std::string gap_operator = "mortar";
  double youngs_modulus = 210e3;  ///< [MPa]
  double poisson_ratio = 0.3;
};

/// The inner ring is body 0 and the source, the outer one body 1.
inline signorini::Scene scene_of(const Lining& lining) {
  using namespace signorini;
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t ring = 0; ring < 2; ++ring) {
    AnnulusSpec spec;
    spec.name = ring == 0 ? "lining" : "rock";
    spec.inner_radius = lining.radii[2 * ring];
    spec.outer_radius = lining.radii[2 * ring + 1];
    spec.cells_angle = lining.cells_angle;
    spec.cells_radius = lining.cells_radius;
    spec.sector = Sector::Quarter;
    spec.order = lining.element == "q8" ? MeshOrder::Quadratic : MeshOrder::Linear;
    Body& body = scene.bodies[ring];
    body.mesh = make_annulus(spec);
    body.element = lining.element;
    body.material = {lining.youngs_modulus, lining.poisson_ratio, PlaneState::Strain, 1};
    body.supports = {symmetric("symmetry"), symmetric("symmetry_y")};
  }
  if (lining.inside != 0) scene.bodies[0].loads.edges = {{"inner", lining.inside, {}}};
  if (lining.outside != 0) scene.bodies[1].loads.edges = {{"outer", lining.outside, {}}};
  scene.contacts = {{{"outer", "lining"}, Side{"inner", "rock"}}};
  scene.contacts[0].gap_operator = lining.gap_operator;
  return scene;
}

/// The same rings in closed form. Contact of nodes transfers equal forces.
inline signorini::NestedRings closed_form(const Lining& lining) {
  const double E = signorini::plane_strain_modulus(lining.youngs_modulus, lining.poisson_ratio);
  const double nu = signorini::plane_strain_ratio(lining.poisson_ratio);
  return {{lining.radii[0], lining.radii[1], E, nu},
          {lining.radii[2], lining.radii[3], E, nu},
          lining.inside,
          lining.outside,
          signorini::Meeting::EqualForce};
}

}  // namespace signorini_test

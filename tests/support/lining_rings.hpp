// The lining of chapter 14 in its rock: two rings, in closed form.
#pragma once

#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"
#include "meshes/ring.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// A quarter of both, in cm and kN/cm^2; the sides of both meet end to end.
inline signorini::Scene lining_rings(Eigen::Index cells_angle, Eigen::Index cells_radius) {
  signorini::Scene scene;
  scene.bodies.resize(2);
  for (std::size_t b = 0; b < 2; ++b) {
    signorini::AnnulusSpec spec;
    spec.name = b == 0 ? "lining" : "rock";
    spec.inner_radius = b == 0 ? 60 : 68.15;
    spec.outer_radius = b == 0 ? 68 : 76.15;
    spec.cells_angle = cells_angle;
    spec.cells_radius = cells_radius;
    spec.sector = signorini::Sector::Quarter;
    scene.bodies[b].mesh = signorini::make_annulus(spec);
    scene.bodies[b].material = {210e3, 0.3, signorini::PlaneState::Strain, 1};
    scene.bodies[b].supports = {signorini::symmetric("symmetry"),
                                signorini::symmetric("symmetry_y")};
  }
  scene.bodies[0].loads.edges = {{"inner", 180, {}}};
  scene.contacts = {{{"outer", "lining"}, signorini::Side{"inner", "rock"}}};
  return scene;
}

/// Sum of the contact forces of the quarter.
inline double lining_force() {
  const double modulus = signorini::plane_strain_modulus(210e3, 0.3);
  const double ratio = signorini::plane_strain_ratio(0.3);
  const signorini::NestedRings rings{{60, 68, modulus, ratio}, {68.15, 76.15, modulus, ratio}, 180};
  return signorini::nested_pressure(rings).inner.outside * 68 * signorini::pi / 2;
}

}  // namespace signorini_test

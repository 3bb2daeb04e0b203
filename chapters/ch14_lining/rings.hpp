/// \file
/// Two rings as a scene and in closed form.
#pragma once
#include <array>
#include <cmath>
#include <string>

#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"
#include "meshes/ring.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "signorini/scene/readings.hpp"

namespace ch14 {

using Eigen::Index;

/// A lining in a rock: radii, load, mesh. The defaults are the paper's numbers and our radii, in cm and MPa.
// [data]
struct Rings {
  std::array<double, 4> radii = {60, 68, 68.15, 76.15};  // a, b, c, d: ours; c - b = 0.15: paper
  double pressure = 180;                                 // on the inner rim; paper
  double youngs_modulus = 210e3;                         // paper
  double poisson_ratio = 0.3;                            // paper
  Index cells_angle = 9;                                 // of each ring: 120 nodes, 90 cells
  Index cells_radius = 5;
  double turn = 0;  // of the rock's mesh, in cells
  std::string element = "q4_incompatible";
  std::string gap_operator = "mortar";
};
// [data]

/// The paper's example in our radii.
const Rings paper;

const double quarter_turn = std::acos(0.0);

/// One of the two rings. Turned meshes keep a ray on each line of symmetry.
inline signorini::Mesh ring_mesh(const Rings& rings, std::size_t body) {
  signorini::AnnulusSpec ring;
  ring.name = body == 0 ? "lining" : "rock";
  ring.inner_radius = rings.radii[2 * body];
  ring.outer_radius = rings.radii[2 * body + 1];
  ring.cells_angle = rings.cells_angle;
  ring.cells_radius = rings.cells_radius;
  ring.sector = signorini::Sector::Quarter;
  if (rings.element == "q8") ring.order = signorini::MeshOrder::Quadratic;
  if (body == 1 && rings.turn != 0) {
    const Index n = ring.cells_angle++;
    const double cells = static_cast<double>(n);
    ring.rays = Eigen::VectorXd::LinSpaced(n + 2, rings.turn - 1, cells + rings.turn);
    ring.rays = (ring.rays / cells * quarter_turn).cwiseMax(0).cwiseMin(quarter_turn).eval();
  }
  return make_annulus(ring);
}

/// The same rings in closed form.
inline signorini::NestedRings closed_form(
    const Rings& rings, signorini::Meeting meeting = signorini::Meeting::EqualForce) {
  const double E = signorini::plane_strain_modulus(rings.youngs_modulus, rings.poisson_ratio);
  const double nu = signorini::plane_strain_ratio(rings.poisson_ratio);
  const auto& [a, b, c, d] = rings.radii;
  return {{a, b, E, nu}, {c, d, E, nu}, rings.pressure, 0, meeting};
}

/// Displacement of the inner rim in closed form, outwards [length].
inline double inner_rim(const signorini::NestedRings& rings) {
  return ring_displacement(rings.inner, nested_pressure(rings).inner, rings.inner.inner_radius);
}

/// The scene: two quarters, held by symmetry, that may touch.
// [scene]
inline signorini::Scene scene_of(const Rings& rings) {
  signorini::Scene scene;
  scene.bodies.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    signorini::Body& body = scene.bodies[k];
    body.mesh = ring_mesh(rings, k);
    body.element = rings.element;
    body.material = {rings.youngs_modulus, rings.poisson_ratio, signorini::PlaneState::Strain, 1};
    body.supports = {signorini::symmetric("symmetry"), signorini::symmetric("symmetry_y")};
  }
  scene.bodies[0].loads.edges = {{"inner", rings.pressure, {}}};
  scene.contacts = {{{"outer", "lining"}, signorini::Side{"inner", "rock"}}};
  scene.contacts[0].gap_operator = rings.gap_operator;
  return scene;
}
// [scene]

/// The scene, solved and certified.
inline signorini::SolvedScene run_of(const Rings& rings) {
  return signorini::solved(scene_of(rings), "the lining");
}

}  // namespace ch14

/// \file
/// The example of section 3.1 as a scene, with everything that this chapter varies.
#pragma once
#include <cmath>
#include <string>
#include <utility>

#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/hertz_meshes.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "signorini/scene/scene.hpp"

namespace signorini {

/// What may differ from the example.
struct HertzCase {
  HertzMeshSpec mesh = {};     // R = 50 mm (paper); plate of 95 x 95 mm (ours)
  double disc_modulus = 4000;  // E of the disc, paper [MPa]
  double plate_modulus = 4000;
  double ratio = 0.35;  // nu of both, paper
  double load = 41.76;  // P, paper [N/mm]
  std::string element = "q4_incompatible";
  std::string gap_operator = "mortar";
  int points = 0;  // Gauss points of an operator that wants them
  Solver solver = primal_dual_active_set();
  bool plate_is_source = false;

  // Hertz's two bodies.
  [[nodiscard]] LineContact theory() const {
    return {mesh.radius,
            contact_modulus(plane_strain_modulus(disc_modulus, ratio),
                            plane_strain_modulus(plate_modulus, ratio)),
            load};
  }
};

// [scene]
inline Scene hertz_scene(const HertzCase& now) {
  HertzMeshes meshes = make_hertz_meshes(now.mesh);
  Scene scene;
  scene.bodies.resize(2);
  Body& disc = scene.bodies[0];
  disc.mesh = meshes.disc;
  disc.element = now.element;
  disc.material = {now.disc_modulus, now.ratio, PlaneState::Strain, 1};
  disc.supports = {symmetric("axis")};  // nothing holds it in y
  disc.loads.edges = {{"middle", now.load / (2 * now.mesh.radius), {}}};
  Body& plate = scene.bodies[1];
  plate.mesh = meshes.plate;
  plate.element = now.element;
  plate.material = {now.plate_modulus, now.ratio, PlaneState::Strain, 1};
  plate.supports = {symmetric("axis"), fixed("base")};
  Side source{"rim", disc.mesh.name}, target{"surface", plate.mesh.name};
  if (now.plate_is_source) std::swap(source, target);
  ContactSpec contact{source, target, now.gap_operator};
  contact.points = now.points;
  scene.contacts = {contact};
  scene.solver = now.solver;
  return scene;
}
// [scene]

/// The example on a finer mesh. \param cells  of both cores along the contact \param rows  of both
/// cores in depth \param layers  around them \return the case
inline HertzCase finer(Eigen::Index cells, Eigen::Index rows, Eigen::Index layers) {
  HertzCase now;
  now.mesh.disc_cells = now.mesh.plate_cells = cells;
  now.mesh.disc_rows = now.mesh.plate_rows = rows;
  now.mesh.disc_layers = now.mesh.plate_layers = layers;
  return now;
}

/// \return the example with another number of cells in the core of the plate
inline HertzCase not_matching() {
  HertzCase now;
  now.mesh.plate_cells = 13;
  return now;
}

}  // namespace signorini

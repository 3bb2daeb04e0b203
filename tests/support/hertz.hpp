// The cylinder on a plate of Lin et al., section 3.1, as a scene: half of it, the disc held by contact alone.
#pragma once
#include <utility>

#include "signorini/mesh/hertz_meshes.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// Load per thickness on the whole cylinder [N/mm].
inline constexpr double hertz_load = 41.76;

/// \param spec     meshes of both
/// \param element  of both
/// \return disc, then plate; the disc is the source
inline signorini::Scene hertz(const signorini::HertzMeshSpec& spec = {},
                              const char* element = "q4_incompatible") {
  signorini::HertzMeshes meshes = make_hertz_meshes(spec);
  signorini::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = std::move(meshes.disc);
  scene.bodies[0].loads.edges = {{"middle", hertz_load / 2 / spec.radius, {}}};
  scene.bodies[1].mesh = std::move(meshes.plate);
  for (signorini::Body& body : scene.bodies) {
    body.element = element;
    body.material = {4000, 0.35, signorini::PlaneState::Strain, 1};
    body.supports = {signorini::symmetric("axis")};
  }
  scene.bodies[1].supports.push_back(signorini::fixed("base"));
  scene.contacts = {{{"rim", "disc"}, signorini::Side{"surface", "plate"}}};
  return scene;
}

}  // namespace signorini_test

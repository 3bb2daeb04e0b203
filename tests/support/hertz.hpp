// The cylinder on a plate of Lin et al., section 3.1, as a scene: half of it, the disc held by contact alone.
#pragma once
#include <string>
#include <utility>

#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/hertz_meshes.hpp"
#include "meshes/split.hpp"
#include "signorini/fem/elements.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// Load per thickness on the whole cylinder [N/mm].
inline constexpr double hertz_load = 41.76;

/// \return number of nodes of both meshes
inline Eigen::Index n_nodes(const signorini::HertzMeshSpec& spec) {
  const signorini::HertzMeshes meshes = signorini::make_hertz_meshes(spec);
  return meshes.disc.n_nodes() + meshes.plate.n_nodes();
}

/// The example; lengths in mm and forces in N, unless `length` and `force` choose other units.
struct HertzProblem {
  signorini::HertzMeshSpec mesh = {};
  std::string element = "q4_incompatible";  ///< of both; the meshes follow
  double disc_modulus = 4000;
  double plate_modulus = 4000;
  double poisson_ratio = 0.35;
  double load = hertz_load;
  double lift = 0;  ///< of the disc before loading; < 0 is overlap
  std::string gap_operator = "mortar";
  signorini::Solver solver = signorini::primal_dual_active_set();
  bool plate_is_source = false;
  double length = 1;  ///< units in a mm
  double force = 1;   ///< units in an N

  /// \return Hertz's two bodies, in mm and N
  [[nodiscard]] signorini::LineContact theory() const {
    using signorini::plane_strain_modulus;
    return {mesh.radius,
            signorini::contact_modulus(plane_strain_modulus(disc_modulus, poisson_ratio),
                                       plane_strain_modulus(plate_modulus, poisson_ratio)),
            load};
  }
};

/// \return disc, then plate; the disc is the source unless `plate_is_source`
inline signorini::Scene scene_of(const HertzProblem& problem) {
  using namespace signorini;
  HertzMeshSpec spec = problem.mesh;
  const Element& element = find_element(problem.element);
  spec.order = element.n_nodes > 4 ? MeshOrder::Quadratic : MeshOrder::Linear;
  HertzMeshes meshes = make_hertz_meshes(spec);
  if (element.corners() == 3) meshes = {split(meshes.disc), split(meshes.plate)};
  const double stress = problem.force / (problem.length * problem.length);
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = moved(std::move(meshes.disc), {0, problem.lift});
  scene.bodies[0].loads.edges = {{"middle", problem.load / 2 / spec.radius * stress, {}}};
  scene.bodies[1].mesh = std::move(meshes.plate);
  const double modulus[] = {problem.disc_modulus, problem.plate_modulus};
  for (std::size_t b = 0; b < 2; ++b) {
    Body& body = scene.bodies[b];
    body.mesh.nodes *= problem.length;
    body.element = problem.element;
    body.material = {modulus[b] * stress, problem.poisson_ratio, PlaneState::Strain,
                     problem.length};
    body.supports = {symmetric("axis")};
  }
  scene.bodies[1].supports.push_back(fixed("base"));
  const Side disc{"rim", "disc"};
  const Side plate{"surface", "plate"};
  scene.contacts = {problem.plate_is_source ? ContactSpec{plate, disc} : ContactSpec{disc, plate}};
  scene.contacts[0].gap_operator = problem.gap_operator;
  scene.solver = problem.solver;
  return scene;
}

/// \param spec     meshes of both
/// \param element  of both
/// \return the example on other meshes
inline signorini::Scene hertz(const signorini::HertzMeshSpec& spec = {},
                              const char* element = "q4_incompatible") {
  HertzProblem problem;
  problem.mesh = spec;
  problem.element = element;
  return scene_of(problem);
}

}  // namespace signorini_test

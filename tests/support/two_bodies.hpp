// Scenes of two bodies: a disc on a plate with its closed form, blocks, and the step to a solution.
#pragma once
#include <string>
#include <vector>

#include "signorini/closed_form/hertz.hpp"
#include "signorini/closed_form/hertz_fit.hpp"
#include "signorini/closed_form/moduli.hpp"
#include "signorini/mesh/block.hpp"
#include "signorini/mesh/reshape.hpp"
#include "signorini/scene/solved.hpp"
#include "support/hertz.hpp"

namespace signorini_test {

/// Half of a disc R = 50 mm on a plate, pressed by P = 41.76 N/mm. Nothing but contact holds the disc up.
struct DiscOnPlate {
  signorini::HertzMeshSpec mesh = {};
  std::string element = "q4_incompatible";
  double disc_modulus = 4000;
  double plate_modulus = 4000;
  double poisson_ratio = 0.35;
  double load = hertz_load;
  double lift = 0;    ///< of the disc before loading; < 0 is overlap
  double length = 1;  ///< what a millimetre is called
  double force = 1;   ///< what a newton is called
};

inline signorini::Scene scene_of(const DiscOnPlate& given) {
  signorini::HertzMeshSpec spec = given.mesh;
  if (given.element == "q8") spec.order = signorini::MeshOrder::Quadratic;
  signorini::Scene scene = hertz(spec, given.element.c_str());
  signorini::Body& disc = scene.bodies[0];
  disc.mesh = moved(std::move(disc.mesh), {0, given.lift});
  const double pressure = given.force / (given.length * given.length);
  disc.loads.edges[0].pressure *= given.load / hertz_load * pressure;
  for (signorini::Body& body : scene.bodies) {
    body.mesh.nodes *= given.length;
    body.material = {(&body == &disc ? given.disc_modulus : given.plate_modulus) * pressure,
                     given.poisson_ratio, signorini::PlaneState::Strain, given.length};
  }
  return scene;
}

/// What the theory of Hertz makes of it, in N and mm.
inline signorini::LineContact theory_of(const DiscOnPlate& given) {
  using signorini::plane_strain_modulus;
  return {
      given.mesh.radius,
      signorini::contact_modulus(plane_strain_modulus(given.disc_modulus, given.poisson_ratio),
                                 plane_strain_modulus(given.plate_modulus, given.poisson_ratio)),
      given.load};
}

inline std::vector<double> list(const Eigen::VectorXd& v) {
  return {v.data(), v.data() + v.size()};
}

/// Fitted peak pressure and half-width from the second moment, as shares of what the theory says, less 1.
struct HertzErrors {
  double peak;
  double width;
};

inline HertzErrors errors_of(const signorini::SolvedScene& run,
                             const signorini::LineContact& theory,
                             signorini::Trace trace = signorini::Trace::Linear) {
  using namespace signorini;
  const std::vector<double> x = list(run.model.pairs.position.col(0));
  const HertzFit fit = fit_hertz(x, list(run.solution.pressure));
  const double width = half_width_of_forces(x, list(run.solution.contact.force), trace);
  return {fit.peak_pressure / hertz_peak_pressure(theory) - 1,
          width / hertz_half_width(theory) - 1};
}

inline signorini::Mesh named_block(const std::string& name, Eigen::Vector2d corner,
                                   Eigen::Vector2d size, Eigen::Index nx, Eigen::Index ny,
                                   signorini::MeshOrder order = signorini::MeshOrder::Linear) {
  signorini::BlockSpec spec;
  spec.name = name;
  spec.corner = corner;
  spec.size = size;
  spec.cells_x = nx;
  spec.cells_y = ny;
  spec.order = order;
  return signorini::make_block(spec);
}

/// Two blocks of one material, the bottom of `upper` on the top of `lower`, which stands on its fixed bottom.
inline signorini::Scene two_blocks(signorini::Mesh lower, signorini::Mesh upper) {
  using namespace signorini;
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = std::move(lower);
  scene.bodies[1].mesh = std::move(upper);
  for (Body& body : scene.bodies) {
    body.material = {1000, 0.3, PlaneState::Strain, 1};
    body.element = body.mesh.cells.cols() == 8 ? "q8" : "q4_incompatible";
  }
  scene.bodies[0].supports = {fixed("bottom")};
  scene.contacts = {{{"bottom", "upper"}, Side{"top", "lower"}}};
  return scene;
}

}  // namespace signorini_test

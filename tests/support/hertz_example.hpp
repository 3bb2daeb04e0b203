/// \file
/// Hertz's cylinder on a plate as a scene: Lin et al., section 3.1.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "signorini/closed_form/hertz.hpp"
#include "signorini/closed_form/hertz_fit.hpp"
#include "signorini/closed_form/moduli.hpp"
#include "signorini/mesh/hertz_meshes.hpp"
#include "signorini/scene/solved.hpp"

namespace signorini_test {

/// The example; lengths in mm and forces in N, unless `length` and `force` choose other units.
struct HertzProblem {
  signorini::HertzMeshSpec mesh = {};
  double disc_modulus = 4000;
  double plate_modulus = 4000;
  double load = 41.76;
  std::string element = "q4_incompatible";
  std::string gap_operator = "mortar";
  std::string solver = "primal_dual_active_set";
  bool plate_is_source = false;
  double length = 1;  ///< units in a mm
  double force = 1;   ///< units in an N

  /// \return Hertz's two bodies, in mm and N
  [[nodiscard]] signorini::LineContact theory() const {
    return {mesh.radius,
            signorini::contact_modulus(signorini::plane_strain_modulus(disc_modulus, 0.35),
                                       signorini::plane_strain_modulus(plate_modulus, 0.35)),
            load};
  }
};

inline signorini::Scene hertz(const HertzProblem& problem) {
  using namespace signorini;
  const double L = problem.length, F = problem.force;
  HertzMeshSpec spec = problem.mesh;
  spec.radius *= L;
  spec.plate *= L;
  spec.core *= L;
  const HertzMeshes meshes = make_hertz_meshes(spec);
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mesh = meshes.disc;
  scene.bodies[1].mesh = meshes.plate;
  for (Body& body : scene.bodies) {
    body.element = problem.element;
    body.material = {problem.disc_modulus * F / (L * L), 0.35, PlaneState::Strain, L};
    body.supports = {symmetric("axis")};
  }
  scene.bodies[0].loads.edges = {{"middle", problem.load / 100 * F / (L * L), {}}};
  scene.bodies[1].material.youngs_modulus = problem.plate_modulus * F / (L * L);
  scene.bodies[1].supports.push_back(fixed("base"));
  Side source{"rim", "disc"}, target{"surface", "plate"};
  if (problem.plate_is_source) std::swap(source, target);
  scene.contacts = {{source, target, problem.gap_operator}};
  scene.solver = problem.solver;
  return scene;
}

/// The pairs of a solved example from the axis outwards, and two figures of them against the theory.
struct HertzReading {
  std::vector<double> x, force, pressure;
  double q_error;  ///< of the fitted largest pressure [%]
  double b_error;  ///< of the half-width of the second moment [%]
};

inline HertzReading read_hertz(const HertzProblem& problem, const signorini::SolvedScene& run) {
  using namespace signorini;
  HertzReading out;
  std::vector<Eigen::Index> order;
  for (Eigen::Index k = 0; k < run.model.pairs.weight.size(); ++k) order.push_back(k);
  const auto x = run.model.pairs.position.col(0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return x(a) < x(b); });
  for (const Eigen::Index k : order) {
    out.x.push_back(x(k));
    out.force.push_back(run.solution.contact.force(k));
    out.pressure.push_back(run.solution.pressure(k));
  }
  const Trace trace = problem.element == "q8" ? Trace::Quadratic : Trace::Linear;
  const LineContact theory = problem.theory();
  const double peak = fit_hertz(out.x, out.pressure).peak_pressure;
  out.q_error = 100 * (peak / hertz_peak_pressure(theory) - 1);
  out.b_error =
      100 * (half_width_of_forces(out.x, out.force, trace) / hertz_half_width(theory) - 1);
  return out;
}

/// \return place of the node of a mesh where both bodies touch first
inline Eigen::Index touching_node(const signorini::Mesh& mesh) {
  Eigen::Index node = 0;
  mesh.nodes.rowwise().squaredNorm().minCoeff(&node);
  return node;
}

}  // namespace signorini_test

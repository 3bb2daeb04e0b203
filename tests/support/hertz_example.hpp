/// \file
/// Variants of the scene of hertz.hpp, and what is read off a solved one.
#pragma once
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "signorini/closed_form/hertz.hpp"
#include "signorini/closed_form/hertz_fit.hpp"
#include "signorini/closed_form/moduli.hpp"
#include "signorini/scene/solved.hpp"
#include "support/hertz.hpp"

namespace signorini_test {

/// The example; lengths in mm and forces in N, unless `length` and `force` choose other units.
struct HertzProblem {
  signorini::HertzMeshSpec mesh = {};
  double disc_modulus = 4000;
  double plate_modulus = 4000;
  double load = hertz_load;
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

inline signorini::Scene scene_of(const HertzProblem& problem) {
  const double L = problem.length, stress = problem.force / (L * L);
  signorini::HertzMeshSpec spec = problem.mesh;
  spec.radius *= L;
  spec.plate *= L;
  spec.core *= L;
  signorini::Scene scene = hertz(spec, problem.element.c_str());
  const double modulus[] = {problem.disc_modulus, problem.plate_modulus};
  for (std::size_t body = 0; body < 2; ++body)
    scene.bodies[body].material = {modulus[body] * stress, 0.35, signorini::PlaneState::Strain, L};
  scene.bodies[0].loads.edges[0].pressure = problem.load / 2 / problem.mesh.radius * stress;
  signorini::ContactSpec& contact = scene.contacts[0];
  if (problem.plate_is_source) {
    const signorini::Side disc = contact.source;
    contact.source = std::get<signorini::Side>(contact.target);
    contact.target = disc;
  }
  contact.gap_operator = problem.gap_operator;
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

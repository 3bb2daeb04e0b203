// A strip footing 3 m wide on soil, Lin et al., section 3.3, in m and kPa: half of it, or all of the soil.
#pragma once
#include <Eigen/Core>
#include <algorithm>

#include "addons/certified/solve_with_proofs.hpp"
#include "closed_form/footing.hpp"
#include "meshes/half_space.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini_test {

inline const double footing_half = 1.5, footing_load = 15, soil_modulus = 2e4;

inline signorini::EdgeBlockSpec soil_spec(Eigen::Index under, Eigen::Index beside,
                                          Eigen::Index deep, double grading, double far) {
  signorini::EdgeBlockSpec soil;
  soil.edge = footing_half;
  soil.width = soil.depth = far;
  soil.cells_under = under;
  soil.cells_beside = beside;
  soil.cells_deep = deep;
  soil.grading_under = grading;
  return soil;
}

struct FootingSpec {
  double thickness = 2;
  Eigen::Index rows = 4;
  double modulus = 2e7;
  Eigen::Index columns = 0;    // of cells; 0: those of the soil
  double half = footing_half;  // of its width; the load stays the same
};

/// The footing is body 0, the soil body 1 and the source.
inline signorini::Scene footing_on(const signorini::EdgeBlockSpec& soil,
                                   const FootingSpec& footing = {}) {
  signorini::EdgeBlockSpec above = soil;
  if (footing.columns > 0) above.cells_under = footing.columns;
  signorini::Scene scene;
  scene.bodies.resize(2);
  signorini::Body& top = scene.bodies[0];
  signorini::Body& ground = scene.bodies[1];
  top.mesh = signorini::make_graded_block(
      "footing", above.under() * (footing.half / footing_half),
      signorini::stretched(0, {{footing.thickness, footing.rows, 2}}), soil.order);
  top.material = {footing.modulus, 0.25, signorini::PlaneState::Strain, 1};
  top.supports = {signorini::symmetric("left")};
  top.loads.edges = {{"top", footing_load * footing_half / footing.half, {}}};
  ground.mesh = signorini::make_edge_block(soil);
  ground.material = {soil_modulus, 0.25, signorini::PlaneState::Strain, 1};
  ground.supports = {signorini::symmetric("axis"), signorini::fixed("base")};
  scene.contacts = {{{"surface", "soil"}, signorini::Side{"bottom", "footing"}}};
  return scene;
}

/// The footing as the source of the same contact.
inline signorini::Scene turned_round(signorini::Scene scene) {
  signorini::ContactSpec& contact = scene.contacts.front();
  const signorini::Side ground = contact.source;
  contact.source = std::get<signorini::Side>(contact.target);
  contact.target = ground;
  return scene;
}

/// Forces on the soil, from the axis to the edge.
struct Ground {
  Eigen::VectorXd position, force;
  double settlement;
};

inline Ground ground_of(const signorini::SolvedScene& run) {
  const signorini::Mesh& soil = run.model.bodies[1].mesh;
  std::vector<Eigen::Index> nodes = signorini::boundary_nodes(soil, "surface");
  std::reverse(nodes.begin(), nodes.end());
  const signorini::NodeArray force = signorini::contact_forces(run.model, run.solution, 1);
  const double middle = run.solution.displacements[1](nodes.front(), 1);
  return {soil.nodes(nodes, 0), -force(nodes, 1), -middle};
}

/// A footing without elasticity on half of the soil, or on all of it under an eccentric load.
struct RigidRest {
  Eigen::VectorXd position, force;
  double settlement, tilt;
};

inline RigidRest rigid_on(const signorini::EdgeBlockSpec& spec,
                          const double* eccentricity = nullptr) {
  using namespace signorini;
  Scene scene;
  Body& soil = scene.bodies[0];
  soil.mesh = make_edge_block(spec);
  soil.supports = {fixed("base")};
  if (eccentricity == nullptr)
    soil.supports.push_back(symmetric("axis"));
  else
    soil.mesh = joined(soil.mesh, "axis", mirrored(soil.mesh, MirrorLine::Upright), "axis");
  soil.material = {soil_modulus, 0.25, PlaneState::Strain, 1};
  scene.contacts = {{{"loaded"}, half_plane({0, 0}, {0, -1})}};
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  const Eigen::VectorXd x = model.pairs.position.col(0);
  ContactProblem problem = condensed.problem;
  problem.rigid = -Eigen::MatrixXd::Ones(x.size(), 1);
  problem.resultant = Eigen::VectorXd::Constant(1, -footing_load * footing_half);
  if (eccentricity != nullptr) {
    problem.rigid.conservativeResize(Eigen::NoChange, 2);
    problem.rigid.col(1) = -x;
    problem.resultant = -2 * footing_load * footing_half * Eigen::Vector2d(1, *eccentricity);
  }
  const ContactState state = solve_with_proofs(problem, scene.solver);
  if (state.report.status != SolveStatus::Solved) throw NotSolved("the rigid footing");
  return {x.reverse(), state.force.reverse(), state.amplitude(0),
          eccentricity == nullptr ? 0 : state.amplitude(1)};
}

/// Force over its share of (46) less one, node by node.
inline Eigen::VectorXd against_46(const Eigen::VectorXd& position, const Eigen::VectorXd& force) {
  const signorini::RigidStrip strip{footing_half, 2 * footing_load * footing_half};
  const Eigen::Index n = position.size();
  Eigen::VectorXd off(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double left = k == 0 ? 0 : (position(k - 1) + position(k)) / 2;
    const double right = k == n - 1 ? footing_half : (position(k) + position(k + 1)) / 2;
    off(k) = force(k) / signorini::rigid_strip_force(strip, left, right) - 1;
  }
  return off;
}

/// Largest deviation of a node with x <= 0.8 a; nodes beyond a do not count.
inline double worst_inside(const Eigen::VectorXd& position, const Eigen::VectorXd& force) {
  Eigen::Index n = 0;
  while (n < position.size() && position(n) <= footing_half) ++n;
  const Eigen::VectorXd off = against_46(position.head(n), force.head(n));
  return (position.head(n).array() <= 0.8 * footing_half + 1e-9)
      .select(off, 0)
      .cwiseAbs()
      .maxCoeff();
}

}  // namespace signorini_test

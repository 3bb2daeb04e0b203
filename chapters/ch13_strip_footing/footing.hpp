// The footing of chapter 13 on its soil, and what is compared with the closed form.
#pragma once
#include <algorithm>
#include <cmath>

#include "signorini/closed_form/footing.hpp"
#include "signorini/closed_form/moduli.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/mesh/half_space.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/springs.hpp"

namespace ch13 {

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;

// [data]
const double a = 1.5;                // half of the width [m]
const double q = 15;                 // on top of the footing [kPa]
const double soil_modulus = 20e3;    // [kPa]
const double footing_modulus = 2e7;  // [kPa]
const double poisson_ratio = 0.25;   // of both [-]
const RigidStrip strip{a, 2 * q* a};
// [data]
const double mean_pressure = 2 * q / std::acos(-1.0);  // (46) in the middle [kPa]

/// Cells under half of the footing, beside it and in depth; width = depth = `far`.
inline EdgeBlockSpec soil_of(Index under, Index beside, Index deep, double grading, double far) {
  EdgeBlockSpec soil;
  soil.edge = a;
  soil.width = soil.depth = far;
  soil.cells_under = under;
  soil.cells_beside = beside;
  soil.cells_deep = deep;
  soil.grading_under = grading;
  return soil;
}

/// Half of the soil: held below, on rollers at the axis, free at the side.
inline Body soil_body(const EdgeBlockSpec& spec) {
  Body soil;
  soil.mesh = make_edge_block(spec);
  soil.material = {soil_modulus, poisson_ratio, PlaneState::Strain, 1};
  soil.supports = {symmetric("axis"), fixed("base")};
  return soil;
}

/// The footing and how it is divided.
struct FootingSpec {
  double thickness = 2;              // [m]
  Index rows = 4;                    // of cells
  double modulus = footing_modulus;  // [kPa]
  Index columns = 0;                 // of cells; 0: those of the soil
};

// [scene]
inline Scene on_soil(const EdgeBlockSpec& soil, const FootingSpec& spec) {
  EdgeBlockSpec above = soil;
  if (spec.columns > 0) above.cells_under = spec.columns;
  Body footing;
  footing.mesh = make_graded_block("footing", above.under(),
                                   stretched(0, {{spec.thickness, spec.rows, /*grading*/ 2}}));
  footing.material = {spec.modulus, poisson_ratio, PlaneState::Strain, 1};
  footing.supports = {symmetric("left")};
  footing.loads.edges = {{"top", q, {}}};
  Scene scene;
  scene.bodies = {footing, soil_body(soil)};
  scene.contacts = {{/*source*/ {"surface", "soil"}, /*target*/ Side{"bottom", "footing"}}};
  return scene;
}
// [scene]

/// What the soil feels at its nodes under the right half, from the axis to the edge.
struct Base {
  VectorXd position;      // `n` x [m]
  VectorXd force;         // `n` [kN/m]
  VectorXd share;         // `n` of (46), between mid-points [kN/m]
  VectorXd width;         // `n` between mid-points [m]
  double settlement = 0;  // of the middle [m]
  VectorXd piece;         // `n` middles between mid-points [m]

  VectorXd deviation() const { return force.cwiseQuotient(share).array() - 1; }
  VectorXd pressure() const { return force.cwiseQuotient(width); }
  /// Largest deviation of a node with x <= 0.8 a.
  double worst() const {
    return (position.array() < 0.8 * a + 1e-9).select(deviation(), 0).cwiseAbs().maxCoeff();
  }
};

/// \PaperEq{LinEtAl, 46}, integrated between the mid-points of neighbouring nodes.
// [share]
inline Base compared(const VectorXd& position, const VectorXd& force, double settlement) {
  const Index n = position.size();
  Base base{position, force, VectorXd(n), VectorXd(n), settlement, VectorXd(n)};
  for (Index k = 0; k < n; ++k) {
    const double left = k == 0 ? 0 : (position(k - 1) + position(k)) / 2;
    const double right = k == n - 1 ? a : (position(k) + position(k + 1)) / 2;
    base.share(k) = rigid_strip_force(strip, left, right);
    base.width(k) = right - left;
    base.piece(k) = (left + right) / 2;
  }
  return base;
}
// [share]

/// Pressures that are linear between nodes and whose integrals with the shape functions are the forces.
// [standard]
inline VectorXd standard_pressure(const Base& base) {
  const Index n = base.position.size();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  for (Index k = 0; k + 1 < n; ++k) {
    const double h = base.position(k + 1) - base.position(k);
    mass.block<2, 2>(k, k) += h / 6 * (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  }
  return CholeskyFactor(mass).solve(base.force);
}
// [standard]

/// The soil under an elastic footing.
inline Base base_of(const SolvedScene& run) {
  const Mesh& soil = run.model.bodies[1].mesh;
  std::vector<Index> nodes = boundary_nodes(soil, "loaded");  // from the edge to the axis
  std::reverse(nodes.begin(), nodes.end());
  const NodeArray on_soil = contact_forces(run.model, run.solution, 1);
  const double middle = run.solution.displacements[1](nodes.front(), 1);
  return compared(soil.nodes(nodes, 0), -on_soil(nodes, 1), -middle);
}

/// The soil under a footing that cannot deform: the only unknown of the footing is how far it sinks.
// [rigid]
inline Base rigid_base(const EdgeBlockSpec& soil) {
  Scene scene;
  scene.bodies = {soil_body(soil)};
  scene.contacts = {{{"loaded"}, half_plane({0, 0}, {0, -1})}};
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  const Index n = condensed.problem.free_gap.size();
  ContactProblem problem = condensed.problem;
  problem.rigid = -Eigen::MatrixXd::Ones(n, 1);
  problem.resultant = VectorXd::Constant(1, -strip.force / 2);
  const ContactState state = solve(problem, find_solver(scene.solver));
  // [rigid]
  if (state.report.status != Status::Solved) throw NotSolved("the rigid footing");
  return compared(model.pairs.position.col(0).reverse(), state.force.reverse(), state.amplitude(0));
}

}  // namespace ch13

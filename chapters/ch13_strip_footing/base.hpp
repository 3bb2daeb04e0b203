// What the soil feels under the footing, beside the closed form.
#pragma once
#include <algorithm>

#include "footing.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace ch13 {

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
  const ContactState state = solve(problem, scene.solver);
  // [rigid]
  if (state.report.status != SolveStatus::Solved) throw NotSolved("the rigid footing");
  return compared(model.pairs.position.col(0).reverse(), state.force.reverse(), state.amplitude(0));
}

}  // namespace ch13

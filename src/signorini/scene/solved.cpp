#include "signorini/scene/solved.hpp"

#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {

// [solved]
SolvedScene solved(const Scene& scene, const std::string& what) {
  Ledger ledger;
  Model model = build(scene, ledger);             // K, p, A, g of the quadratic programme
  Condensed condensed = condense(model, ledger);  // G = A K^-1 A^T and d = g - A u0
  Solution solution = solve(model, condensed, scene.solver, ledger);
  require_solved(solution, what);
  return {std::move(model), std::move(condensed), std::move(solution)};
}
// [solved]

NodeArray obstacle_forces(const Model& model, const Solution& solution) {
  require(solution.contact.report.status == Status::Solved,
          "forces on the nodes: the problem was not solved");
  NodeArray forces = NodeArray::Zero(model.mesh.n_nodes(), 2);
  for (Eigen::Index pair = 0; pair < solution.contact.force.size(); ++pair)
    forces.row(model.gaps.node[static_cast<std::size_t>(pair)]) +=
        solution.contact.force(pair) * model.gaps.normal.row(pair);
  return forces;
}

NodeArray support_forces(const Model& model, const Loads& loads, const Solution& solution) {
  const NodeArray obstacle = obstacle_forces(model, solution);
  return internal_forces(model.mesh, model.element, model.material, solution.displacements) -
         nodal_loads(model.mesh, model.element, model.material, loads) - obstacle;
}

BoundaryForces boundary_forces(const Scene& scene, const SolvedScene& run,
                               const std::string& name) {
  const Model& model = run.model;
  const std::vector<Eigen::Index> nodes = boundary_nodes(model.mesh, name);
  NodeArray force = obstacle_forces(model, run.solution);
  const NodeArray support = support_forces(model, scene.loads, run.solution);
  for (const Eigen::Index node : nodes)
    for (int axis = 0; axis < 2; ++axis)
      if (model.unknowns.number(node, axis) < 0) force(node, axis) += support(node, axis);
  return {model.mesh.nodes(nodes, Eigen::all), force(nodes, Eigen::all),
          boundary_weights(model.mesh, name, model.material.thickness)};
}

}  // namespace signorini

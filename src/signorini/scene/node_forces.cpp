// # Forces read from a solution
//
// A solution has displacements and a force per pair. A reader wants forces on nodes, on
// boundaries and in supports. All of them follow from the balance of the nodes,
// \f[ \text{internal forces} = \text{loads} + N^T\lambda + S^T\tau + \text{springs, supports}. \f]
//
// An example: two springs of stiffness 1 in a row, the first one held at its left end, and a
// force of 3 that pulls the right end towards a stop 1 away. The middle moves by 0.5, the
// end by 1, and the stop presses with 2.5. The held node feels the internal force -0.5, has
// no load and touches nothing: its support gives -0.5. The sum 3 - 2.5 - 0.5 is 0.

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {
namespace {

// Without a solution there are numbers, but no forces. Plots of them would look like a
// result.
void require_forces(const Solution& solution) {
  require_argument(solution.contact.report.status == SolveStatus::Solved,
                   "forces on the nodes: the problem was not solved");
}

}  // namespace

// N and S have columns for held components too. So a force that a pair hands to a held node
// is seen here, although the solver has no unknown for it.
NodeArray contact_forces(const Model& model, const Solution& solution, std::size_t body) {
  require_forces(solution);
  const BodyModel& own = model.bodies.at(body);
  Eigen::VectorXd all = model.pairs.opening.transpose() * solution.contact.force;
  const ContactState& contact = solution.contact;
  for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k)
    all += contact.friction(static_cast<Eigen::Index>(k)) *
           model.pairs.sliding.row(contact.frictional_pairs[k]).transpose();
  return Eigen::Map<const NodeArray>(all.data() + 2 * own.first_node, own.mesh.n_nodes(), 2);
}

// What is missing in the balance of a held component is the force of its support. On free
// components nothing should be missing: there one sees the rounding of the whole run.
NodeArray support_forces(const Model& model, const Solution& solution, std::size_t body) {
  const NodeArray contact = contact_forces(model, solution, body);
  const BodyModel& own = model.bodies[body];
  // A rigid motion strains nothing, but its rounding would.
  NodeArray strains = expand(model.unknowns, strained(solution.refined))
                          .middleRows(own.first_node, own.mesh.n_nodes());
  if (!solution.strains.empty()) strains = solution.strains[body];
  NodeArray held = internal_forces(own.mesh, own.element, own.material, strains) -
                   nodal_loads(own.mesh, own.element, own.material, own.loads) - contact;
  if (!solution.bond_forces.empty()) held -= solution.bond_forces[body];
  return own.springs.rows() == 0 ? held : held - spring_forces(model, solution, body);
}

// A spring pulls back, against its displacement.
NodeArray spring_forces(const Model& model, const Solution& solution, std::size_t body) {
  require_forces(solution);
  const BodyModel& own = model.bodies.at(body);
  NodeArray force = NodeArray::Zero(own.mesh.n_nodes(), 2);
  if (own.springs.rows() == 0) return force;
  const NodeArray& u = solution.displacements.at(body);
  Eigen::Map<Eigen::VectorXd>(force.data(), force.size()) =
      -(own.springs * Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()));
  return force;
}

// Supports count only at held components. On the others the support force is rounding, and
// zero is the truth.
BoundaryForces boundary_forces(const SolvedScene& run, const Side& side) {
  const std::size_t body = body_index(run.model.bodies, side);
  const BodyModel& own = run.model.bodies[body];
  const std::vector<Eigen::Index> nodes = boundary_nodes(own.mesh, side.boundary);
  NodeArray force = contact_forces(run.model, run.solution, body);
  const NodeArray support = support_forces(run.model, run.solution, body);
  for (const Eigen::Index node : nodes)
    for (int axis = 0; axis < 2; ++axis)
      if (own.unknowns.number(node, axis) < 0) force(node, axis) += support(node, axis);
  return {own.mesh.nodes(nodes, Eigen::all), force(nodes, Eigen::all),
          boundary_weights(own.mesh, side.boundary, depth_of(own.material))};
}

}  // namespace signorini

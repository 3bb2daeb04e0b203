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

#include "signorini/scene/readings.hpp"

#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

// Without a solution there are numbers, but no forces. Plots of them would look like a
// result.
void require_forces(const Solution& solution) {
  require_argument(solution.contact.report.status == SolveStatus::Solved,
                   "forces on the nodes: the problem was not solved");
}

}  // namespace

// A pair that sticks has slip 0 by definition, but the refined displacements leave a rest
// like \f$ 10^{-18} \f$. Sums over many steps should not collect it.
Eigen::VectorXd increment(const ContactState& contact) {
  Eigen::VectorXd slip = contact.slip;
  for (Eigen::Index k = 0; k < slip.size(); ++k)
    if (contact.contact_status[static_cast<std::size_t>(k)] == ContactStatus::Stick) slip(k) = 0;
  return slip;
}

// A friction force of 3 that acts over a slip of 0.2 takes 0.6 of the energy. Friction acts
// against the slip, so the work is lost in both directions and the absolute value counts it.
Eigen::VectorXd dissipated(const ContactState& contact) {
  return contact.friction.cwiseProduct(increment(contact)).cwiseAbs();
}

// The whole road in four lines. Many programs of the chapters begin with it.
// [solved]
SolvedScene solved(const Scene& scene, const std::string& what) {
  Ledger ledger;
  Model model = build(scene, ledger);             // K, p, A, g of the quadratic programme
  Condensed condensed = condense(model, ledger);  // G = A K^-1 A^T and d = g - A u0
  Solution solution = solve(model, condensed, ledger);
  require_solved(solution, what);
  return {std::move(model), std::move(condensed), std::move(solution)};
}
// [solved]

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
  const NodeArray all = expand(model.unknowns, strained(solution.refined));
  const NodeArray strains = all.middleRows(own.first_node, own.mesh.n_nodes());
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

// Every entry \f$ n_x \f$ moves to the y column as \f$ -n_x \f$, every \f$ n_y \f$ to the x
// column. The normal (0, 1) becomes the tangent (1, 0). So slips can be read also where no
// friction asked for the rows S.
NodalRows turned(const NodalRows& opening) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index row = 0; row < opening.rows(); ++row)
    for (NodalRows::InnerIterator it(opening, row); it; ++it) {
      const bool along_x = it.col() % 2 == 0;
      entries.emplace_back(static_cast<int>(row),
                           static_cast<int>(along_x ? it.col() + 1 : it.col() - 1),
                           along_x ? -it.value() : it.value());
    }
  NodalRows rows(opening.rows(), opening.cols());
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

// Bodies have arrays of their own, rows of N have columns for all nodes.
Eigen::VectorXd all_displacements(const Model& model, const std::vector<NodeArray>& displacements) {
  Eigen::VectorXd all(2 * count_nodes(model.bodies));
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    all.segment(2 * model.bodies[b].first_node, displacements[b].size()) =
        Eigen::Map<const Eigen::VectorXd>(displacements[b].data(), displacements[b].size());
  return all;
}

// Displacements of held nodes are given, not zero. They are among all displacements, so
// nothing is added for supports.
Eigen::VectorXd slips(const Model& model, const std::vector<NodeArray>& displacements) {
  return turned(model.pairs.opening) * all_displacements(model, displacements);
}

}  // namespace signorini

#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/equations/equations.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// What rows lack: C u - h `m` of all nodes.
VectorXd lacking(const Model& model, const VectorXd& u) {
  const Equations& all = *model.equations;
  VectorXd left = all.matrix * u;
  for (Index k = 0; k < left.size(); ++k) left(k) -= all.rows[at(k)].right;
  return left;
}

/// By how much equations do not hold, beside how far their nodes move or how large their right sides are.
double open_equations(const Model& model, const VectorXd& u, const VectorXd& left) {
  const Equations& all = *model.equations;
  const VectorXd terms = all.matrix.cwiseAbs() * u.cwiseAbs();
  double length = 0;
  double most = 0;
  for (const Index k : all.held) {
    length = std::max({length, terms(k), std::abs(all.rows[at(k)].right)});
    most = std::max(most, std::abs(left(k)));
  }
  return ratio(most, length);
}

void add_loads(const Bond& bond, VectorXd& nodal) {
  for (const auto& [component, force] : bond.loads) nodal(component) += force;
}

/// Forces on the components of all nodes: of rows, and what drives rigid sides.
VectorXd on_nodes(const Equations& all, const VectorXd& forces) {
  VectorXd nodal = all.matrix.transpose() * forces;
  for (const Bond& bond : all.bonds) add_loads(bond, nodal);
  return nodal;
}

/// The forces that are missing at the unknowns: the residual of equilibrium, less springs and the loads of rigid sides.
/// \param known  of these two `2 n_nodes`
VectorXd missing_forces(const Model& model, const Solution& solution, const VectorXd& known) {
  VectorXd missing(model.unknowns.count);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const Eigen::Map<const NodeArray> own(known.data() + 2 * body.first_node, body.mesh.n_nodes(), 2);
    missing.segment(body.first_unknown, body.unknowns.count) =
        restricted(body.unknowns, support_forces(model, solution, b) - own);
  }
  return missing;
}

/// Adds a force at x. In axial symmetry what acts along the radius is in balance all round, and nothing has a moment.
void add_force(const Vector2d& x, const Vector2d& f, bool axial, BondForces& sum) {
  sum.force += axial ? Vector2d(0, f.y()) : f;
  if (!axial) sum.moment += x.x() * f.y() - x.y() * f.x();
}

/// How far a node has moved from where its body was when its forces were found.
Vector2d gone(const Model& model, Index node) {
  return model.standing ? Vector2d(model.standing->displacement.row(node).transpose())
                        : Vector2d(0, 0);
}

/// Adds the force of a pair that has `gone` from its position, as Resultants has it.
void add_pair(const Pairs& pairs, Index pair, const Vector2d& gone, const Vector2d& forces, bool axial,
              BondForces& sum) {
  const Vector2d n = pairs.normal.row(pair).transpose();
  const Vector2d f = forces.x() * n + forces.y() * Vector2d(n.y(), -n.x());
  const double pressure = forces.x() / pairs.weight(pair);
  sum.least_pressure = pair == 0 ? pressure : std::min(sum.least_pressure, pressure);
  sum.largest_pressure = pair == 0 ? pressure : std::max(sum.largest_pressure, pressure);
  sum.largest_shear = std::max(sum.largest_shear, std::abs(forces.y()) / pairs.weight(pair));
  add_force(pairs.position.row(pair).transpose() + gone, f, axial, sum);
  if (!axial) sum.moment += pairs.moment.row(pair).dot(forces.transpose());
}

/// The sums of a tie.
void add_pairs(const Model& model, const Bond& bond, const VectorXd& row_force, BondForces& sum) {
  const Index pairs = bond.pairs.weight.size();
  NodeArray forces = NodeArray::Zero(pairs, 2);
  for (std::size_t k = bond.first; k < bond.end; ++k) {
    const Equation& row = model.equations->rows[k];
    forces.row(row.pair) +=
        row_force(static_cast<Index>(k)) * Eigen::RowVector2d(row.opening, row.sliding);
  }
  const bool axial = is_axial(model.bodies.front());
  for (Index pair = 0; pair < pairs; ++pair)
    add_pair(bond.pairs, pair, gone(model, bond.first_node + bond.pairs.node[at(pair)]),
             forces.row(pair).transpose(), axial, sum);
}

/// The sums of the forces on the nodes of a bond without sides that face each other.
void add_nodes(const Model& model, const Bond& bond, const VectorXd& nodal, BondForces& sum) {
  for (const Index node : bond.nodes) {
    const BodyModel& body = model.bodies[body_of_node(model.bodies, node)];
    add_force(body.mesh.nodes.row(node - body.first_node).transpose() + gone(model, node),
              nodal.segment<2>(2 * node), is_axial(body), sum);
  }
}

}  // namespace

std::vector<BondForces> bond_forces(const Model& model, const Solution& solution) {
  const Equations& all = *model.equations;
  std::vector<BondForces> sums;
  for (const Bond& bond : all.bonds) {
    BondForces& sum = sums.emplace_back();
    sum.name = bond.name;
    sum.has_sides = bond.nodes.empty();
    if (sum.has_sides) {
      add_pairs(model, bond, solution.equation_force, sum);
      continue;
    }
    VectorXd own = VectorXd::Zero(solution.equation_force.size());
    const Index first = static_cast<Index>(bond.first);
    const Index count = static_cast<Index>(bond.end) - first;
    own.segment(first, count) = solution.equation_force.segment(first, count);
    VectorXd nodal = all.matrix.transpose() * own;
    add_loads(bond, nodal);
    add_nodes(model, bond, nodal, sum);
  }
  return sums;
}

void judge_equations(const Model& model, const Condensed& /*condensed*/, Solution& solution) {
  if (!model.equations) return;
  const Equations& all = *model.equations;
  const VectorXd u = all_displacements(model, solution.displacements);
  const VectorXd left = lacking(model, u);
  VectorXd forces = VectorXd::Zero(left.size());
  for (Index k = 0; k < left.size(); ++k) forces(k) = -all.rows[at(k)].stiffness.value_or(0) * left(k);
  const VectorXd missing = missing_forces(model, solution, on_nodes(all, forces));
  forces += all.solved.right.transpose() * VectorXd(missing(all.solved.unknown));
  const VectorXd nodal = on_nodes(all, forces);
  solution.equation_force = std::move(forces);
  for (const BodyModel& body : model.bodies)
    solution.bond_forces.emplace_back(Eigen::Map<const NodeArray>(
        nodal.data() + 2 * body.first_node, body.mesh.n_nodes(), 2));
  double& penetration = solution.certificate.penetration;
  penetration = std::max(penetration, open_equations(model, u, left));
  if (solution.certificate.holds()) return;
  solution.contact.report.status = SolveStatus::Breakdown;
  solution.contact.reason = "the equations do not hold to the digits that a certificate asks for";
}

}  // namespace signorini

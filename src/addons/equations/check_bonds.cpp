#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "addons/equations/equations.hpp"
#include "addons/equations/take_equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/pair_up.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

/// Places are known in two doubles, to epsilon squared of their size. This is the length beside which that error is as large as a
/// certificate allows; 0 unless bodies have moved [length]. Where they come back to rest, displacements are nothing but this error.
double rounded_length(const Model& model) {
  if (!model.standing) return 0;
  double farthest = model.standing->displacement.cwiseAbs().maxCoeff();
  for (const BodyModel& body : model.bodies)
    farthest = std::max(farthest, body.mesh.nodes.cwiseAbs().maxCoeff());
  return 4 * epsilon * epsilon * farthest / certificate_tolerance;
}

/// By how much equations do not hold, beside how far their nodes move or how large their right sides are; where they hold
/// all that moves, beside the way of loads, as gaps are measured.
double open_equations(const Model& model, const Solution& solution, const VectorXd& u, const VectorXd& left) {
  const Equations& all = *model.equations;
  const QuadraticProgramme& programme = model.programme;
  const Factors factors = factors_at(model.path.histories, model.time);
  const VectorXd terms = all.matrix.cwiseAbs() * u.cwiseAbs();
  double length = rounded_length(model);
  double nearest = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const Index k : all.held) {
    const double right = std::abs(factors(all.rows[at(k)].history) * all.rows[at(k)].right);
    length = std::max({length, terms(k), right});
    if (right > 0) nearest = std::min(nearest, right);
    most = std::max(most, std::abs(left(k)));
  }
  // Of other bodies nothing counts: they may move far.
  VectorXd own = VectorXd::Zero(model.unknowns.count);
  for (const Bond& bond : all.bonds)
    for (std::size_t k = bond.first; k < bond.end; ++k)
      for (const auto& [component, value] : all.rows[k].terms) {
        const BodyModel& body = model.bodies[body_of_node(model.bodies, component / 2)];
        own.segment(body.first_unknown, body.unknowns.count).setOnes();
      }
  const VectorXd contact = own.cwiseProduct(programme.A.transpose() * solution.refined.force);
  const VectorXd way = own.cwiseProduct(solution.refined.displacement);
  return ratio(most, std::max(length, way_of_loads(own.cwiseProduct(programme.load), contact,
                                                   own.cwiseProduct(programme.stiffness.diagonal()), way, nearest)));
}

void add_loads(const Bond& bond, const Model& model, VectorXd& nodal) {
  for (const BondLoad& push : bond.loads)
    nodal(push.component) += factor_of(model.path.histories, push.history, model.time) * push.force;
}

/// Forces on the components of all nodes: of rows, and what drives rigid sides.
VectorXd on_nodes(const Model& model, const VectorXd& forces) {
  VectorXd nodal = model.equations->matrix.transpose() * forces;
  for (const Bond& bond : model.equations->bonds) add_loads(bond, model, nodal);
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

/// Where a node is, if bodies have moved to where their forces were found.
Vector2d place_of(const Model& model, const BodyModel& body, Index node) {
  const Vector2d still = body.mesh.nodes.row(node - body.first_node).transpose();
  return model.standing ? Vector2d(still + model.standing->displacement.row(node).transpose())
                        : still;
}

/// The pairs of a tie where its sides stand. Should other nodes face each other there, the normals are those of the meshes.
Pairs pairs_there(const Model& model, const Bond& bond) {
  if (!model.standing) return bond.pairs;
  std::vector<BodyModel> bodies = model.bodies;
  for (BodyModel& body : bodies)
    body.mesh.nodes +=
        model.standing->displacement.middleRows(body.first_node, body.mesh.n_nodes());
  try {
    Pairs there = pair_up(*bond.sides, bodies, false, nullptr);
    if (there.node == bond.pairs.node) return there;
  } catch (const ProblemError&) {
  }
  Pairs there = bond.pairs;
  const BodyModel& source = bodies[body_index(bodies, bond.sides->source)];
  there.position = source.mesh.nodes(there.node, Eigen::all);
  return there;
}

/// What a pair pushes with, by what its rows carry.
Vector2d push(const Pairs& pairs, Index pair, const Vector2d& forces) {
  const Vector2d n = pairs.normal.row(pair).transpose();
  return forces.x() * n + forces.y() * Vector2d(n.y(), -n.x());
}

/// The same push, by what rows there would carry.
Vector2d carried_there(const Pairs& there, Index pair, const Vector2d& f) {
  const Vector2d n = there.normal.row(pair).transpose();
  return Vector2d(f.dot(n), f.x() * n.y() - f.y() * n.x()) / n.squaredNorm();
}

/// Adds what a pair bears by its weight.
void add_pressure(const Pairs& there, Index pair, const Vector2d& forces, BondForces& sum) {
  const double pressure = forces.x() / there.weight(pair);
  sum.least_pressure = pair == 0 ? pressure : std::min(sum.least_pressure, pressure);
  sum.largest_pressure = pair == 0 ? pressure : std::max(sum.largest_pressure, pressure);
  sum.largest_shear = std::max(sum.largest_shear, std::abs(forces.y()) / there.weight(pair));
}

/// Adds the force of a pair, as Resultants has it.
void add_pair(const Pairs& there, Index pair, const Vector2d& forces, bool axial, BondForces& sum) {
  add_force(there.position.row(pair).transpose(), push(there, pair, forces), axial, sum);
  if (!axial) sum.moment += there.moment.row(pair).dot(forces.transpose());
}

/// The sums of the forces on some nodes.
void add_nodes(const Model& model, const std::vector<Index>& nodes, const VectorXd& nodal,
               BondForces& sum) {
  for (const Index node : nodes) {
    const BodyModel& body = model.bodies[body_of_node(model.bodies, node)];
    add_force(place_of(model, body, node), nodal.segment<2>(2 * node), is_axial(body), sum);
  }
}

/// The sums of a tie. Where bodies have moved its rows are those of the meshes, and push on nodes: so what the nodes of its source
/// receive is summed, where they stand.
void add_pairs(const Model& model, const Bond& bond, const VectorXd& row_force, const VectorXd& nodal,
               BondForces& sum) {
  const Index pairs = bond.pairs.weight.size();
  NodeArray forces = NodeArray::Zero(pairs, 2);
  for (std::size_t k = bond.first; k < bond.end; ++k) {
    const Equation& row = model.equations->rows[k];
    for (const RowPart& part : row.parts)
      forces.row(part.pair) += row_force(static_cast<Index>(k)) * Eigen::RowVector2d(part.opening, part.sliding);
  }
  const bool axial = is_axial(model.bodies.front());
  const Pairs there = pairs_there(model, bond);
  for (Index pair = 0; pair < pairs; ++pair) {
    const Vector2d own = forces.row(pair).transpose();
    add_pressure(there, pair,
                 model.standing ? carried_there(there, pair, push(bond.pairs, pair, own)) : own, sum);
    if (!model.standing) add_pair(there, pair, own, axial, sum);
  }
  if (!model.standing) return;
  const Surface source = surface(model.bodies, bond.sides->source);
  std::vector<Index> nodes = boundary_nodes(source.mesh, source.boundary);
  for (Index& node : nodes) node += source.first_node;
  add_nodes(model, nodes, nodal, sum);
}

}  // namespace

std::vector<BondForces> bond_forces(const Model& model, const Solution& solution) {
  const Equations& all = *model.equations;
  std::vector<BondForces> sums;
  for (const Bond& bond : all.bonds) {
    BondForces& sum = sums.emplace_back();
    sum.name = bond.name;
    sum.has_sides = bond.nodes.empty();
    VectorXd own = VectorXd::Zero(solution.equation_force.size());
    const Index first = static_cast<Index>(bond.first);
    const Index count = static_cast<Index>(bond.end) - first;
    own.segment(first, count) = solution.equation_force.segment(first, count);
    VectorXd nodal = all.matrix.transpose() * own;
    if (sum.has_sides) {
      add_pairs(model, bond, solution.equation_force, nodal, sum);
      continue;
    }
    add_loads(bond, model, nodal);
    add_nodes(model, bond.nodes, nodal, sum);
  }
  return sums;
}

void check_bonds(const Model& model, const Condensed& /*condensed*/, Solution& solution) {
  if (!model.equations || solution.contact.report.status != SolveStatus::Solved) return;
  const Equations& all = *model.equations;
  const VectorXd u = all_displacements(model, solution.displacements);
  Displaced there = displaced(model.unknowns, solution.refined);
  there.high = Eigen::Map<const NodeArray>(u.data(), there.high.rows(), 2);
  const VectorXd left = -lacking_at(there, model);
  VectorXd forces = VectorXd::Zero(left.size());
  for (Index k = 0; k < left.size(); ++k) forces(k) = -all.rows[at(k)].stiffness.value_or(0) * left(k);
  const VectorXd missing = missing_forces(model, solution, on_nodes(model, forces));
  forces += all.solved.right.transpose() * VectorXd(missing(all.solved.unknown));
  const VectorXd nodal = on_nodes(model, forces);
  solution.equation_force = std::move(forces);
  for (const BodyModel& body : model.bodies)
    solution.bond_forces.emplace_back(Eigen::Map<const NodeArray>(
        nodal.data() + 2 * body.first_node, body.mesh.n_nodes(), 2));
  double& penetration = solution.certificate.penetration;
  penetration = std::max(penetration, open_equations(model, solution, u, left));
  if (solution.certificate.holds()) return;
  solution.contact.report.status = SolveStatus::Breakdown;
  solution.contact.reason = "the equations do not hold to the digits that a certificate asks for";
}

}  // namespace signorini

#include <algorithm>
#include <cmath>

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

/// By how much equations do not hold, beside how far their nodes move or how large their right sides are.
double open_equations(const Model& model, const Solution& solution) {
  const Equations& all = *model.equations;
  const VectorXd u = all_displacements(model, solution.displacements);
  VectorXd left = all.matrix * u;
  double length = largest(VectorXd(all.matrix.cwiseAbs() * u.cwiseAbs()));
  for (Index k = 0; k < left.size(); ++k) {
    left(k) -= all.rows[at(k)].right;
    length = std::max(length, std::abs(all.rows[at(k)].right));
  }
  return ratio(largest(left), length);
}

/// What supports would have to do to the unknowns if there were no equations is what these do.
VectorXd missing_forces(const Model& model, const Solution& solution) {
  VectorXd missing(model.unknowns.count);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    missing.segment(body.first_unknown, body.unknowns.count) =
        restricted(body.unknowns, support_forces(model, solution, b));
  }
  return missing;
}

/// Adds the force of a pair, as Resultants has it.
void add_pair(const Pairs& pairs, Index pair, const Vector2d& forces, bool axial, BondForces& sum) {
  const Vector2d n = pairs.normal.row(pair).transpose();
  Vector2d f = forces.x() * n + forces.y() * Vector2d(n.y(), -n.x());
  const double pressure = forces.x() / pairs.weight(pair);
  sum.least_pressure = std::min(sum.least_pressure, pressure);
  sum.largest_pressure = std::max(sum.largest_pressure, pressure);
  sum.largest_shear = std::max(sum.largest_shear, std::abs(forces.y()) / pairs.weight(pair));
  if (axial) f.x() = 0;
  sum.force += f;
  if (axial) return;
  sum.moment += pairs.position(pair, 0) * f.y() - pairs.position(pair, 1) * f.x() +
                pairs.moment.row(pair).dot(forces.transpose());
}

}  // namespace

std::vector<BondForces> bond_forces(const Model& model, const Solution& solution) {
  const bool axial = is_axial(model.bodies.front());
  std::vector<BondForces> sums;
  for (const Bond& bond : model.equations->bonds) {
    const Index pairs = bond.pairs.weight.size();
    if (pairs == 0) continue;
    NodeArray forces = NodeArray::Zero(pairs, 2);
    for (std::size_t k = bond.first; k < bond.behind; ++k) {
      const Equation& row = model.equations->rows[k];
      const double force = solution.equation_force(static_cast<Index>(k));
      forces.row(row.pair) += force * Eigen::RowVector2d(row.opening, row.sliding);
    }
    BondForces sum;
    sum.name = bond.name;
    for (Index pair = 0; pair < pairs; ++pair)
      add_pair(bond.pairs, pair, forces.row(pair).transpose(), axial, sum);
    sums.push_back(std::move(sum));
  }
  return sums;
}

void judge_equations(const Model& model, const Condensed& /*condensed*/, Solution& solution) {
  if (!model.equations) return;
  const Equations& all = *model.equations;
  const VectorXd missing = missing_forces(model, solution);
  solution.equation_force =
      all.solved.right.transpose() * VectorXd(missing(all.solved.unknown));
  const VectorXd nodal = all.matrix.transpose() * solution.equation_force;
  for (const BodyModel& body : model.bodies)
    solution.bond_forces.emplace_back(Eigen::Map<const NodeArray>(
        nodal.data() + 2 * body.first_node, body.mesh.n_nodes(), 2));
  double& penetration = solution.certificate.penetration;
  penetration = std::max(penetration, open_equations(model, solution));
  if (solution.certificate.holds()) return;
  solution.contact.report.status = SolveStatus::Breakdown;
  solution.contact.reason = "the equations do not hold to the digits that a certificate asks for";
}

}  // namespace signorini

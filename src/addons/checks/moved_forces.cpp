#include "addons/checks/moved_forces.hpp"

#include "addons/certified/solve_with_proofs.hpp"
#include "addons/certified/working_set.hpp"
#include "addons/equations/eliminate.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Pairs that face nothing are as far open as anything moves.
void open_far(const VectorXd& opens, const VectorXd& displacement, VectorXd& gap) {
  const auto open = opens.array().isInf();
  gap.head(opens.size()) =
      open.select(displacement.cwiseAbs().maxCoeff() +
                      open.select(0, gap.head(opens.size())).cwiseAbs().maxCoeff(),
                  gap.head(opens.size()));
}

ContactState solved(const ContactProblem& problem, const ContactState& contact) {
  SolverOptions options;
  options.start = all_statuses(contact);
  options.start.resize(static_cast<std::size_t>(problem.free_gap.size()), ContactStatus::Open);
  return solve_with_proofs(problem, primal_dual_active_set(), options);
}

}  // namespace

PairForces pair_forces(const ContactState& contact) {
  PairForces forces{contact.force, VectorXd::Zero(contact.force.size())};
  for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k)
    forces.shear(contact.frictional_pairs[k]) = contact.friction(static_cast<Index>(k));
  return forces;
}

VectorXd on_nodes(const NodalRows& opening, const PairForces& forces) {
  if (forces.shear.isZero(0)) return opening.transpose() * forces.normal;
  return opening.transpose() * forces.normal + turned(opening).transpose() * forces.shear;
}

ContactState forces_nearby(const Model& model, const Condensed& condensed,
                           const VectorXd& displacement, const VectorXd& opens,
                           const ContactState& contact) {
  Ledger unseen;
  ContactProblem problem = completed(model, condensed, unseen).problem;
  problem.free_gap += opens;
  open_far(opens, displacement, problem.free_gap);
  return solved(problem, contact);
}

ContactState forces_there(const Model& model, const Condensed& condensed, const MovedPairs& there,
                          const VectorXd& displacement, const VectorXd& opens,
                          const ContactState& contact) {
  const NodalRows normal = below(there.opening, there.fresh);
  const NodalRows rows = below(normal, selected_rows(turned(there.opening), model.law.pair));
  const NodeArray free = expand(model.unknowns, condensed.free_displacement);
  VectorXd movement(rows.rows());
  movement << contact.gap + opens, there.fresh_gap, contact.slip;
  movement -= rows * (displacement - Eigen::Map<const VectorXd>(free.data(), free.size()));
  QuadraticProgramme with;
  with.load = model.programme.load;
  with.A = -free_columns(rows, model.unknowns);
  ContactProblem problem = condensed.problem;
  Ledger unseen;
  problem.compliance = condensed.factor.compliance(with.A, unseen);
  problem.free_gap = movement.head(normal.rows());
  problem.free_slip = movement.tail(contact.slip.size());
  open_far(opens, displacement, problem.free_gap);
  if (!model.modes.empty())
    add_rigid_modes(with, mode_shapes(model.modes), problem, direction_rounding(model.modes));
  return solved(problem, contact);
}

}  // namespace signorini

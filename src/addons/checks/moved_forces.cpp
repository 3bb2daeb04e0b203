#include "addons/checks/moved_forces.hpp"

#include <map>
#include <utility>

#include "addons/certified/many_bodies.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "addons/certified/working_set.hpp"
#include "addons/equations/eliminate.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/ways.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// Pairs that face nothing are as far open as anything moves.
void open_far(const VectorXd& opens, const VectorXd& displacement, VectorXd& gap) {
  const auto open = opens.array().isInf();
  gap.head(opens.size()) =
      open.select(displacement.cwiseAbs().maxCoeff() +
                      open.select(0, gap.head(opens.size())).cwiseAbs().maxCoeff(),
                  gap.head(opens.size()));
}

/// What the pairs did, and fresh ones open.
std::vector<ContactStatus> start_of(const ContactState& contact, Index pairs) {
  std::vector<ContactStatus> start = contact.contact_status;
  start.resize(static_cast<std::size_t>(pairs), ContactStatus::Open);
  return start;
}

ContactState solved(const ContactProblem& problem, const ContactState& contact) {
  SolverOptions options;
  options.start = start_of(contact, problem.free_gap.size());
  return solve_with_proofs(problem, primal_dual_active_set(), options);
}

/// The same by the entries of K and A. Where the sets that follow the old one lead nowhere, it begins anew.
ContactState solved(const QuadraticProgramme& programme, const FrictionLaw& law,
                    const ContactState& contact) {
  ManyBodies bodies{law, entry_scales(programme)};
  bodies.start = start_of(contact, programme.A.rows() - static_cast<Index>(law.pair.size()));
  if (auto state = many_bodies_state(programme, bodies)) return std::move(*state);
  bodies.start.clear();
  if (auto state = many_bodies_state(programme, bodies)) return std::move(*state);
  ContactState none;
  none.report.status = SolveStatus::Breakdown;
  return none;
}

/// Whether the model was solved by its entries: the compliance of what is asked now is as needless.
bool by_entries(const Model& model, const Condensed& condensed) {
  return !is_complete(condensed) && solved_whole(model);
}

}  // namespace

PairForces pair_forces(const ContactState& contact) {
  PairForces forces{contact.force, VectorXd::Zero(contact.force.size())};
  for (std::size_t k = 0; k < contact.frictional_pairs.size(); ++k)
    forces.shear(contact.frictional_pairs[k]) = contact.friction(static_cast<Index>(k));
  return forces;
}

Eigen::SparseVector<double> on_nodes(const NodalRows& opening, const PairForces& forces) {
  std::map<Index, double> sums;
  for (Index pair = 0; pair < opening.rows(); ++pair)
    for (NodalRows::InnerIterator it(opening, pair); it; ++it) {
      sums[it.col()] += it.value() * forces.normal(pair);
      if (const double shear = forces.shear(pair); shear != 0)  // see turned()
        sums[it.col() ^ 1] += (it.col() % 2 == 0 ? -1 : 1) * it.value() * shear;
    }
  Eigen::SparseVector<double> all(opening.cols());
  for (const auto& [component, force] : sums) all.insertBack(component) = force;
  return all;
}

ContactState forces_nearby(const Model& model, const Condensed& condensed,
                           const VectorXd& displacement, const VectorXd& opens,
                           const ContactState& contact) {
  if (by_entries(model, condensed)) {
    QuadraticProgramme programme = model.programme;
    programme.initial_gap.head(opens.size()) += opens;
    open_far(opens, displacement, programme.initial_gap);
    return solved(programme, model.law, contact);
  }
  VectorXd free_gap = condensed.problem.free_gap + opens;
  open_far(opens, displacement, free_gap);
  if (!is_complete(condensed)) {
    SolverOptions options;
    options.start = contact.contact_status;
    const VectorXd more = opens.array().isInf().select(free_gap - condensed.problem.free_gap, opens);
    if (auto few = working_set_state(model, condensed, more, primal_dual_active_set(), options))
      return std::move(*few);
  }
  Ledger unseen;
  ContactProblem problem = completed(model, condensed, unseen).problem;
  problem.free_gap = free_gap;
  return solved(problem, contact);
}

ContactState forces_there(const Model& model, const Condensed& condensed, const MovedPairs& there,
                          const VectorXd& displacement, const VectorXd& opens,
                          const ContactState& contact) {
  const NodalRows normal = below(there.opening, there.fresh);
  const NodalRows rows = below(normal, selected_rows(turned(there.opening), model.law.pair));
  const bool whole = by_entries(model, condensed);
  // By entries nothing is eliminated: what supports give is all that is there without unknowns.
  const VectorXd& u0 = condensed.free_displacement;
  const NodeArray free = expand(model.unknowns, whole ? VectorXd::Zero(u0.size()) : u0);
  VectorXd movement(rows.rows());
  movement << contact.gap + opens, there.fresh_gap, contact.slip;
  movement -= rows * (displacement - Eigen::Map<const VectorXd>(free.data(), free.size()));
  QuadraticProgramme with;
  with.load = model.programme.load;
  with.A = -free_columns(rows, model.unknowns);
  if (whole) {
    with.stiffness = model.programme.stiffness;
    with.initial_gap = movement;
    open_far(opens, displacement, with.initial_gap);
    return solved(with, model.law, contact);
  }
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

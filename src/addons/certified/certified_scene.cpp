#include "addons/certified/certified_scene.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "addons/certified/certified_solve.hpp"
#include "addons/certified/end_words.hpp"
#include "addons/certified/proofs.hpp"
#include "addons/certified/sliding_verdict.hpp"
#include "addons/certified/undetermined.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/systems.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A share of the largest force. Where forces are known better no note is worth reading, for no length, modulus or load
/// was measured so well; a larger share would keep silent about some of the six digits that are printed.
constexpr double known_well = 1e-6;

/// Up to which force a row carries none: a share, which a certificate lets pass, of the largest force and load of the
/// system that it is in; or what rounding of the entries of K makes along its rigid motions, if that is more.
VectorXd no_forces(const Model& model, const PrimalDual& refined) {
  const QuadraticProgramme& programme = model.programme;
  const VectorXd& force = refined.force;
  const double row = static_cast<double>(programme.stiffness.nonZeros()) /
                     static_cast<double>(programme.stiffness.rows());
  const VectorXd rounding =
      row * epsilon * (programme.stiffness.cwiseAbs() * strained(refined).cwiseAbs());
  const auto along = [&](Index mode) {
    const VectorXd shape = model.modes[static_cast<std::size_t>(mode)].shape.cwiseAbs();
    return shape.dot(rounding) / largest(shape);
  };
  std::vector<SystemParts> systems =
      unconnected_systems(programme, model.law, mode_shapes(model.modes));
  if (systems.empty()) systems = {whole_system(programme, static_cast<Index>(model.modes.size()))};
  VectorXd none(force.size());
  for (const SystemParts& parts : systems) {
    double most =
        certificate_tolerance * std::max(largest(VectorXd(force(parts.rows))),
                                         largest(VectorXd(programme.load(parts.unknowns))));
    for (const Index mode : parts.modes) most = std::max(most, along(mode));
    none(parts.rows).setConstant(most);
  }
  return none;
}

/// Says which motions the pairs that ended up closed leave open: how far they go is then one of many answers.
void note_open_motions(const Model& model, const PrimalDual& refined, Solution& solution) {
  if (model.modes.empty() || solution.contact.report.status != SolveStatus::Solved) return;
  const std::vector<ContactStatus> statuses = all_statuses(solution.contact);
  ActiveSet set = active_set(statuses, model.law);
  // A pair that touches without a force holds nothing: it stops a motion one way only. Of forces as small as the
  // tension that a certificate lets pass, nobody knows whether they are any.
  const VectorXd nothing = no_forces(model, refined);
  const auto idle = [&](Index row) {
    const Index pairs = static_cast<Index>(statuses.size());
    const Index gap = row < pairs ? row : model.law.pair[static_cast<std::size_t>(row - pairs)];
    return refined.force(gap) <= nothing(gap);
  };
  set.closed.erase(std::remove_if(set.closed.begin(), set.closed.end(), idle), set.closed.end());
  NodalRows held(static_cast<Index>(set.closed.size()), model.programme.A.cols());
  for (std::size_t k = 0; k < set.closed.size(); ++k)
    held.row(static_cast<Index>(k)) = model.programme.A.row(set.closed[k]);
  for (const std::string& motion : motions_without_contact(held, model.modes))
    solution.notes.push_back(motion +
                             ": load and contact do not determine how far, this is one answer");
}

/// Says which forces could as well be others.
void note_shared_forces(const Model& model, Solution& solution) {
  const PrimalDual& refined = solution.refined;
  Carried all = carried(model.programme, refined, model.law, all_statuses(solution.contact));
  // Gaps and slips are rounded as the positions that they were made of.
  all.rounding.array() += gap_rounding(model.pairs);
  solution.shared = undetermined_forces(all);
  std::string note = shared_forces_in_words(model, solution, known_well * largest(refined.force));
  if (!note.empty()) solution.notes.push_back(std::move(note));
}

}  // namespace

Solution certified_solve(const Model& model, const Condensed& condensed, const Solver& solver,
                         Ledger ledger, const SolverOptions& options) {
  CertifiedSolution end = in_these_units(condensed.problem, [&] {
    return certified_solve(model.programme, condensed_programme(condensed, ledger),
                           mode_shapes(model.modes), solver, options, ledger);
  });
  Solution solution;
  solution.notes = model.notes;
  solution.contact = std::move(end.state);
  solution.certificate = end.certificate;
  const ContactState& contact = solution.contact;
  if (contact.uniqueness == Uniqueness::Doubtful && contact.report.status == SolveStatus::Solved)
    solution.notes.push_back(uniqueness_warning_in_words(model, contact.uniqueness_warning));
  if (contact.report.status == SolveStatus::Solved && end.force_uncertainty.share > known_well)
    solution.notes.push_back(force_uncertainty_in_words(model, end.force_uncertainty));
  if (contact.report.status == SolveStatus::Ray) solution.contact.reason = ray_in_words(model);
  solution.unbounded_direction = unbounded_direction_in_words(model, contact.unbounded_direction);
  if (contact.unbounded_direction.size() > 0 && !model.law.pair.empty() && model.parts.empty())
    solution.limit =
        balanced_share(condensed.problem, VectorXd::Zero(contact.unbounded_direction.size()));
  // Where all is held there are no unknowns, and a solution.
  if (contact.report.status == SolveStatus::Solved || end.solution.displacement.size() > 0) {
    const Ledger::Phase phase(ledger, "recovery");
    note_open_motions(model, end.solution, solution);
    recover(model, std::move(end.solution), solution);
    if (contact.report.status == SolveStatus::Solved) note_shared_forces(model, solution);
    if (contact.report.status == SolveStatus::Solved)
      judge_sliding(
          model, condensed,
          [&] {
            return std::max(known_well * largest(solution.refined.force),
                            largest(no_forces(model, solution.refined)));
          },
          solution);
  }
  solution.ledger = std::move(ledger);
  return solution;
}

void register_certified() { set_solve(certified_solve); }

}  // namespace signorini

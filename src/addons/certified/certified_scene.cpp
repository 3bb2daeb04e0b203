#include "addons/certified/certified_scene.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "addons/certified/certified_solve.hpp"
#include "addons/certified/end_words.hpp"
#include "addons/certified/many_bodies.hpp"
#include "addons/certified/proofs.hpp"
#include "addons/certified/separate.hpp"
#include "addons/certified/working_set.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/problem/systems.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/ways.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

VectorXd no_forces(const Model& model, const PrimalDual& refined, const KnownMatrices& known) {
  const QuadraticProgramme& programme = model.programme;
  const VectorXd& force = refined.force;
  const double row = static_cast<double>(programme.stiffness.nonZeros()) /
                     static_cast<double>(programme.stiffness.rows());
  const VectorXd rounding =
      row * epsilon * (programme.stiffness.cwiseAbs() * strained(refined).cwiseAbs());
  const auto along = [&](Index mode) {
    const Eigen::SparseVector<double> shape = model.modes[at(mode)].shape.cwiseAbs();
    return shape.dot(rounding) / shape.coeffs().maxCoeff();
  };
  std::vector<SystemParts> systems;
  if (!known.connected)
    systems = unconnected_systems(programme, model.law, mode_entries(model.modes));
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

namespace {

/// Says which motions the pairs that ended up closed leave open: how far they go is then one of many answers.
void note_open_motions(const Model& model, const CertifiedSolution& end, const KnownMatrices& known,
                       std::vector<std::string>& notes) {
  if (model.modes.empty()) return;
  // A pair that touches without a force holds nothing: it stops a motion one way only. Of forces as small as the
  // tension that a certificate lets pass, nobody knows whether they are any.
  const VectorXd nothing = no_forces(model, end.solution, known);
  const Index pairs = end.state.force.size();
  std::vector<Index> holding;
  for (const Index row : active_set(end.state.contact_status, model.law).closed) {
    const Index gap = row < pairs ? row : model.law.pair[at(row - pairs)];
    if (end.solution.force(gap) > nothing(gap)) holding.push_back(row);
  }
  const NodalRows held = selected_rows(model.programme.A, holding);
  for (const std::string& motion : motions_without_contact(held, model.modes))
    notes.push_back(motion + ": load and contact do not determine how far, this is one answer");
}

/// Whether a model may come without its compliance.
bool leaves_to_working_set(const Model& model, const Factor& factor) {
  const double operations = factor.operations();
  if (!working_set_pays(model, model.programme.A.rows(), operations)) return false;
  const std::vector<SystemParts> systems = unconnected_systems(model.programme, model.law, {});  // it has no motions
  return systems.empty() || working_set_pays(model, largest_of(systems), operations);
}

/// What is said of a solution before anybody has looked at stresses and displacements.
std::vector<std::string> notes_of(const Model& model, const CertifiedSolution& end,
                                  const KnownMatrices& known) {
  std::vector<std::string> notes = model.notes;
  if (end.state.report.status != SolveStatus::Solved) return notes;
  if (end.state.uniqueness == Uniqueness::Doubtful)
    notes.push_back(uniqueness_warning_in_words(model, end.state.uniqueness_warning));
  if (end.force_uncertainty.share > known_well)
    notes.push_back(force_uncertainty_in_words(model, end.force_uncertainty));
  note_open_motions(model, end, known, notes);
  return notes;
}

}  // namespace

Solution certified_solve(const Model& model, const Condensed& condensed, const Solver& solver,
                         Ledger ledger, const SolverOptions& options) {
  std::optional<CertifiedSolution> few;
  if (!is_complete(condensed)) {
    const bool whole = solved_whole(model);  // a method that does not take many bodies wants its compliance
    if (whole && many_bodies(static_cast<Index>(model.modes.size()), solver, options))
      few = whole_solution(model, condensed, ledger);
    if (!whole) few = working_set_solution(model, condensed, solver, options, ledger);
    if (!few) {
      const Condensed all = completed(model, condensed, ledger);
      return certified_solve(model, all, solver, std::move(ledger), options);
    }
  }
  KnownMatrices found;
  const bool known = few || condensed.known.diagonal.size() > 0;
  if (!known)
    found.connected = unconnected_systems(model.programme, model.law, {}, epsilon).empty();
  const KnownMatrices& matrices = known ? condensed.known : found;
  const auto solve_all = [&] {
    CondensedProgramme programme = condensed_programme(condensed, ledger);
    programme.known = &matrices;
    return certified_solve(model.programme, programme, mode_shapes(model.modes), solver, options, ledger);
  };
  CertifiedSolution end = few ? std::move(*few) : in_these_units(condensed.problem, solve_all);
  std::vector<std::string> notes = notes_of(model, end, matrices);
  if (end.state.report.status == SolveStatus::Ray) end.state.reason = ray_in_words(model);
  if (end.state.report.status == SolveStatus::Infeasible && end.state.reason.empty())
    end.state.reason = contradiction_in_words(model, end.state.farkas_certificate);
  Solution solution =
      recovered(model, condensed, std::move(end), std::move(notes), std::move(ledger));
  const VectorXd& away = solution.contact.unbounded_direction;
  solution.unbounded_direction = joined(in_words(model.modes, away), "; ");
  if (away.size() > 0 && !model.law.pair.empty() && model.parts.empty())
    solution.limit = balanced_share(condensed.problem, VectorXd::Zero(away.size()));
  return solution;
}

void register_certified() {
  set_solve(certified_solve, [](const Model& model, const Factor& factor) {
    return solved_whole(model) || leaves_to_working_set(model, factor);
  });
}

}  // namespace signorini

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "addons/certified/certified_solve.hpp"
#include "addons/certified/end_words.hpp"
#include "addons/certified/proofs.hpp"
#include "addons/certified/undetermined.hpp"
#include "addons/checks/fit_warnings.hpp"
#include "addons/checks/warnings.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/problem/systems.hpp"
#include "signorini/scene/balance.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/scene/sliding_verdict.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::string describe_unknown(const Model& model, Index unknown) {
  std::size_t b = model.bodies.size() - 1;
  while (model.bodies[b].first_unknown > unknown) --b;
  const BodyModel& body = model.bodies[b];
  return text("body '", body.mesh.name, "', ",
              body.unknowns.describe(body.mesh, unknown - body.first_unknown));
}

/// K, and one spring per rigid mode, which alone hold the bodies. In balance they carry nothing, so their size is free.
Factor factor(const Model& model, Ledger& ledger) {
  const Ledger::Phase phase(ledger, "factor");
  const Stiffness K{
      model.programme.stiffness, model.programme.A, [&model] { return unknown_positions(model); },
      [&model](Index unknown) { return describe_unknown(model, unknown); }, grounding(model.modes)};
  return model.backend.factor(K, ledger);
}

std::vector<NodeArray> displacements_of_bodies(const Model& model, const VectorXd& displacement) {
  const NodeArray all = expand(model.unknowns, displacement);
  std::vector<NodeArray> bodies;
  for (const BodyModel& body : model.bodies)
    bodies.emplace_back(all.middleRows(body.first_node, body.mesh.n_nodes()));
  return bodies;
}

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

/// What the road found, as readers want it.
void recover(const Model& model, PrimalDual refined, Solution& solution) {
  note_open_motions(model, refined, solution);
  solution.pressure = solution.contact.force.cwiseQuotient(model.pairs.weight);
  solution.certificate.balance = imbalance(model, solution.contact, refined.force);
  solution.displacements = displacements_of_bodies(model, refined.displacement);
  solution.refined = std::move(refined);
  if (solution.contact.report.status != SolveStatus::Solved) return;
  for (std::string& note : solution_warnings(model, solution))
    solution.notes.push_back(std::move(note));
  note_shared_forces(model, solution);
  for (std::string& note : closed_gap_warnings(model, solution))
    solution.notes.push_back(std::move(note));
}

/// How much of the load would be held.
std::string limit_in_words(const Solution& solution) {
  const std::optional<double>& limit = solution.limit;
  if (!limit) return {};
  if (solution.unbounded_direction.empty())
    return text("Grown from nothing in proportion, ", *limit,
                " of this load is held, and nothing is found beyond");
  if (*limit == 0)
    return "Friction holds no part of this load, however small, because it grows with the load. ";
  return text("Friction holds at most ", *limit, " of this load. ");
}

/// Refuses numbers for which solvers blame their caller: here they are those of the scene.
void check_numbers(const ContactProblem& problem) {
  try {
    check_finite(problem);
  } catch (const std::invalid_argument& error) {
    throw ProblemError(text("the scene cannot be solved in these units: ", error.what(),
                            "; look for a modulus, thickness, load, friction or length that is far "
                            "larger or smaller than the others"));
  }
}

long long one_solve(const Condensed& condensed) {
  return static_cast<long long>(condensed.factor.solve_operations());
}

/// Solves the numbers of a model, with the factor in hand.
CertifiedSolution solved_numbers(const Model& model, const Condensed& condensed,
                                 const Solver& solver, const SolverOptions& options,
                                 Ledger& ledger) {
  const auto counted = [&ledger](double operations, Factor::Solve solve_for) {
    return [&ledger, operations, solve_for = std::move(solve_for)](const VectorXd& load) {
      ledger.count("operations", static_cast<long long>(operations));
      return solve_for(load);
    };
  };
  using Solve = std::function<VectorXd(const VectorXd&)>;
  const CondensedProgramme small{
      condensed.problem, condensed.free_displacement,
      counted(condensed.factor.solve_operations(),
              [&](const Eigen::Ref<const VectorXd>& load) { return condensed.factor.solve(load); }),
      [&](const std::vector<Index>& unknowns) {
        const std::optional<Factor::Part> part = condensed.factor.part(unknowns);
        return part ? Solve(counted(part->solve_operations, part->solve)) : Solve();
      }};
  try {
    return certified_solve(model.programme, small, mode_shapes(model.modes), solver, options,
                           ledger);
  } catch (const std::invalid_argument&) {
    check_numbers(condensed.problem);
    throw;
  }
}

}  // namespace

void move_freely(const Model& model, VectorXd free_displacement, Condensed& condensed) {
  const QuadraticProgramme& programme = model.programme;
  ContactProblem& problem = condensed.problem;
  condensed.free_displacement = std::move(free_displacement);
  const VectorXd free =
      gaps(programme, {condensed.free_displacement, {}, VectorXd::Zero(programme.A.rows())});
  const Index slips = static_cast<Index>(model.law.pair.size());
  problem.free_gap = free.head(free.size() - slips);
  problem.free_slip = free.tail(slips);
  if (!model.modes.empty())
    add_rigid_modes(programme, mode_shapes(model.modes), problem, direction_rounding(model.modes));
}

Condensed condense(const Model& model, Ledger& ledger) {
  Condensed condensed{with_context(model.notes, [&] { return factor(model, ledger); }), {}, {}};
  const Ledger::Phase phase(ledger, "condensation");
  ledger.count("operations of one solve", one_solve(condensed));
  ContactProblem& problem = condensed.problem;
  problem.compliance = condensed.factor.compliance(model.programme.A, ledger);
  ledger.bytes(problem.compliance.size() * static_cast<long long>(sizeof(double)));
  problem.law = model.law;
  ledger.count("operations", one_solve(condensed));
  move_freely(model, condensed.factor.solve(model.programme.load), condensed);
  return condensed;
}

Solution solve(const Model& model, const Condensed& condensed, const Solver& solver, Ledger ledger,
               const SolverOptions& options) {
  CertifiedSolution end = solved_numbers(model, condensed, solver, options, ledger);
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
    recover(model, std::move(end.solution), solution);
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

Solution solve(const Model& model, const Condensed& condensed, Ledger ledger) {
  return solve(model, condensed, model.solver, std::move(ledger));
}

std::string why_unsolved(const Solution& solution) {
  const std::string& reason = solution.contact.reason;
  if (solution.unbounded_direction.empty() && !solution.limit) return reason;
  if (solution.unbounded_direction.empty())
    return text(reason, reason.empty() ? "" : ". ", limit_in_words(solution));
  return text(reason.empty() ? "the load pulls a body away from all it could rest on" : reason,
              ": ", solution.unbounded_direction, ". ", limit_in_words(solution),
              "Turn the load round or add a support");
}

void require_solved(const Solution& solution, const std::string& what) {
  const Report& report = solution.contact.report;
  if (report.status == SolveStatus::Solved) return;
  const std::string reason = why_unsolved(solution);
  if (!solution.unbounded_direction.empty())
    throw NotSolved(with_notes(text(what, " was not solved: ", reason), solution.notes));
  std::string message = text(what, " was not solved: ", to_string(report.status), " after ",
                             report.iterations, " iterations");
  if (!reason.empty()) message += ": " + reason;
  if (std::isfinite(solution.certificate.worst()))
    message += text("; certificate: ", solution.certificate);
  throw NotSolved(with_notes(message, solution.notes));
}

Solution solve(const Scene& scene) {
  require_input(!scene.path, "the scene has load steps: solve_steps() solves it step by step");
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  return solve(model, condensed, std::move(ledger));
}

}  // namespace signorini

#include "addons/certified/certified_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "addons/certified/certified_end.hpp"
#include "addons/certified/expected_end.hpp"
#include "addons/certified/many_bodies.hpp"
#include "addons/certified/separate.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// check_problem() refuses movements and resultants of which the largest is smaller. Smaller ones beside them are rounding.
constexpr double smallest_movement = 0x1p-340;
constexpr double smallest_resultant = 0x1p-170;

/// One pass of the solver after another, each with its claim refined.
class CertifiedSolve {
 public:
  CertifiedSolve(const QuadraticProgramme& programme, const CondensedProgramme& condensed,
                 const MatrixXd& modes, Ledger& ledger)
      : expected_(condensed.expected),
        scaled_(condensed.known != nullptr && condensed.known->scaled
                    ? condensed.known->scaled
                    : std::make_shared<ScaledProblem>()),
        sets_{{programme, condensed.solve_stiffness, condensed.problem, *scaled_, modes, {}, condensed.known},
              ledger,
              end_,
              {{condensed.free_displacement, {}, VectorXd::Zero(programme.initial_gap.size())},
               VectorXd::Zero(modes.cols())}} {}

  CertifiedSolution run(const Solver& solver, const SolverOptions& options);

 private:
  /// Refines a claim and changes pairs while fewer and fewer are wrong. \return whether this was the last pass: all signs are
  /// right, or no new set is asked for
  bool settle(const ContactState& claim);
  /// Refines a set, and those that it asks for. \return as above
  bool exchange(std::vector<ContactStatus> statuses, VectorXd force);
  /// Puts the movements that displacements give in the place of those that the condensed data gave, and what
  /// K u, which should do no work along rigid motions, does there in the place of the load.
  void correct();
  /// Equilibrates the problem; where it is known, but for its load, no more than that is new.
  void equilibrate_load();
  /// Takes over what a solver says about its run.
  void take_over(const ContactState& claim);

  const PrimalDual* expected_;  // until it was looked at
  std::optional<ContactProblem> corrected_;  // once there is something to correct, pass by pass
  std::shared_ptr<ScaledProblem> scaled_;  // as condensed; a solver has its own
  CertifiedSolution end_;
  RefinedSets sets_;  // before a claim, what the free movements of the corrected problem belong to
  const RefinementData& data_ = sets_.data;  // as it was condensed: refinement knows of corrections
  std::set<std::vector<ContactStatus>> seen_;
};

bool CertifiedSolve::settle(const ContactState& claim) {
  const Ledger::Phase phase(sets_.ledger, "refinement");
  const PrimalDual* const expected = std::exchange(expected_, nullptr);
  if (expected != nullptr && ends_as_expected(claim.contact_status, *expected, sets_)) return true;
  const VectorXd force = all_forces(claim);
  if (data_.null_vectors.cols() == 0 || claim.report.status != SolveStatus::Solved)
    return exchange(claim.contact_status, force);
  // A motion that the closed pairs leave open must begin where the claim has it.
  const bool moves = largest(data_.null_vectors * claim.amplitude) >= smallest_movement;
  const VectorXd amplitude = moves ? claim.amplitude : VectorXd::Zero(data_.null_vectors.cols());
  add_rigid(sets_.here.now, data_.null_vectors, amplitude - sets_.here.amplitude);
  sets_.here.amplitude = amplitude;
  const RefinedSets::Place start = sets_.here;
  const bool settled = exchange(claim.contact_status, force);
  // Of a claim without any force the closed pairs only touch: where closing them exactly takes forces, which
  // are nothing but rounding, none is closed.
  const std::vector<ContactStatus> open = statuses_of({}, data_.condensed.free_gap.size());
  if (!force.isZero(0) || end_.certificate.holds() || !seen_.insert(open).second) return settled;
  sets_.here = start;
  return sets_.refine(open, force).confirmed || settled;
}

bool CertifiedSolve::exchange(std::vector<ContactStatus> statuses, VectorXd force) {
  if (seen_.count(statuses) > 0) return true;
  RefinedSets::Place before;
  for (Index last = data_.condensed.free_gap.size() + 1; seen_.insert(statuses).second;) {
    SignCheck verdict = sets_.refine(statuses, force);
    const bool settles = sets_.here.last.settled;
    if (verdict.confirmed || !sets_.here.now.displacement.allFinite()) return true;
    if (!settles && before.last.settled) sets_.here = before;  // what came before can be corrected
    if (!settles || verdict.wrong == 0 || verdict.wrong >= last) return false;
    last = verdict.wrong;
    statuses = std::move(verdict.statuses);
    force = sets_.here.now.force;
    before = sets_.here;
  }
  return false;
}

void CertifiedSolve::correct() {
  if (!corrected_) corrected_ = data_.condensed;
  const auto& [now, amplitude, last] = sets_.here;
  VectorXd free = last.movement - data_.condensed.compliance * now.force;
  VectorXd terms = last.movement.cwiseAbs() + data_.condensed.compliance.cwiseAbs() * now.force.cwiseAbs();
  if (data_.null_vectors.cols() > 0) {
    free -= data_.condensed.rigid * amplitude;
    terms += data_.condensed.rigid.cwiseAbs() * amplitude.cwiseAbs();
    PrimalDual strained = now;
    strained.force.setZero();
    const VectorXd left = -resultant_left(data_.programme, strained, data_.null_vectors, 0);
    corrected_->resultant = (left.array().abs() >= smallest_resultant).select(left, 0.0);
  }
  // The others are rounding, or of no size that a problem may have.
  free = (free.array().abs() > (epsilon * terms.array()).max(smallest_movement)).select(free, 0.0);
  const Index pairs = data_.condensed.free_gap.size();
  corrected_->free_gap = free.head(pairs);
  corrected_->free_slip = free.tail(free.size() - pairs);
}

void CertifiedSolve::equilibrate_load() {
  const ContactProblem& problem = data_.condensed;
  const bool known = scaled_->scale.size() > 0 && problem.resultant.size() == 0 &&
                     (problem.compliance.diagonal().array() > 0).all();  // else scales depend on it
  if (!known) return void(*scaled_ = equilibrate(problem));
  check_finite(problem, false);
  scaled_->free = scaled_->scale.cwiseProduct(free_movement(problem));
}

void CertifiedSolve::take_over(const ContactState& claim) {
  ContactState& state = end_.state;
  append(state.report, claim.report);
  state.uniqueness = claim.uniqueness;
  state.uniqueness_warning = claim.uniqueness_warning;
  state.reason = claim.reason;
  // What is proved of the corrected problem is not proved of the one that was posed.
  const bool proved = !corrected_ || claim.report.status != SolveStatus::Infeasible;
  state.unbounded_direction = proved ? claim.unbounded_direction : VectorXd();
  state.farkas_certificate = proved ? claim.farkas_certificate : VectorXd();
  if (!proved) state.report.status = SolveStatus::Breakdown;
}

CertifiedSolution CertifiedSolve::run(const Solver& solver, const SolverOptions& options) {
  // Every pass brings a new set, but sets are too many to try: a pass that does not halve the worst figure of
  // the certificate has no successor but one.
  double best = std::numeric_limits<double>::infinity();
  for (int idle = 0; idle < 2; correct()) {
    ContactState claim;
    {
      const Ledger::Phase phase(sets_.ledger, "contact");
      if (!corrected_) equilibrate_load();
      claim = corrected_ ? solve_with_proofs(*corrected_, solver, options)
                         : solve_with_proofs(data_.condensed, solver, options, scaled_.get());
      sets_.ledger.count("iterations", claim.report.iterations);
      sets_.ledger.count("factorisations", claim.report.factorisations);
    }
    take_over(claim);
    if (!usable(claim, data_.condensed.free_gap.size()) || settle(claim)) break;
    if (!sets_.here.last.settled) break;  // nothing to correct the condensed problem with
    const double worst = end_.certificate.worst();
    idle = worst < 0.5 * best ? 0 : idle + 1;
    best = std::min(best, worst);
  }
  conclude(sets_, end_);
  return std::move(end_);
}

}  // namespace

CertifiedSolution certified_solve(const QuadraticProgramme& programme,
                                  const CondensedProgramme& condensed, const MatrixXd& null_vectors,
                                  const Solver& solver, const SolverOptions& options,
                                  Ledger& ledger) {
  const bool connected = condensed.known != nullptr && condensed.known->connected;
  const std::vector<SystemParts> systems =
      connected ? std::vector<SystemParts>()
                : unconnected_systems(programme, condensed.problem.law, null_vectors.sparseView());
  if (!systems.empty())
    return separate_solutions(programme, condensed, null_vectors, systems, solver, options, ledger);
  if (many_bodies(null_vectors.cols(), solver, options))
    if (auto sparse = many_bodies_solution(programme, condensed, null_vectors, options, ledger))
      return std::move(*sparse);
  CertifiedSolution end =
      CertifiedSolve(programme, condensed, null_vectors, ledger).run(solver, options);
  for (Solver (*const next)() : solver.others) {
    const SolveStatus status = end.state.report.status;
    const bool lost = status == SolveStatus::Breakdown || status == SolveStatus::IterationLimit;
    if (!lost || options.iteration_limit > 0) break;
    const Solver member = next();
    if (!takes(member, condensed.problem)) continue;
    CertifiedSolution other =
        CertifiedSolve(programme, condensed, null_vectors, ledger).run(member, options);
    Report both = end.state.report;
    append(both, other.state.report);
    if (other.state.report.status == SolveStatus::Solved)
      end = std::move(other);
    else
      both.status = status;
    end.state.report = std::move(both);
  }
  return end;
}

}  // namespace signorini

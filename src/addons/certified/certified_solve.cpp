#include "addons/certified/certified_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "addons/certified/proofs.hpp"
#include "addons/certified/separate.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// check_problem() refuses smaller movements and resultants.
constexpr double smallest_movement = 0x1p-340;
constexpr double smallest_resultant = 0x1p-170;

/// K u should do no work along rigid motions, but the entries of K are rounded, and somebody must carry the work that it does. Pairs
/// whose force is no larger than that hold nothing. The motions that are free without them take their part out of the residual.
VectorXd spread(const RefinementData& data, const VectorXd& residual, const VectorXd& force,
                const std::vector<Index>& rows) {
  const VectorXd inner = residual - (data.programme.load - data.programme.A.transpose() * force);
  const auto along = [&](const MatrixXd& motions) {
    const MatrixXd Q = column_span(motions).basis;
    return VectorXd(Q * (Q.transpose() * inner));
  };
  const double nothing = along(data.null_vectors).lpNorm<1>();
  std::vector<Index> holding;
  for (const Index row : rows)
    if (std::abs(force(row)) > nothing) holding.push_back(row);
  if (holding.empty()) return residual - along(data.null_vectors);
  const MatrixXd loose = null_space(data.condensed.rigid(holding, Eigen::all));
  return loose.cols() == 0 ? residual : VectorXd(residual - along(data.null_vectors * loose));
}

/// The road, one pass of the solver after another.
class CertifiedSolve {
 public:
  CertifiedSolve(const QuadraticProgramme& programme, const CondensedProgramme& condensed,
                 const MatrixXd& modes, Ledger& ledger)
      : programme_(programme),
        modes_(modes),
        ledger_(ledger),
        problem_(condensed.problem),
        data_{programme, condensed.solve_stiffness, problem_, scaled_, modes},
        now_{condensed.free_displacement, {}, VectorXd::Zero(programme.initial_gap.size())},
        amplitude_(VectorXd::Zero(modes.cols())) {}

  CertifiedSolution run(const Solver& solver, const SolverOptions& options);

 private:
  /// Whether a claim is worth refining.
  [[nodiscard]] bool usable(const ContactState& claim) const;
  /// Refines a claim and changes pairs while fewer and fewer are wrong. \return whether all signs are right,
  /// or nothing new can be tried
  bool settle(const ContactState& claim);
  /// The same for a claim without any force, whose closed pairs only touch: where closing them exactly takes forces, which
  /// are nothing but rounding, none is closed. \return as above
  bool settle_idle(std::vector<ContactStatus> statuses);
  /// Refines a set, and those that it asks for. \return as above
  bool exchange(std::vector<ContactStatus> statuses, VectorXd force);
  /// Says what the pairs do by what they do: a set whose equations depend on each other, or contradict each
  /// other by as little as the certificate allows, need not be that of its numbers.
  void read_off();
  /// Puts the movements that displacements give in the place of those that the condensed data gave, and what
  /// K u, which should do no work along rigid motions, does there in the place of the load.
  void correct();
  /// Takes over what a solver says about its run.
  void take_over(const ContactState& claim);
  /// Fills the end.
  void conclude();
  /// Refines the end once more where the certificate sees what rounding of K leaves along rigid motions.
  void spread_imbalance();
  /// Whether most of what the end lacks of equilibrium is along rigid motions.
  [[nodiscard]] bool rigid_motions_work() const;
  /// Refines one set, beginning with forces, and keeps it if no certificate was better.
  SignCheck look(const std::vector<ContactStatus>& statuses, const VectorXd& force);

  const QuadraticProgramme& programme_;
  const MatrixXd& modes_;
  Ledger& ledger_;
  const ContactProblem& problem_;  // as it was condensed; of corrections refinement knows by itself
  std::optional<ContactProblem> corrected_;  // once there is something to correct, pass by pass
  ScaledProblem scaled_;  // of problem_, from the first refinement on: a solver has its own
  RefinementData data_;
  PrimalDual now_;  // before a claim, what the free movements of the corrected problem belong to
  VectorXd amplitude_;
  RefinedSolution refined_;
  std::set<std::vector<ContactStatus>> seen_;
  CertifiedSolution end_;
  RefinedSolution kept_;                 // of end_: its movement and its system
  std::vector<ContactStatus> statuses_;  // of end_
  bool confirmed_ = false;               // whether all signs of end_ are right
};

bool CertifiedSolve::usable(const ContactState& claim) const {
  const SolveStatus status = claim.report.status;
  return status != SolveStatus::Infeasible && status != SolveStatus::Feasible &&
         claim.unbounded_direction.size() == 0 && claim.force.allFinite() &&
         claim.friction.allFinite() && claim.amplitude.allFinite() &&
         claim.force.size() == problem_.free_gap.size();
}

SignCheck CertifiedSolve::look(const std::vector<ContactStatus>& statuses, const VectorXd& force) {
  refined_ = iterative_refinement(data_, std::move(now_), force, statuses);
  ledger_.count("sets", 1);
  ledger_.count("solves", refined_.solves);
  amplitude_ += refined_.amplitude;
  SignCheck verdict = check_signs(data_, refined_, statuses);
  now_ = std::move(refined_.solution);
  const Certificate certificate = certify(programme_, now_, problem_.law);
  if (verdict.confirmed || !(end_.certificate.worst() <= certificate.worst())) {
    confirmed_ = verdict.confirmed;
    end_.certificate = certificate;
    end_.solution = now_;
    end_.state.amplitude = amplitude_;
    statuses_ = statuses;
    kept_.movement = refined_.movement;
    kept_.system = refined_.system;
  }
  return verdict;
}

void CertifiedSolve::read_off() {
  const std::vector<ContactStatus> taken = statuses_;
  predict(scaled_, scaled_numbers(data_, end_.solution, kept_.movement, certificate_tolerance), 1,
          statuses_);
  // With cohesion a pair that nothing presses carries shear all the same: it is closed.
  const FrictionLaw& law = problem_.law;
  const VectorXd friction = end_.solution.force.tail(law.coefficient.size());
  for (Index k = 0; k < friction.size(); ++k) {
    const auto pair = static_cast<std::size_t>(law.pair[static_cast<std::size_t>(k)]);
    if (statuses_[pair] == ContactStatus::Open && friction(k) != 0) statuses_[pair] = taken[pair];
  }
}

bool CertifiedSolve::settle(const ContactState& claim) {
  const Ledger::Phase phase(ledger_, "refinement");
  if (scaled_.scale.size() == 0) scaled_ = equilibrate(problem_);
  std::vector<ContactStatus> statuses = all_statuses(claim);
  VectorXd force(claim.force.size() + claim.friction.size());
  force << claim.force, claim.friction;
  // A motion that the closed pairs leave open must begin where the claim has it.
  if (modes_.cols() > 0 && claim.report.status == SolveStatus::Solved) {
    const bool moves = largest(modes_ * claim.amplitude) >= smallest_movement;
    const VectorXd amplitude = moves ? claim.amplitude : VectorXd::Zero(amplitude_.size());
    add_rigid(now_, modes_, amplitude - amplitude_);
    amplitude_ = amplitude;
    if (force.isZero(0)) return settle_idle(std::move(statuses));
  }
  return exchange(std::move(statuses), std::move(force));
}

bool CertifiedSolve::settle_idle(std::vector<ContactStatus> statuses) {
  const PrimalDual start = now_;
  const VectorXd amplitude = amplitude_;
  const VectorXd none = VectorXd::Zero(start.force.size());
  const std::vector<ContactStatus> open = statuses_of({}, problem_.free_gap.size());
  const bool settled = exchange(std::move(statuses), none);
  if (end_.certificate.holds() || !seen_.insert(open).second) return settled;
  now_ = start;
  amplitude_ = amplitude;
  return look(open, none).confirmed || settled;
}

bool CertifiedSolve::exchange(std::vector<ContactStatus> statuses, VectorXd force) {
  for (Index last = std::numeric_limits<Index>::max();;) {
    if (!seen_.insert(statuses).second) return last == std::numeric_limits<Index>::max();
    const bool first = last == std::numeric_limits<Index>::max();
    RefinedSolution before = first ? RefinedSolution() : std::move(refined_);
    PrimalDual start = first ? PrimalDual() : now_;
    const VectorXd amplitude = amplitude_;
    SignCheck verdict = look(statuses, force);
    if (verdict.confirmed || !now_.displacement.allFinite()) return true;
    if (!refined_.settled && before.settled) {  // what came before can be corrected
      refined_ = std::move(before);
      now_ = std::move(start);
      amplitude_ = amplitude;
      return false;
    }
    if (!refined_.settled || verdict.wrong == 0 || verdict.wrong >= last) return false;
    last = verdict.wrong;
    statuses = std::move(verdict.statuses);
    force = now_.force;
  }
}

void CertifiedSolve::correct() {
  if (!corrected_) corrected_ = problem_;
  VectorXd free = refined_.movement - problem_.compliance * now_.force;
  VectorXd terms =
      refined_.movement.cwiseAbs() + problem_.compliance.cwiseAbs() * now_.force.cwiseAbs();
  if (modes_.cols() > 0) {
    free -= problem_.rigid * amplitude_;
    terms += problem_.rigid.cwiseAbs() * amplitude_.cwiseAbs();
    PrimalDual strained = now_;
    strained.force.setZero();
    const VectorXd left = -resultant_left(programme_, strained, modes_, 0);
    corrected_->resultant = (left.array().abs() >= smallest_resultant).select(left, 0.0);
  }
  // The others are rounding, or of no size that a problem may have.
  free = (free.array().abs() > (epsilon * terms.array()).max(smallest_movement)).select(free, 0.0);
  const Index pairs = problem_.free_gap.size();
  corrected_->free_gap = free.head(pairs);
  corrected_->free_slip = free.tail(free.size() - pairs);
}

void CertifiedSolve::take_over(const ContactState& claim) {
  ContactState& state = end_.state;
  append(state.report, claim.report);
  state.uniqueness = claim.uniqueness;
  state.uniqueness_warning = claim.uniqueness_warning;
  state.reason = claim.reason;
  state.unbounded_direction = claim.unbounded_direction;
  state.farkas_certificate = claim.farkas_certificate;
  // What is proved of the corrected problem is not proved of the one that was posed.
  if (corrected_ && claim.report.status == SolveStatus::Infeasible) {
    state.report.status = SolveStatus::Breakdown;
    state.unbounded_direction.resize(0);
    state.farkas_certificate.resize(0);
  }
}

CertifiedSolution CertifiedSolve::run(const Solver& solver, const SolverOptions& options) {
  // Every pass brings a new set, but sets are too many to try: a pass that does not halve the worst figure of
  // the certificate has no successor but one.
  double best = std::numeric_limits<double>::infinity();
  for (int idle = 0; idle < 2;) {
    ContactState claim;
    {
      const Ledger::Phase phase(ledger_, "contact");
      claim = solve_with_proofs(corrected_ ? *corrected_ : problem_, solver, options);
      ledger_.count("iterations", claim.report.iterations);
      ledger_.count("factorisations", claim.report.factorisations);
    }
    take_over(claim);
    if (!usable(claim)) break;
    if (settle(claim)) break;
    if (!refined_.settled) break;  // nothing to correct the condensed problem with
    const double worst = end_.certificate.worst();
    idle = worst < 0.5 * best ? 0 : idle + 1;
    best = std::min(best, worst);
    correct();
  }
  conclude();
  return std::move(end_);
}

void CertifiedSolve::spread_imbalance() {
  if (end_.certificate.holds() || modes_.cols() == 0 || end_.solution.displacement.size() == 0)
    return;
  data_.spread = [&](const VectorXd& residual, const VectorXd& force,
                     const std::vector<Index>& rows) {
    return spread(data_, residual, force, rows);
  };
  now_ = end_.solution;
  look(statuses_, end_.solution.force);
}

bool CertifiedSolve::rigid_motions_work() const {
  Certificate others = end_.certificate;
  others.equilibrium = others.duality_gap = 0;
  if (modes_.cols() == 0 || !others.holds()) return false;
  const MatrixXd Q = column_span(modes_).basis;
  const VectorXd left = equilibrium_residual(programme_, end_.solution);
  return largest(Q * (Q.transpose() * left)) > 0.5 * largest(left);
}

void CertifiedSolve::conclude() {
  spread_imbalance();
  ContactState& state = end_.state;
  if (end_.certificate.holds()) {
    if (!confirmed_) read_off();
    drop_tension(programme_, problem_.law, end_);
    end_.force_uncertainty = force_uncertainty(data_, kept_, end_.solution, statuses_);
    state.report.status = SolveStatus::Solved;
    state.reason.clear();
    state.unbounded_direction.resize(0);
    state.farkas_certificate.resize(0);
  } else if (state.farkas_certificate.size() > 0 &&
             !proves_infeasible(programme_, state.farkas_certificate, now_.displacement)) {
    state.report.status = SolveStatus::Breakdown;
    state.farkas_certificate.resize(0);
  } else if (state.report.status == SolveStatus::Solved) {
    state.report.status = SolveStatus::Breakdown;
    state.reason =
        rigid_motions_work()
            ? "rounding of the stiffness pushes along rigid motions, by more of the load than a "
              "certificate allows; hold the bodies by a support or a soft spring"
            : "the forces and displacements found do not fit the original data";
  }
  if (state.report.status == SolveStatus::Breakdown && state.reason.empty())
    state.reason =
        "the method ended without a solution, and what the pairs did last does not fit the data";
  if (statuses_.empty() && kept_.movement.size() == 0) return;
  fill_state(problem_.law, statuses_, end_.solution.force, kept_.movement, state);
}

}  // namespace

CertifiedSolution certified_solve(const QuadraticProgramme& programme,
                                  const CondensedProgramme& condensed, const MatrixXd& null_vectors,
                                  const Solver& solver, const SolverOptions& options,
                                  Ledger& ledger) {
  const std::vector<SystemParts> systems =
      unconnected_systems(programme, condensed.problem.law, null_vectors);
  if (!systems.empty())
    return separate_solutions(programme, condensed, null_vectors, systems, solver, options, ledger);
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

#include "signorini/scene/certified_road.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/report_sum.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/solvers/friction_solvers.hpp"
#include "signorini/solvers/solvers.hpp"
#include "signorini/solvers/springs.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What a solver of the condensed problem says.
struct Claim {
  VectorXd force;  // of all rows
  VectorXd amplitude;
  std::vector<Motion> motions;
  Report report;
  Uniqueness uniqueness = Uniqueness::Unknown;
  std::string reason;
  VectorXd escape;
  VectorXd infeasibility;
};

/// The condensed problem, whichever it is, and how to ask it.
class Asked {
 public:
  Asked(const Condensed& condensed, const std::string& solver) {
    if (condensed.friction) {
      friction_ = *condensed.friction;
      friction_solver_ = &find_friction_solver(solver);
    } else {
      floating_ = {condensed.problem, condensed.rigid, condensed.resultant};
      solver_ = &find_solver(solver);
    }
  }
  [[nodiscard]] const MatrixXd& compliance() const {
    return friction_solver_ != nullptr ? friction_.compliance : floating_.contact.compliance;
  }
  [[nodiscard]] Claim claim() const {
    return friction_solver_ != nullptr ? with_friction() : without_friction();
  }
  /// Puts the movements that displacements give in the place of those that the condensed data gave, and what
  /// K u, which should do no work along rigid motions, does there in the place of the load.
  void correct(const Refinement& refined, const VectorXd& amplitude, const VectorXd& resultant);

 private:
  [[nodiscard]] Claim with_friction() const;
  [[nodiscard]] Claim without_friction() const;

  FrictionProblem friction_;
  FloatingProblem floating_;
  const FrictionSolver* friction_solver_ = nullptr;
  const Solver* solver_ = nullptr;
};

Claim Asked::with_friction() const {
  FrictionState state = friction_solver_->solve(friction_, {});
  Claim claim;
  claim.force.resize(2 * state.force.size());
  claim.force << state.force, state.friction;
  claim.amplitude = std::move(state.amplitude);
  for (Index i = 0; i < state.force.size(); ++i) {
    const PairStatus status = state.status[static_cast<std::size_t>(i)];
    const bool forward = state.friction(i) < 0 || (state.friction(i) == 0 && state.slip(i) >= 0);
    claim.motions.push_back(status == PairStatus::Open    ? Motion::Open
                            : status == PairStatus::Stick ? Motion::Stick
                            : forward                     ? Motion::Forward
                                                          : Motion::Backward);
  }
  claim.report = std::move(state.report);
  claim.uniqueness = state.uniqueness;
  claim.reason = std::move(state.reason);
  claim.escape = std::move(state.escape);
  return claim;
}

Claim Asked::without_friction() const {
  FloatingState state;
  if (floating_.rigid.cols() > 0)
    state = solve(floating_, *solver_);
  else
    state.contact = solver_->solve(floating_.contact, {});
  Claim claim;
  claim.force = std::move(state.contact.force);
  claim.amplitude = std::move(state.amplitude);
  claim.motions.assign(static_cast<std::size_t>(claim.force.size()), Motion::Open);
  for (const Index i : state.contact.active)
    claim.motions[static_cast<std::size_t>(i)] = Motion::Stick;
  claim.report = std::move(state.contact.report);
  claim.escape = std::move(state.escape);
  claim.infeasibility = std::move(state.contact.infeasibility);
  return claim;
}

void Asked::correct(const Refinement& refined, const VectorXd& amplitude,
                    const VectorXd& resultant) {
  VectorXd free = refined.movement - compliance() * refined.solution.force;
  const MatrixXd& rigid = friction_solver_ != nullptr ? friction_.rigid : floating_.rigid;
  if (rigid.cols() > 0) free -= rigid * amplitude;
  if (friction_solver_ != nullptr) {
    const Index pairs = friction_.coefficient.size();
    friction_.free_gap = free.head(pairs);
    friction_.free_slip = free.tail(pairs);
    friction_.resultant = resultant;
  } else {
    floating_.contact.free_gap = free;
    floating_.resultant = resultant;
  }
}

/// The road, one pass of the solver after another.
class Road {
 public:
  Road(const Model& model, const Condensed& condensed, const std::string& solver, Ledger& ledger)
      : model_(model),
        condensed_(condensed),
        ledger_(ledger),
        asked_(condensed, solver),
        modes_(mode_shapes(model.modes)),
        now_{condensed.free_displacement, {}, {}},
        amplitude_(VectorXd::Zero(modes_.cols())) {}

  CertifiedEnd run();

 private:
  /// Whether a claim is worth refining.
  [[nodiscard]] bool usable(const Claim& claim) const;
  /// Refines a claim and changes pairs while fewer and fewer are wrong. \return whether all signs are right,
  /// or nothing new can be tried
  bool settle(std::vector<Motion> motions);
  /// Says what the pairs do by what they do: a set whose equations depend on each other, or contradict each
  /// other by as little as the certificate allows, need not be that of its numbers.
  void read_off();
  /// \return what rigid motions feel of load and strains `n_r`, without contact
  [[nodiscard]] VectorXd left_along_motions() const;
  /// Refines one set and keeps it if no certificate was better.
  Judgement look(const std::vector<Motion>& motions);

  const Model& model_;
  const Condensed& condensed_;
  Ledger& ledger_;
  Asked asked_;
  MatrixXd modes_;
  PrimalDual now_;
  VectorXd amplitude_;
  Refinement refined_;
  std::set<std::vector<Motion>> seen_;
  CertifiedEnd end_;
  bool confirmed_ = false;  // whether all signs of end_ are right
};

bool Road::usable(const Claim& claim) const {
  const Status status = claim.report.status;
  return status != Status::Infeasible && status != Status::Feasible && claim.escape.size() == 0 &&
         claim.force.allFinite() && claim.amplitude.allFinite() &&
         claim.motions.size() == static_cast<std::size_t>(model_.pairs.weight.size());
}

Judgement Road::look(const std::vector<Motion>& motions) {
  const auto solve_stiffness = [&](const VectorXd& load) { return condensed_.factor.solve(load); };
  refined_ = refine(model_.programme, solve_stiffness, asked_.compliance(), now_,
                    known_set(motions, model_.law), modes_);
  ledger_.count("sets", 1);
  ledger_.count("solves", refined_.solves);
  now_ = refined_.solution;
  amplitude_ += refined_.amplitude;
  Judgement verdict = judge(model_.programme, model_.law, refined_, motions, modes_);
  const Certificate certificate = certify(model_.programme, now_, model_.law);
  if (verdict.confirmed || !(end_.certificate.worst() <= certificate.worst())) {
    confirmed_ = verdict.confirmed;
    end_.certificate = certificate;
    end_.solution = now_;
    end_.movement = refined_.movement;
    end_.amplitude = amplitude_;
    end_.motions = motions;
  }
  return verdict;
}

void Road::read_off() {
  const double small = 1e-12;  // what a certificate lets pass
  const double small_force = small * largest(end_.solution.force);
  const double small_length = small * largest(end_.solution.displacement);
  const Index pairs = static_cast<Index>(end_.motions.size());
  for (Index i = 0; i < pairs; ++i)
    if (end_.movement(i) > small_length && end_.solution.force(i) <= small_force)
      end_.motions[static_cast<std::size_t>(i)] = Motion::Open;
    else if (end_.motions[static_cast<std::size_t>(i)] == Motion::Open)
      end_.motions[static_cast<std::size_t>(i)] = Motion::Stick;
  for (std::size_t k = 0; k < model_.law.pair.size(); ++k) {
    Motion& motion = end_.motions[static_cast<std::size_t>(model_.law.pair[k])];
    const double slip = end_.movement(pairs + static_cast<Index>(k));
    if (motion != Motion::Open && std::abs(slip) > small_length)
      motion = slip > 0 ? Motion::Forward : Motion::Backward;
  }
}

bool Road::settle(std::vector<Motion> motions) {
  const Ledger::Phase phase(ledger_, "refinement");
  for (Index last = std::numeric_limits<Index>::max();;) {
    if (!seen_.insert(motions).second) return last == std::numeric_limits<Index>::max();
    Judgement verdict = look(motions);
    if (verdict.confirmed || !now_.displacement.allFinite()) return true;
    if (!refined_.settled || verdict.wrong == 0 || verdict.wrong >= last) return false;
    last = verdict.wrong;
    motions = std::move(verdict.motions);
  }
}

VectorXd Road::left_along_motions() const {
  if (modes_.cols() == 0) return {};
  PrimalDual strained = now_;
  strained.force.setZero();
  return -modes_.transpose() * equilibrium_residual(model_.programme, strained);
}

CertifiedEnd Road::run() {
  // Every pass brings a new set, but sets are too many to try: a pass that does not halve the worst figure of
  // the certificate has no successor but one.
  double best = std::numeric_limits<double>::infinity();
  bool corrected = false;
  for (int idle = 0; idle < 2; corrected = true) {
    Claim claim;
    {
      const Ledger::Phase phase(ledger_, "contact");
      claim = asked_.claim();
    }
    append(end_.report, claim.report);
    end_.uniqueness = claim.uniqueness;
    end_.reason = claim.reason;
    end_.escape = claim.escape;
    end_.infeasibility = claim.infeasibility;
    if (!usable(claim)) {
      // What is proved of the corrected problem is not proved of the one that was posed.
      if (corrected && claim.report.status == Status::Infeasible) {
        end_.report.status = Status::Breakdown;
        end_.escape.resize(0);
        end_.infeasibility.resize(0);
      }
      break;
    }
    now_.force = claim.force;
    if (modes_.cols() > 0 && claim.report.status == Status::Solved) {
      add_rigid(now_, modes_ * (claim.amplitude - amplitude_));
      amplitude_ = claim.amplitude;
    }
    if (settle(std::move(claim.motions))) break;
    if (!refined_.settled) break;  // nothing to correct the condensed problem with
    const double worst = end_.certificate.worst();
    idle = worst < 0.5 * best ? 0 : idle + 1;
    best = std::min(best, worst);
    asked_.correct(refined_, amplitude_, left_along_motions());
  }
  if (end_.certificate.holds()) {
    if (!confirmed_) read_off();
    end_.report.status = Status::Solved;
    end_.reason.clear();
    end_.escape.resize(0);
    end_.infeasibility.resize(0);
  } else if (end_.report.status == Status::Solved) {
    end_.report.status = Status::Breakdown;
    end_.reason = "the forces and displacements found do not fit the original data";
  }
  return std::move(end_);
}

}  // namespace

CertifiedEnd certified_end(const Model& model, const Condensed& condensed,
                           const std::string& solver, Ledger& ledger) {
  return Road(model, condensed, solver, ledger).run();
}

}  // namespace signorini

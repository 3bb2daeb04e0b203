#include "signorini/solvers/refined_solve.hpp"

#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Pairs change so often after a claim.
constexpr int most_changes = 3;

/// Whether a claim has numbers to begin with.
bool usable(const ContactState& claim, Index pairs) {
  const SolveStatus status = claim.report.status;
  return status != SolveStatus::Infeasible && status != SolveStatus::Feasible &&
         claim.force.size() == pairs && claim.force.allFinite() && claim.friction.allFinite() &&
         claim.amplitude.allFinite();
}

/// Refines a claim, and the sets that it asks for; the best certificate counts.
void refine(const RefinementData& data, const VectorXd& free_displacement, Ledger& ledger,
            RefinedEnd& end) {
  const Ledger::Phase phase(ledger, "refinement");
  const FrictionLaw& law = data.condensed.law;
  std::vector<ContactStatus> statuses = all_statuses(end.state);
  VectorXd force(end.state.force.size() + end.state.friction.size());
  force << end.state.force, end.state.friction;
  VectorXd amplitude = VectorXd::Zero(data.null_vectors.cols());
  PrimalDual now{free_displacement, {}, VectorXd::Zero(force.size())};
  // A motion that the closed pairs leave open must begin where the claim has it.
  if (amplitude.size() > 0 && end.state.report.status == SolveStatus::Solved) {
    amplitude = end.state.amplitude;
    add_rigid(now, data.null_vectors, amplitude);
  }
  for (int change = 0; change <= most_changes; ++change) {
    RefinedSolution refined = iterative_refinement(data, std::move(now), force, statuses);
    ledger.count("sets", 1);
    ledger.count("solves", refined.solves);
    amplitude += refined.amplitude;
    const SignCheck signs = check_signs(data, refined, statuses);
    now = std::move(refined.solution);
    force = now.force;
    const Certificate certificate = certify(data.programme, now, law);
    if (signs.confirmed || !(end.certificate.worst() <= certificate.worst())) {
      end.certificate = certificate;
      end.solution = now;
      end.state.amplitude = amplitude;
      fill_state(law, statuses, force, refined.movement, end.state);
    }
    if (signs.wrong == 0 || !refined.settled || end.certificate.holds()) break;
    statuses = signs.statuses;
  }
}

/// What one member has to say, and what refinement makes of it.
RefinedEnd claimed(const RefinementData& data, const CondensedProgramme& condensed,
                   const Solver& member, const SolverOptions& options, Ledger& ledger) {
  RefinedEnd end;
  {
    const Ledger::Phase phase(ledger, "contact");
    end.state = solve(condensed.problem, member.before({}), options);
    ledger.count("iterations", end.state.report.iterations);
    ledger.count("factorisations", end.state.report.factorisations);
  }
  if (!usable(end.state, condensed.problem.free_gap.size())) return end;
  refine(data, condensed.free_displacement, ledger, end);
  SolveStatus& status = end.state.report.status;
  if (end.certificate.holds()) {
    status = SolveStatus::Solved;
    drop_tension(data.programme, data.condensed.law, end);
  } else if (status == SolveStatus::Solved) {
    status = SolveStatus::Breakdown;
  }
  if (status == SolveStatus::Solved)
    end.state.reason.clear();
  else if (end.state.reason.empty())
    end.state.reason = "the forces and displacements found do not fit the original data";
  return end;
}

}  // namespace

void fill_state(const FrictionLaw& law, const std::vector<ContactStatus>& statuses,
                const VectorXd& force, const VectorXd& movement, ContactState& state) {
  const Index slips = static_cast<Index>(law.pair.size());
  const Index pairs = force.size() - slips;
  state.force = force.head(pairs);
  state.friction = force.tail(slips);
  state.gap = movement.head(pairs);
  state.slip = movement.tail(slips);
  state.active = closed_pairs(statuses);
  state.frictional_pairs = law.pair;
  state.contact_status.clear();
  for (const Index pair : law.pair) state.contact_status.push_back(statuses[at(pair)]);
  name_slides(law, state);
}

void drop_tension(const QuadraticProgramme& programme, const FrictionLaw& law, RefinedEnd& end) {
  const Index pairs = end.solution.force.size() - static_cast<Index>(law.pair.size());
  PrimalDual pressing = end.solution;
  pressing.force.head(pairs) = pressing.force.head(pairs).cwiseMax(0.0);
  if (pressing.force == end.solution.force) return;
  const Certificate certificate = certify(programme, pressing, law);
  if (!certificate.holds()) return;
  end.solution = std::move(pressing);
  end.certificate = certificate;
  end.state.force = end.solution.force.head(pairs);
}

RefinedEnd refined_solve(const QuadraticProgramme& programme, const CondensedProgramme& condensed,
                         const MatrixXd& null_vectors, const Solver& solver,
                         const SolverOptions& options, Ledger& ledger) {
  const ScaledProblem scaled = equilibrate(condensed.problem);
  const RefinementData data{programme, condensed.solve_stiffness, condensed.problem, scaled,
                            null_vectors};
  RefinedEnd end = claimed(data, condensed, solver, options, ledger);
  for (Solver (*const next)() : solver.others) {
    if (!lost(end.state) || options.iteration_limit > 0) break;
    const Solver member = next();
    if (!takes(member, condensed.problem)) continue;
    RefinedEnd other = claimed(data, condensed, member, options, ledger);
    Report both = end.state.report;
    append(both, other.state.report);
    if (!lost(other.state) || other.certificate.worst() < end.certificate.worst())
      end = std::move(other);
    both.status = end.state.report.status;
    end.state.report = std::move(both);
  }
  return end;
}

}  // namespace signorini

// # From a claim to a certified solution
//
// A solver sees the condensed problem: the compliance F and the free gaps d, which were computed
// with a factor of K and rounded. Its forces fit these numbers. The user posed other ones, K, p, A
// and g. A condition number of \f$ 10^8 \f$ can separate the two by half of the digits. So the
// answer of a solver is a *claim*, and three more stages follow.
//
// *Refinement.* What a pair does, its status, is worth more than the digits of its force. The
// statuses of the claim turn the problem into a linear one,
// \f[ Ku + A^Tf = p, \qquad A_Wu = g_W, \f]
// which iterative_refinement() solves. It computes the residuals from the original data in twice the
// working precision.
//
// *Signs.* The refined numbers may show that a pair was on the wrong side: a force of
// \f$ 10^{-9} \f$ of the largest may have had the wrong sign in the condensed problem. Such pairs
// change, and the linear problem is solved again.
//
// *Certificate.* certify() measures all conditions of contact on the original data. If it holds,
// the problem is solved, whoever made the claim.
//
// If it does not hold, the next member of the portfolio makes a claim. Rounding that leads one
// method astray mostly leaves another one alone, because it goes another way.

#include "signorini/solvers/refined_solve.hpp"

#include <utility>

#include "signorini/solvers/portfolio.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Pairs change so often after a claim. Statuses that need more changes than these were not near a
// solution.
constexpr int most_changes = 3;

// Refines a claim, and the sets that it asks for. Each begins with the forces and displacements of
// the one before, so that few sweeps are needed. Refinement that does not settle is not tried with
// other statuses.
void refine(const RefinementData& data, const VectorXd& free_displacement, Ledger& ledger,
            RefinedEnd& end) {
  const Ledger::Phase phase(ledger, "refinement");
  std::vector<ContactStatus> statuses = end.state.contact_status;
  VectorXd force = all_forces(end.state);
  PrimalDual untouched{free_displacement, {}, VectorXd::Zero(force.size())};
  const VectorXd none = VectorXd::Zero(data.null_vectors.cols());
  RefinedSets sets{data, ledger, end, {std::move(untouched), none}};
  // A motion that the closed pairs leave open must begin where the claim has it.
  if (data.null_vectors.cols() > 0 && end.state.report.status == SolveStatus::Solved) {
    sets.here.amplitude = end.state.amplitude;
    add_rigid(sets.here.now, data.null_vectors, sets.here.amplitude);
  }
  for (int change = 0; change <= most_changes; ++change) {
    const SignCheck signs = sets.refine(statuses, force);
    if (signs.wrong == 0 || !sets.here.last.settled || end.certificate.holds()) break;
    statuses = signs.statuses;
    force = sets.here.now.force;
  }
  fill_state(data.condensed.law, sets.statuses, end.solution.force, sets.best.movement, end.state);
}

// What one member has to say, and what refinement makes of it. The member is asked alone, without
// those it would ask itself: each claim is to be refined before the next member has to work. A
// claim is promoted if the certificate holds, and withdrawn if it does not.
RefinedEnd claimed(const RefinementData& data, const CondensedProgramme& condensed,
                   const Solver& member, const SolverOptions& options, Ledger& ledger) {
  RefinedEnd end;
  {
    const Ledger::Phase phase(ledger, "contact");
    end.state = solve(condensed.problem, Solver(member).before({}), options);
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

// Whether a claim has numbers to begin with. A proof that nothing solves the problem has none. A
// method that broke down may still have the right statuses of its pairs, and refinement will show
// it.
bool usable(const ContactState& claim, Index pairs) {
  const SolveStatus status = claim.report.status;
  return status != SolveStatus::Infeasible && status != SolveStatus::Feasible &&
         claim.unbounded_direction.size() == 0 && claim.force.size() == pairs &&
         claim.force.allFinite() && claim.friction.allFinite() && claim.amplitude.allFinite();
}

// The second set is not always better than the first. So the end keeps the numbers with the smallest
// worst figure, and a confirmed set replaces them in any case. The first set is kept whatever its
// figures are: they may be infinite, and there must be something to read.
SignCheck RefinedSets::refine(const std::vector<ContactStatus>& of, const VectorXd& force) {
  here.last = iterative_refinement(data, std::move(here.now), force, of);
  return take(of);
}

SignCheck RefinedSets::take(const std::vector<ContactStatus>& of) {
  auto& [now, amplitude, last] = here;
  ledger.count("sets", 1);
  ledger.count("solves", last.solves);
  amplitude += last.amplitude;
  SignCheck signs = check_signs(data, last, of);
  now = std::move(last.solution);
  const Certificate certificate = certify(data.programme, now, data.condensed.law, data.known);
  if (statuses.empty() || signs.confirmed ||
      !(end.certificate.worst() <= certificate.worst())) {
    end.certificate = certificate;
    end.solution = now;
    end.state.amplitude = amplitude;
    statuses = of;
    best.movement = last.movement;
    best.system = last.system;
    confirmed = signs.confirmed;
  }
  return signs;
}

// Refined forces of pairs that hardly press may be negative by rounding. A reader who sees -1e-17
// asks why contact pulls. Such forces become zero if the certificate still holds.
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

// The portfolio once more, on programmes. The end of another member replaces the first if it is an
// answer, or if it is nearer to one. Reports are joined, so that the user sees what was tried.
RefinedEnd refined_solve(const QuadraticProgramme& programme, const CondensedProgramme& condensed,
                         const MatrixXd& null_vectors, const Solver& solver,
                         const SolverOptions& options, Ledger& ledger) {
  const ScaledProblem scaled = equilibrate(condensed.problem);
  const RefinementData data{programme, condensed.solve_stiffness, condensed.problem, scaled,
                            null_vectors, {}, condensed.known};
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

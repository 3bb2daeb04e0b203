// # The augmented Lagrangian for rigid modes
//
// A body that only contact holds has amplitudes a of its free motions as unknowns, and the balance
// of its load as equations,
// \f[ g = d + G\lambda + Ra, \qquad R^T\lambda = r. \f]
// Most methods know no such equations. The remedy of the literature is the *method of multipliers*,
// also called augmented Lagrangian (Rockafellar 1976). Springs of compliance \f$ \rho \f$ hold the
// body at an anchor a. The held problem has \f$ G + \rho RR^T \f$ in the place of G, and any method
// for held bodies solves it. The springs then carry what the contact forces leave, so the anchor
// moves there,
// \f[ a \leftarrow a + \rho\,(R^T\lambda - r), \f]
// and so on until no spring carries anything. A *penalty* method would leave the anchor in place
// and make the springs ever softer, until G is lost in rounding beside \f$ \rho RR^T \f$.
//
// One pair by hand: G = R = 1, d = 1, and the load r = 2 presses. The body first touches at a = -1.
// With \f$ \rho = 1 \f$ and this anchor \f$ \lambda = 1 \f$, half of the load, and the anchor moves
// to -2. The next passes give \f$ \lambda = 1.5 \f$ and 1.75: the error is halved each time. But
// already the first pass says that the pair is closed. So the equations above are solved with that
// pair closed, which gives \f$ \lambda = 2 \f$ and a = -3 at once.

#include "signorini/solvers/augmented_lagrangian.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

constexpr Index most_passes = 100;

// The amplitude at which the body first meets an obstacle on the way that its load pushes it. An
// anchor in free space would cost passes in which no pair closes.
VectorXd first_touch(const ScaledProblem& problem) {
  const VectorXd way = -problem.resultant;
  const VectorXd closing = -problem.rigid * way;
  double far = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < closing.size(); ++i)
    if (closing(i) > epsilon * largest(closing)) far = std::min(far, problem.free(i) / closing(i));
  return far < std::numeric_limits<double>::infinity() ? VectorXd(far * way)
                                                       : VectorXd::Zero(way.size());
}

// Closed pairs, the largest force first. If rows repeat each other, those that carry most are kept.
std::vector<Index> by_force(const ContactState& state) {
  std::vector<Index> pairs = state.active();
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](Index i, Index j) { return state.force(i) > state.force(j); });
  return pairs;
}

// The problem in which springs hold the modes. U has orthonormal columns, so one \f$ \rho \f$ suits
// all motions.
ContactProblem with_penalty(const ScaledProblem& problem, const VectorXd& amplitude, double rho) {
  const auto& U = problem.rigid;
  ContactProblem held{problem.compliance, problem.free};
  held.compliance.noalias() += rho * U * U.transpose();
  held.free_gap += U * (amplitude - rho * problem.resultant);
  return held;
}

}  // namespace

// The passes. Each ends with a guess of the closed pairs, and confirmed() solves their equations,
// without springs. Springs that are too stiff move the anchor slowly: their compliance is doubled
// whenever a pass does not halve what they carry.
//
// If the method for held bodies does not solve its problem, neither is this one solved, and its
// status is handed on. A proof that gaps contradict each other holds without the springs too:
// \f$ (G + \rho RR^T)\,y = 0 \f$ means that Gy and \f$ R^Ty \f$ are zero.
ContactState augmented_lagrangian(const ContactProblem& problem, const HeldSolver& solve_held) {
  const ScaledProblem scaled = equilibrate(problem);
  const Index pairs = scaled.pairs();
  Report report;
  ActiveSetSolution last;
  last.amplitude = first_touch(scaled);
  last.force.setZero(pairs);
  ContactState now;
  const double trace = scaled.compliance.trace();
  double rho = trace > 0 ? trace : 1;
  double last_spring = std::numeric_limits<double>::infinity();
  for (Index passes = 0; passes < most_passes; ++passes) {
    now = solve_held(with_penalty(scaled, last.amplitude, rho));
    append(report, now.report);
    const VectorXd spring = scaled.rigid.transpose() * now.force - scaled.resultant;
    last.amplitude += rho * spring;
    ++report.factorisations;
    if (auto end = confirmed(scaled, by_force(now), &last)) {
      Report solved = report;
      solved.status = SolveStatus::Solved;
      ContactState state = finished(problem, scaled, end->first, end->second, std::move(solved));
      if (state.report.status == SolveStatus::Solved) return state;
    }
    if (report.status != SolveStatus::Solved) break;
    report.status = SolveStatus::IterationLimit;
    if (spring.norm() > 0.5 * last_spring) rho *= 2;
    last_spring = spring.norm();
  }
  if (report.status == SolveStatus::Feasible)
    report.status = SolveStatus::Breakdown;  // springs carry a part
  last.force = now.force;
  last.movement = now.gap;
  VectorXd proof;
  if (now.farkas_certificate.size() > 0) proof = scaled.scale.cwiseProduct(now.farkas_certificate);
  return finished(problem, scaled, last, statuses_of(now.active(), pairs), std::move(report),
                  std::move(proof));
}

}  // namespace signorini

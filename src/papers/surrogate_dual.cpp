// # The surrogate dual
//
// Contact has as many conditions as pairs. Xuan and Li replace them by one, a weighted sum. Weights
// \f$ \xi \ge 0 \f$ with sum 1 say how one total force \f$ \eta \f$ is shared among the pairs,
// \f$ \lambda = \eta\xi \f$. For given weights the best total force is the one that closes the
// weighted gap, and it adds the energy s:
// \f[ \eta = \frac{(b^T\xi)_+}{\xi^T G\xi}, \qquad s(\xi) = \frac12\,\frac{(b^T\xi)_+^2}{\xi^T G\xi}, \f]
// where \f$ b = -d \f$ is the overlap without contact. The weights with the largest s give the
// contact forces.
//
// An example that the pages of this evening share:
// \f[ G = \begin{pmatrix} 2 & 1 \\ 1 & 2 \end{pmatrix}, \quad b = \begin{pmatrix} 7 \\ 5 \end{pmatrix}. \f]
// Equal weights give \f$ \eta = 6/1.5 = 4 \f$ and \f$ s = 12 \f$. The best weights are (3/4, 1/4),
// with \f$ \eta = 4 \f$ and \f$ s = 13 \f$: the forces are (3, 1), and both gaps vanish.
//
// How weights become better is the subject of [weight_iteration.cpp](weight_iteration.cpp). This
// file evaluates s, and ends the iteration with an exact solution.

#include "papers/surrogate_dual.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "papers/long_history.hpp"
#include "papers/weight_iteration.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {
namespace {

using Eigen::Index;

void check_sizes(const char* function, const ContactProblem& problem,
                 const Eigen::VectorXd& weights) {
  const Index n = problem.free_gap.size();
  require_argument(
      problem.compliance.rows() == n && problem.compliance.cols() == n && weights.size() == n,
      function, ": G, d and weights must belong to the same pairs, got G ",
      problem.compliance.rows(), " x ", problem.compliance.cols(), ", d ", n, ", weights ",
      weights.size());
}

// Pairs in use whose force exceeds their gap, the largest force first.
// Weights come near their limit and do not arrive. Which of them are zero is usually settled
// earlier. So the iteration is asked for a set of closed pairs only, and the set is then solved
// exactly.
std::vector<Index> guess(const WeightIteration& run) {
  std::vector<Index> closed;
  for (Index i = 0; i < run.weights().size(); ++i)
    if (run.weights()(i) > 0 && run.total_force() * run.weights()(i) > -run.overlap()(i))
      closed.push_back(i);
  std::stable_sort(closed.begin(), closed.end(),
                   [&run](Index i, Index j) { return run.weights()(i) > run.weights()(j); });
  return closed;
}

// Closes the candidates, without those that would have to pull.
// A guess may hold a pair that would have to pull. It is left out, and the others are closed again.
// This ends, because the candidates become fewer.
Confirmed without_tension(const ScaledProblem& scaled, std::vector<Index> candidates) {
  while (true) {
    if (auto found = confirmed(scaled, candidates)) return found;
    const ActiveSetSolution now = solve_active_set(scaled, ActiveSet{candidates});
    const auto pulls = [&now](Index i) { return now.force(i) <= 0; };
    const auto kept = std::remove_if(candidates.begin(), candidates.end(), pulls);
    if (now.rows.size() < candidates.size() || kept == candidates.end()) return std::nullopt;
    candidates.erase(kept, candidates.end());
  }
}

// The history is told in the units of the problem: overlaps are divided by the scale of their row.
Iteration summary(const ScaledProblem& scaled, const WeightIteration& run) {
  const Eigen::VectorXd overlap = run.overlap().cwiseQuotient(scaled.scale);
  return {(run.weights().array() > 0).count(), (overlap.array() > 0).count(),
          std::max(0.0, overlap.maxCoeff()), 0, run.value()};
}

// Whether G y = 0 to rounding, for y of a problem with unit diagonal.
// If \f$ G\xi = 0 \f$, the forces \f$ \xi \f$ move nothing. Then no forces at all change the
// weighted gap, because \f$ \xi^T(d + G\lambda) = \xi^T d \f$. If that is negative, some pair
// overlaps whatever happens: the problem has no solution.
bool is_proof(const ContactProblem& unit, const Eigen::VectorXd& y) {
  const Eigen::VectorXd root = unit.compliance.diagonal().cwiseSqrt();
  const double rounding = 2 * static_cast<double>(y.size()) * epsilon * root.dot(y);
  return ((unit.compliance * y).array().abs() <= rounding * root.array()).all() &&
         unit.free_gap.dot(y) < 0;
}

// The present forces, which are no solution.
// If the iteration ends without a solution, its forces are returned for what they are, with the
// reason as the status.
ContactState unfinished(const ContactProblem& problem, const ScaledProblem& scaled,
                        const WeightIteration& run, Report report) {
  ActiveSetSolution now;
  const double total = std::isfinite(run.total_force()) ? run.total_force() : 0;
  now.force = total * run.weights();
  now.movement = -run.overlap();
  std::vector<Index> active;
  for (Index i = 0; i < now.force.size(); ++i)
    if (now.force(i) > 0) active.push_back(i);
  Eigen::VectorXd proof;
  if (report.status == SolveStatus::Infeasible)
    proof = scaled.scale.cwiseProduct(run.farkas_certificate());
  return finished(problem, scaled, now, statuses_of(active, now.force.size()), std::move(report),
                  std::move(proof));
}

}  // namespace

// What the body stores less the work of its load. Of all displacements that overlap nowhere the
// solution has the least.
double potential_energy(const QuadraticProgramme& programme, const Eigen::VectorXd& displacement) {
  require_argument(displacement.size() == programme.load.size(), "potential_energy: expects ",
                   programme.load.size(), " displacements, got ", displacement.size());
  return displacement.dot(0.5 * (programme.stiffness * displacement) - programme.load);
}

// For any forces \f$ \lambda \ge 0 \f$ the least value of the Lagrangian over u is at most the
// least potential energy. That is why s is to be made large.
double lagrangian(const QuadraticProgramme& programme, const Eigen::VectorXd& displacement,
                  const Eigen::VectorXd& force) {
  require_argument(
      displacement.size() == programme.load.size() && force.size() == programme.initial_gap.size(),
      "lagrangian: expects ", programme.load.size(), " displacements and ",
      programme.initial_gap.size(), " forces, got ", displacement.size(), " and ", force.size());
  const Eigen::VectorXd overlap = programme.A * displacement - programme.initial_gap;
  return potential_energy(programme, displacement) + force.dot(overlap);
}

// Along \f$ \lambda = \eta\xi \f$ the weighted overlap falls in proportion to \f$ \eta \f$, from
// \f$ b^T\xi \f$ by \f$ \eta\,\xi^T G\xi \f$. It vanishes at one \f$ \eta \f$. Weights whose gap is
// open need no force.
double total_contact_force(const ContactProblem& problem, const Eigen::VectorXd& weights) {
  check_sizes("total_contact_force", problem, weights);
  const double overlap = -problem.free_gap.dot(weights);
  return overlap > 0 ? overlap / weights.dot(problem.compliance * weights) : 0;
}

double surrogate_dual_value(const ContactProblem& problem, const Eigen::VectorXd& weights) {
  return -0.5 * problem.free_gap.dot(weights) * total_contact_force(problem, weights);
}

// In the example equal weights leave the overlaps (1, -1), and the gradient is 4 times that: the
// first pair wants more of the force, the second less.
Eigen::VectorXd surrogate_dual_gradient(const ContactProblem& problem,
                                        const Eigen::VectorXd& weights) {
  const double force = total_contact_force(problem, weights);
  return -force * (problem.free_gap + force * (problem.compliance * weights));
}

// A sum with weights \f$ \ge 0 \f$ of positive overlaps is positive: that is why this is enough.
bool all_overlap(const ContactProblem& problem) { return (problem.free_gap.array() < 0).all(); }

// Equal weights are no start if the weighted gap is open: there s is zero, and so is its slope.
// Then only pairs that overlap get a share.
Eigen::VectorXd start_weights(const ContactProblem& problem) {
  const Index n = problem.free_gap.size();
  if (problem.free_gap.sum() < 0) return Eigen::VectorXd::Constant(n, 1 / static_cast<double>(n));
  const Eigen::VectorXd overlaps = (problem.free_gap.array() < 0).cast<double>();
  return overlaps / std::max(1.0, overlaps.sum());
}

// The derivative of s along a line has the sign of \f$ \text{rise} + \text{bend}\; t \f$, which is
// linear in t. If it does not begin above zero, s does not rise. If it does not fall, we go as far
// as the weights stay positive.
double best_step(const WeightLine& line, double largest) {
  const double rise = line.overlap_slope * line.compliance - line.overlap * line.compliance_slope;
  if (rise <= 0) return 0;
  const double bend =
      line.overlap_slope * line.compliance_slope - line.overlap * line.compliance_bend;
  return bend < 0 ? std::min(largest, -rise / bend) : largest;
}

// An exact solution costs a factorisation, a step of the weights does not. So the guess is tried
// after 1, 2, 4, 8, ... steps: at most twice as many steps are made as were needed, and the
// factorisations are few. A guess that was tried before is not tried again.
ContactState surrogate_dual(const ContactProblem& problem, WeightRule rule,
                            const SolverOptions& options) {
  check_plain(problem, "surrogate_dual");
  const ScaledProblem scaled = equilibrate(problem);
  const ContactProblem unit{scaled.compliance, scaled.free};
  const Index n = problem.free_gap.size();
  const Index limit = options.iteration_limit > 0 ? options.iteration_limit : 100 * n + 1000;
  const bool ends_by_itself = rule == WeightRule::FullyCorrective;
  WeightIteration run(unit, rule);
  Report report;
  report.status = SolveStatus::IterationLimit;
  if (n > 0) report.history.push_back(summary(scaled, run));
  std::vector<Index> tried = {-1};
  for (bool moved = true; moved;) {
    const bool close = !ends_by_itself && run.relative_gap() <= options.tolerance;
    moved = !close && report.iterations < limit && run.step();
    const Index k = report.iterations += moved ? 1 : 0;
    if (moved && is_kept(k)) report.history.push_back(summary(scaled, run));
    const bool power_of_two = (k & (k - 1)) == 0;
    if (moved && (!power_of_two || ends_by_itself)) continue;
    std::vector<Index> candidates = guess(run);
    if (moved && candidates == tried) continue;
    tried = std::move(candidates);
    report.factorisations += tried.empty() ? 0 : 1;
    if (const auto found = moved ? confirmed(scaled, tried) : without_tension(scaled, tried)) {
      report.status = SolveStatus::Solved;
      report.factorisations += run.factorisations();
      return finished(problem, scaled, found->first, found->second, std::move(report));
    }
  }
  report.factorisations += run.factorisations();
  if (run.end() == WeightEnd::Unbounded)
    report.status =
        is_proof(unit, run.farkas_certificate()) ? SolveStatus::Infeasible : SolveStatus::Breakdown;
  return unfinished(problem, scaled, run, std::move(report));
}

}  // namespace signorini

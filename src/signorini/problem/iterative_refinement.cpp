// # Refinement of a known set
//
// A factor in doubles solves \f$ Ku = p \f$ with an error of the condition number times rounding. Iterative
// refinement takes it away: the residual of the original data is summed exactly, the factor makes a
// correction of it, and again. Each sweep multiplies the error by the same small number \f$ \rho \f$, for a
// condition number of \f$ 10^8 \f$ about \f$ 10^{-8} \f$, so two sweeps are mostly enough.
//
// With contact there are two residuals and two factors, that of K and that of the active set. One sweep is
//
// \f[ r = p - Ku - A^Tf, \quad u \mathrel{+}= K^{-1}r, \qquad h = g_W - A_Wu, \quad
//     J \begin{pmatrix} \Delta f_W \\ \Delta b \end{pmatrix} = -\begin{pmatrix} h \\ N^Tr \end{pmatrix}, \quad
//     f_W \mathrel{+}= \Delta f_W, \quad u \mathrel{+}= N\Delta b - K^{-1}A^T\Delta f. \f]
//
// The order matters. u comes first: the gaps of a u that does not yet answer its forces have the error of
// \f$ K^{-1} \f$, and forces that close them would be wrong by as much. And u follows the new forces in the
// same sweep, so that no force is left behind which no displacement answers, whichever sweep is the last.
//
// How many sweeps? Let \f$ e_k \f$ be the relative size of the k-th correction. The rate is
// \f$ \rho_k = e_k/e_{k-1} \f$, and the next correction will be about \f$ \rho_k e_k \f$. From
// \f$ e_0 = 1 \f$ and \f$ e_1 = 10^{-9} \f$ follows 1e-18: it would change nothing, and its sweep is saved.

#include "signorini/problem/iterative_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A correction over what it corrected; all of it, if nothing is left.
double relative(const VectorXd& change, const VectorXd& result) {
  const double part = largest(change);
  const double whole = largest(result);
  return whole == 0 && part > 0 ? 1 : ratio(part, whole);
}

// On a slender body the last digit of a force moves the far end by many digits. So forces are sums of
// two doubles: with 1000 N and a lever of 1e6 the second one is worth 1e-7 N m.
struct Forces {
  VectorXd high;
  VectorXd low;
};

// The forces that a set allows. Friction follows the normal force in two doubles as well. All others are
// exactly 0.
Forces imposed(const ActiveSet& set, const Forces& force) {
  Forces kept{VectorXd::Zero(force.high.size()), VectorXd::Zero(force.high.size())};
  kept.high(set.closed) = force.high(set.closed);
  kept.low(set.closed) = force.low(set.closed);
  for (const SlidingPair& pair : set.sliding) {
    ExactSum tau = pair.friction(kept.high(pair.gap), kept.low(pair.gap));
    kept.high(pair.slip) = tau.value();
    tau.add(-kept.high(pair.slip));
    kept.low(pair.slip) = tau.value();
  }
  return kept;
}

// Sweeps whose rigid motion goes into the part of u that strains nothing. That part is rounded, and later
// sweeps mend it; what they move is so small that it may as well strain the bodies.
constexpr Index rigid_sweeps = 2;

// So many corrections in a row may fail to shrink by half: one that is larger than the one before may come
// between two that shrink, where the factor has hardly a digit.
constexpr int most_slow = 3;

// One refinement from beginning to end: what it takes, where it stands, and the steps in the order in which
// they are made.
struct Refinement {
  const RefinementData& data;
  MatrixXd modes;  // orthonormal for contact: N times `inverse`
  ActiveSet set;
  ActiveSetSystem system;
  Forces force;
  RefinedSolution result = {};
  Corrections corrections = {};
  Index sweeps = 0;

  VectorXd push(const VectorXd& load);
  void begin();
  bool felt(const VectorXd& pushed) const;
  void move(const VectorXd& amplitude);
  bool sweep();
};

// u += K^-1 of forces that are out of balance. \return by how much
VectorXd Refinement::push(const VectorXd& load) {
  VectorXd moved = data.solve_stiffness(load);
  ++result.solves;
  add_displacement(result.solution, moved);
  return moved;
}

// u follows the forces that it does not belong to yet, and the springs that ground a body give it back. A u in
// one double was never refined: all of it counts as a correction.
void Refinement::begin() {
  PrimalDual& u = result.solution;
  const bool refined = u.displacement_low.size() > 0;
  if (!refined) u.displacement_low.setZero(u.displacement.size());
  const VectorXd pushed = force.high - u.force;
  if (pushed.isZero(0)) return;
  const VectorXd moved = push(-(data.programme.A.transpose() * pushed));
  if (refined)
    corrections.last = std::max(relative(moved, u.displacement), relative(pushed, force.high));
}

// A solve with K is the dearest part of a sweep. It is left out where forces change by rounding only, and move
// nothing more than that: the last digit of a force may move the far end of a slender body.
bool Refinement::felt(const VectorXd& pushed) const {
  return relative(pushed, force.high) > 0.25 * epsilon ||
         relative(data.condensed.compliance * pushed, result.solution.displacement) >
             0.25 * epsilon;
}

// Adds a rigid motion to u.
//
// The first sweeps move bodies rigidly, and K is not applied to that part of u. A body that forces out of
// balance took far away on its springs came back: K, whose entries are rounded, would strain it by the way,
// once as rigid and once as not. What is left is rigid as far as a motion comes near to it.
void Refinement::move(const VectorXd& amplitude) {
  PrimalDual& u = result.solution;
  result.amplitude += amplitude;
  if (sweeps > rigid_sweeps) return add_displacement(u, data.null_vectors * amplitude);
  add_rigid(u, data.null_vectors, amplitude);
  if (sweeps == rigid_sweeps && largest(u.rigid) > 2 * largest(u.displacement))
    u.rigid = data.null_vectors * least_norm_solution(data.null_vectors, u.displacement);
}

// One sweep, as above. The second part of the forces counts in r by a plain product, which is exact enough.
// `scale` and `inverse` lead to the equilibrated problem, which the system is that of, and back.
//
// While bodies are moved rigidly the next r has what the forces push. From then on u follows at once, and the
// end may be foreseen. Corrections that shrink no more have failed, unless they are rounding of as many
// numbers as there are closed rows. \return whether another sweep is worth its solves
bool Refinement::sweep() {
  PrimalDual& u = result.solution;
  ++sweeps;
  u.force = force.high;
  VectorXd r = equilibrium_residual(data.programme, u) - data.programme.A.transpose() * force.low;
  if (data.spread) r = data.spread(r, force.high + force.low, system.rows);
  VectorXd moved = push(r);
  const VectorXd scale = data.scaled.scale(system.rows);
  const VectorXd h = gaps(data.programme, u)(system.rows);
  const auto [closes, turn] = system.solve(-scale.cwiseProduct(h), -modes.transpose() * r);
  const Forces last = force;
  for (Index k = 0; k < closes.size(); ++k) {
    const Index row = system.rows[at(k)];
    add_to(force.high(row), force.low(row), scale(k) * closes(k));
  }
  force = imposed(set, force);
  const VectorXd pushed = (force.high - last.high) + (force.low - last.low);
  const bool floats = modes.cols() > 0;
  const bool steady = !floats || sweeps > rigid_sweeps;
  if (steady && felt(pushed)) moved += push(-(data.programme.A.transpose() * pushed));
  if (floats) {
    moved += modes * turn;
    move(data.scaled.inverse * turn);
  }
  const double e = std::max(relative(moved, u.displacement), relative(pushed, force.high));
  const bool more = corrections.next(e);
  result.settled = steady && (corrections.foreseen <= 0.25 * epsilon ||
                              (!more && e <= epsilon * static_cast<double>(set.closed.size() + 1)));
  return more && !result.settled;
}

}  // namespace

// The first correction may be much larger than what it corrects, where forces out of balance take a body
// far away. Beside it the next one looks small and is not: so the rate takes no more than 1 for it.
bool Corrections::next(double size) {
  foreseen = std::min(1.0, size / std::min(1.0, last)) * size;
  slow = size <= 0.5 * best ? 0 : slow + 1;
  best = std::min(best, size);
  last = size;
  return std::isfinite(size) && slow < most_slow;
}

// A closed row that nothing can push on, a slip that supports prescribe, keeps no force.
RefinedSolution iterative_refinement(const RefinementData& data, PrimalDual start,
                                     const VectorXd& force,
                                     const std::vector<ContactStatus>& statuses) {
  const Index n = start.displacement.size();
  const bool floats = data.null_vectors.cols() > 0;
  const auto& A = data.programme.A;
  ActiveSet set = active_set(statuses, data.condensed.law);
  const auto empty = [&](Index row) { return A.row(row).norm() == 0; };
  set.closed.erase(std::remove_if(set.closed.begin(), set.closed.end(), empty), set.closed.end());
  const Forces first = imposed(set, {force, VectorXd::Zero(force.size())});
  Refinement now{data, floats ? MatrixXd(data.null_vectors * data.scaled.inverse) : MatrixXd(n, 0),
                 std::move(set),
                 active_set_system(data.scaled, active_set(statuses, data.scaled.law)), first};
  RefinedSolution& result = now.result;
  result.solution = std::move(start);
  result.amplitude.setZero(data.null_vectors.cols());
  now.begin();
  while (now.sweep()) continue;
  result.solution.force = now.force.high;
  result.movement = gaps(data.programme, result.solution);
  result.system = std::make_shared<const ActiveSetSystem>(std::move(now.system));
  return std::move(result);
}

}  // namespace signorini

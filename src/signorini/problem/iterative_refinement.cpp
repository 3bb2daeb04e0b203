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
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Sweeps whose rigid motion goes into the part of u that strains nothing. That part is rounded, and later
// sweeps mend it; what they move is so small that it may as well strain the bodies.
constexpr Index rigid_sweeps = 2;

// Where a refinement stands. On a slender body the last digit of a force moves the far end by many digits. So
// forces are sums of two doubles, of which u has the first: with 1000 N and a lever of 1e6 the second one is
// worth 1e-7 N m.
struct Refinement {
  const RefinementData& data;
  ActiveSet set;
  ActiveSetSystem system;
  MatrixXd modes;  // orthonormal for contact: N times `inverse`
  RefinedSolution result = {};
  VectorXd low = {};
  Corrections corrections = {};
  Index sweeps = 0;

  VectorXd push(const VectorXd& load);
  bool sweep();
};

// u += K^-1 of forces that are out of balance. \return by how much
VectorXd Refinement::push(const VectorXd& load) {
  VectorXd moved = data.solve_stiffness(load);
  ++result.solves;
  add_displacement(result.solution, moved);
  return moved;
}

// One sweep, as above. The second part of the forces counts in r by a plain product, which is exact enough.
// `scale` and `inverse` lead to the equilibrated problem, which the system is that of, and back.
//
// While bodies are moved rigidly the next r has what the forces push. From then on u follows at once, and the
// end may be foreseen. That second solve is left out where forces change by rounding only, and move nothing more
// than that. \return whether another sweep is worth its solves
bool Refinement::sweep() {
  PrimalDual& u = result.solution;
  const auto& A = data.programme.A;
  const bool floats = modes.cols() > 0;
  const bool steady = !floats || ++sweeps > rigid_sweeps;
  VectorXd r = equilibrium_residual(data.programme, u) - A.transpose() * low;
  if (data.spread) r = data.spread(r, u.force + low, system.rows);
  VectorXd moved = push(r);
  const VectorXd scale = data.scaled.scale(system.rows);
  const VectorXd h = gaps(data.programme, u)(system.rows);
  const auto [closes, turn] = system.solve(-scale.cwiseProduct(h), -modes.transpose() * r);
  const VectorXd last = u.force, last_low = low;
  for (Index k = 0; k < closes.size(); ++k)
    add_to(u.force(system.rows[at(k)]), low(system.rows[at(k)]), scale(k) * closes(k));
  impose(set, u.force, low);
  const VectorXd pushed = (u.force - last) + (low - last_low);
  const auto felt = [](double part) { return part > 0.25 * epsilon; };
  if (steady && (felt(relative(pushed, u.force)) ||
                 felt(relative(data.condensed.compliance * pushed, u.displacement))))
    moved += push(-(A.transpose() * pushed));
  if (floats) {
    const VectorXd amplitude = data.scaled.inverse * turn;
    result.amplitude += amplitude;
    moved += modes * turn;
    if (steady) add_displacement(u, data.null_vectors * amplitude);
    if (!steady) add_rigid(u, data.null_vectors, amplitude, sweeps == rigid_sweeps);
  }
  const bool more =
      corrections.next(Corrections::size(moved, u.displacement, pushed, u.force));
  result.settled = steady && corrections.settled(set.closed.size());
  return more && !result.settled;
}

}  // namespace

// A closed row that nothing can push on, a slip that supports prescribe, keeps no force. Before the first sweep u
// follows the forces that it does not belong to yet, and the springs that ground a body give it back. A u in
// one double was never refined: all of it counts as a correction.
RefinedSolution iterative_refinement(const RefinementData& data, PrimalDual start,
                                     const VectorXd& force,
                                     const std::vector<ContactStatus>& statuses) {
  const auto& A = data.programme.A;
  const auto empty = [&](Index row) { return A.row(row).norm() == 0; };
  Refinement now{data, active_set(statuses, data.condensed.law),
                 active_set_system(data.scaled, active_set(statuses, data.scaled.law)),
                 MatrixXd(start.displacement.size(), 0)};
  if (data.null_vectors.cols() > 0) now.modes = data.null_vectors * data.scaled.inverse;
  std::vector<Index>& closed = now.set.closed;
  closed.erase(std::remove_if(closed.begin(), closed.end(), empty), closed.end());
  RefinedSolution& result = now.result;
  result.amplitude.setZero(data.null_vectors.cols());
  PrimalDual& u = result.solution = std::move(start);
  const bool refined = u.displacement_low.size() > 0;
  if (!refined) u.displacement_low.setZero(u.displacement.size());
  const VectorXd last = std::exchange(u.force, force);
  now.low.setZero(force.size());
  impose(now.set, u.force, now.low);
  const VectorXd pushed = u.force - last;
  if (!pushed.isZero(0)) {
    const VectorXd moved = now.push(-(A.transpose() * pushed));
    if (refined) now.corrections.last = Corrections::size(moved, u.displacement, pushed, u.force);
  }
  while (now.sweep()) continue;
  u.force_low = std::move(now.low);
  result.movement = gaps(data.programme, u);
  result.system = std::make_shared<const ActiveSetSystem>(std::move(now.system));
  return std::move(result);
}

}  // namespace signorini

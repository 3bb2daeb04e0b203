// # Refinement of a known set
//
// A factor in doubles solves \f$ Ku = p \f$ with an error of the condition number times rounding. Iterative
// refinement takes it away: the residual of the original data is summed exactly, the factor makes a
// correction of it, and again. Each sweep multiplies the error by the same small number \f$ \rho \f$, for a
// condition number of \f$ 10^8 \f$ about \f$ 10^{-8} \f$, so two sweeps are mostly enough.
//
// With contact there are two residuals, equilibrium and the movements of closed rows, and two factors: that of
// K and that of the active set. A sweep first corrects u, then the forces that close what is left. Then it
// moves u by what these forces move, so that both are consistent again.
//
// The end is foreseen. If a correction is \f$ e_k \f$ and the one before was \f$ e_{k-1} \f$, the next one will
// be about \f$ e_k\,\rho \f$ with \f$ \rho = e_k / e_{k-1} \f$. Where that is below a quarter of the rounding
// of a double, it would change nothing, and the sweep for it is saved.

#include "signorini/problem/iterative_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A correction over what it corrected; all of it, if nothing is left.
double relative(double change, double result) {
  return result == 0 && change > 0 ? 1 : ratio(change, result);
}

// On a slender body the last digit of a force moves the far end by many digits. So forces are sums of
// two doubles.
struct Forces {
  VectorXd high;
  VectorXd low;
};

// Friction follows the normal force in two doubles as well. Forces that the set excludes are exactly 0.
void impose(const ActiveSet& set, Forces& force) {
  std::vector<bool> carries(static_cast<std::size_t>(force.high.size()), false);
  for (const Index row : set.closed) carries[static_cast<std::size_t>(row)] = true;
  for (const SlidingPair& pair : set.sliding) {
    ExactSum tau = pair.friction(force.high(pair.gap), force.low(pair.gap));
    force.high(pair.slip) = tau.value();
    tau.add(-force.high(pair.slip));
    force.low(pair.slip) = tau.value();
    carries[static_cast<std::size_t>(pair.slip)] = true;
  }
  for (Index row = 0; row < force.high.size(); ++row)
    if (!carries[static_cast<std::size_t>(row)]) force.high(row) = force.low(row) = 0;
}

/// Sweeps whose rigid motion goes into the part of u that strains nothing. That part is rounded, and later
/// sweeps mend it; what they move is so small that it may as well strain the bodies.
constexpr Index rigid_sweeps = 2;

/// The set without closed rows that nothing can push on: slips that supports give, where they give none.
ActiveSet felt_rows(ActiveSet set, const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) {
  const auto empty = [&](Index row) { return A.row(row).norm() == 0; };
  set.closed.erase(std::remove_if(set.closed.begin(), set.closed.end(), empty), set.closed.end());
  return set;
}

/// One refinement from beginning to end.
class IterativeRefinement {
 public:
  IterativeRefinement(const RefinementData& data, PrimalDual start, const VectorXd& force,
                      const std::vector<ContactStatus>& statuses)
      : data_(data),
        set_(felt_rows(active_set(statuses, data.condensed.law), data.programme.A)),
        system_(active_set_system(data.scaled, active_set(statuses, data.scaled.law))) {
    PrimalDual& solution = result_.solution;
    solution = std::move(start);
    const Index n = solution.displacement.size();
    // Nobody has refined a u in one double: all of it has the error of the factor.
    if (solution.displacement_low.size() == 0) unrefined_ = largest(solution.displacement);
    if (solution.displacement_low.size() == 0) solution.displacement_low.setZero(n);
    if (floats() && solution.rigid.size() == 0) solution.rigid.setZero(n);
    force_ = {force, VectorXd::Zero(force.size())};
    impose(set_, force_);
    result_.amplitude.setZero(data.null_vectors.cols());
  }

  RefinedSolution run();

 private:
  /// Corrections of one sweep, relative to what they correct.
  struct Change {
    double displacement = 0;
    double force = 0;
    [[nodiscard]] double worst() const { return std::max(displacement, force); }
  };

  [[nodiscard]] VectorXd unbalanced();
  /// Changes of forces and amplitudes that end the movement of closed rows and what rigid motions feel.
  [[nodiscard]] std::pair<VectorXd, VectorXd> closed(const VectorXd& residual) const;
  Change begin();
  Change sweep();
  /// Moves u by what a change of forces moves. \return by how much
  VectorXd push(const VectorXd& pushed);
  /// A residual without what K u in it does along rigid motions.
  [[nodiscard]] VectorXd spread(const VectorXd& residual) const;
  /// Moves bodies rigidly.
  void move(const VectorXd& amplitude);

  /// Whether a change of forces is more than rounding, or moves more than that beside the displacements.
  [[nodiscard]] bool felt(const VectorXd& pushed) const;

  [[nodiscard]] bool floats() const { return data_.null_vectors.cols() > 0; }
  /// Whether this sweep may be the last: the rigid part is not rounded anew.
  [[nodiscard]] bool steady() const { return !floats() || sweeps_ > rigid_sweeps; }

  const RefinementData& data_;
  ActiveSet set_;
  ActiveSetSystem system_;
  Forces force_;
  RefinedSolution result_;
  double unrefined_ = 0;  // of u, where it starts
  Index sweeps_ = 0;
  bool slow_ = false;  // whether a sweep leaves more than the root of rounding
};

// Both parts of the forces count in equilibrium: the second one by a plain product, which is exact enough.
VectorXd IterativeRefinement::unbalanced() {
  result_.solution.force = force_.high;
  return equilibrium_residual(data_.programme, result_.solution) -
         data_.programme.A.transpose() * force_.low;
}

// Closed rows must not move, and rigid modes must feel nothing. The system of the set answers both.
std::pair<VectorXd, VectorXd> IterativeRefinement::closed(const VectorXd& residual) const {
  const std::vector<Index>& rows = system_.rows;
  const VectorXd scale = data_.scaled.scale(rows);
  VectorXd bottom;
  if (floats())  // of orthonormal modes; inverse takes their amplitudes to those of N
    bottom = -(data_.null_vectors * data_.scaled.inverse).transpose() * residual;
  const auto [force, amplitude] =
      system_.solve(-scale.cwiseProduct(VectorXd(result_.movement(rows))), bottom);
  return {scale.cwiseProduct(force),
          floats() ? VectorXd(data_.scaled.inverse * amplitude) : VectorXd()};
}

// A solve with K is the dearest part of a sweep. It is left out where forces change by rounding only, and
// move nothing more than that.
bool IterativeRefinement::felt(const VectorXd& pushed) const {
  return relative(largest(pushed), largest(force_.high)) > 0.25 * epsilon ||
         largest(data_.condensed.compliance * pushed) >
             0.25 * epsilon * largest(result_.solution.displacement);
}

// What rounding of K leaves along rigid motions must be carried by somebody. Pairs whose force is no larger
// than that hold nothing, and the motions that are free without them take their part.
VectorXd IterativeRefinement::spread(const VectorXd& residual) const {
  const VectorXd inner = residual - (data_.programme.load -
                                     data_.programme.A.transpose() * (force_.high + force_.low));
  const auto along = [&](const MatrixXd& statuses) {
    const MatrixXd Q = column_span(statuses).basis;
    return VectorXd(Q * (Q.transpose() * inner));
  };
  const double nothing = along(data_.null_vectors).lpNorm<1>();
  std::vector<Index> holding;
  for (const Index row : system_.rows)
    if (std::abs(force_.high(row)) > nothing) holding.push_back(row);
  if (holding.empty()) return residual - along(data_.null_vectors);
  const MatrixXd loose = null_space(data_.condensed.rigid(holding, Eigen::all));
  return loose.cols() == 0 ? residual : VectorXd(residual - along(data_.null_vectors * loose));
}

// The first sweeps move bodies rigidly, and K is not applied to that part of u.
void IterativeRefinement::move(const VectorXd& amplitude) {
  result_.amplitude += amplitude;
  PrimalDual& solution = result_.solution;
  if (sweeps_ > rigid_sweeps) return add_displacement(solution, data_.null_vectors * amplitude);
  add_rigid(solution, data_.null_vectors, amplitude);
  // A body that forces out of balance took far away on its springs came back: K, whose entries are rounded, would strain
  // it by the way, once as rigid and once as not. What is left is rigid as far as a motion comes near to it.
  if (sweeps_ == rigid_sweeps && largest(solution.rigid) > 2 * largest(solution.displacement))
    solution.rigid =
        data_.null_vectors * least_norm_solution(data_.null_vectors, solution.displacement);
}

VectorXd IterativeRefinement::push(const VectorXd& pushed) {
  VectorXd moved = data_.solve_stiffness(-(data_.programme.A.transpose() * pushed));
  ++result_.solves;
  add_displacement(result_.solution, moved);
  return moved;
}

// Where the forces that it begins with are not those that u belongs to, u follows them first.
IterativeRefinement::Change IterativeRefinement::begin() {
  const PrimalDual& solution = result_.solution;
  const VectorXd pushed = force_.high - solution.force;
  const double moved = largest(pushed) == 0 ? 0 : largest(push(pushed));
  return {relative(std::max(moved, unrefined_), largest(solution.displacement)),
          relative(largest(pushed), largest(force_.high))};
}

// One sweep: u from the residual of equilibrium, forces from the movements that are left, u from the change
// of forces, rigid motions.
IterativeRefinement::Change IterativeRefinement::sweep() {
  ++sweeps_;
  PrimalDual& solution = result_.solution;
  VectorXd residual = unbalanced();
  if (floats() && data_.imbalance == Imbalance::Spread) residual = spread(residual);
  VectorXd moved = data_.solve_stiffness(residual);
  ++result_.solves;
  add_displacement(solution, moved);
  result_.movement = gaps(data_.programme, solution);
  const auto [closes, amplitude] = closed(residual);
  residual.resize(0);  // the next solve wants the room
  const Forces last = force_;
  for (std::size_t k = 0; k < system_.rows.size(); ++k) {
    const Index row = system_.rows[k];
    add_to(force_.high(row), force_.low(row), closes(static_cast<Index>(k)));
  }
  impose(set_, force_);
  const VectorXd pushed = (force_.high - last.high) + (force_.low - last.low);
  if (steady() && felt(pushed)) moved += push(pushed);
  if (floats()) {
    moved += data_.null_vectors * amplitude;
    move(amplitude);
  }
  return {relative(largest(moved), largest(solution.displacement)),
          relative(largest(pushed), largest(force_.high))};
}

// It ends where the next correction will be rounding, or where two sweeps in a row have brought nothing.
RefinedSolution IterativeRefinement::run() {
  const double infinity = std::numeric_limits<double>::infinity();
  Change best{infinity, infinity};
  Change last = begin();
  double rate = 1;
  for (int worse = 0; worse < 2;) {
    const Change now = sweep();
    if (!std::isfinite(now.worst())) break;
    // A sweep shrinks the error of u by the error of the factor, so the next correction is known
    // beforehand; not while the rigid part is rounded anew. What moved u by more than u tells less.
    if (steady())
      rate = std::min(slow_ ? 1 : rate, ratio(now.displacement, std::min(1.0, last.displacement)));
    const bool known = last.force > 0 && std::isfinite(last.force);
    const double force_rate = known ? std::min(1.0, now.force / last.force) : 1;
    const double next = std::max(now.displacement * rate, now.force * force_rate);
    result_.settled = steady() && next <= 0.25 * epsilon;
    if (result_.settled) break;
    const bool better = now.displacement < 0.5 * best.displacement || now.force < 0.5 * best.force;
    worse = better || !slow_ ? 0 : worse + 1;
    slow_ = slow_ || !better || (steady() && rate > std::sqrt(epsilon));
    best.displacement = std::min(best.displacement, now.displacement);
    best.force = std::min(best.force, now.force);
    last = now;
    result_.settled =
        steady() && now.worst() <= epsilon * static_cast<double>(set_.closed.size() + 1);
  }
  result_.solution.force = force_.high;
  result_.movement = gaps(data_.programme, result_.solution);
  result_.system = std::make_shared<const ActiveSetSystem>(std::move(system_));
  return std::move(result_);
}

}  // namespace

RefinedSolution iterative_refinement(const RefinementData& data, PrimalDual start,
                                     const VectorXd& force,
                                     const std::vector<ContactStatus>& statuses) {
  return IterativeRefinement(data, std::move(start), force, statuses).run();
}

}  // namespace signorini

#include "signorini/complementarity/refine.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "signorini/complementarity/bordered_system.hpp"
#include "signorini/complementarity/rigid_modes.hpp"
#include "signorini/complementarity/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What closes the gaps of W, factored once: G_WW, or where that is singular or bodies float the bordered
/// system of as many pairs of W as are independent. These close the others of W as well.
class Closing {
 public:
  Closing(const QuadraticProgramme& programme, const Eigen::MatrixXd& compliance,
          const std::vector<Index>& active, const MatrixXd& modes)
      : pairs_(active), modes_(modes) {
    if (!floats()) {
      const MatrixXd closed = compliance(active, active);
      factor_.compute(closed);
      const double tiny = 2 * epsilon * static_cast<double>(active.size() + 1);
      if (factor_.info() == Eigen::Success &&
          (factor_.matrixLLT().diagonal().array().square() > tiny * closed.diagonal().array())
              .all())
        return;
    }
    const ContactProblem contact{compliance, programme.initial_gap};
    scaled_ = equilibrate(floats() ? floating_problem(programme, contact, modes)
                                   : FloatingProblem{contact, MatrixXd(compliance.rows(), 0), {}});
    system_.emplace(scaled_, active);
    pairs_ = system_->pairs();
  }

  /// \return independent pairs of W, all of W if it has no others
  [[nodiscard]] const std::vector<Index>& pairs() const { return pairs_; }
  [[nodiscard]] bool floats() const { return modes_.cols() > 0; }
  [[nodiscard]] const MatrixXd& modes() const { return modes_; }

  /// Changes of the forces of pairs() and of the amplitudes.
  /// \param gap         of all pairs
  /// \param unbalanced  p - K u - A^T lambda
  [[nodiscard]] std::pair<VectorXd, VectorXd> solve(const VectorXd& gap,
                                                    const VectorXd& unbalanced) const {
    if (!system_) return {pairs_.empty() ? VectorXd() : factor_.solve(-VectorXd(gap(pairs_))), {}};
    const VectorXd scale = scaled_.contact.scale(pairs_);
    const VectorXd resultant =
        floats() ? scaled_.amplitude_scale.cwiseProduct(-modes_.transpose() * unbalanced)
                 : VectorXd();
    const auto [force, amplitude] = system_->solve(-scale.cwiseProduct(gap(pairs_)), resultant);
    return {scale.cwiseProduct(force), scaled_.amplitude_scale.cwiseProduct(amplitude)};
  }

 private:
  std::vector<Index> pairs_;
  const MatrixXd& modes_;
  Eigen::LLT<MatrixXd> factor_;
  ScaledFloating scaled_;
  std::optional<BorderedSystem> system_;
};

/// Whether no force is left along a rigid mode but what rounding makes of the terms; in K u, of as many as
/// K has in a row.
bool balanced(const QuadraticProgramme& programme, const PrimalDual& solution,
              const MatrixXd& modes, double rounding) {
  if (modes.cols() == 0) return true;
  const double row = static_cast<double>(programme.stiffness.nonZeros()) /
                     static_cast<double>(programme.stiffness.rows());
  const VectorXd left = modes.transpose() * equilibrium_residual(programme, solution);
  const VectorXd size = modes.cwiseAbs().transpose() *
                        VectorXd(programme.load.cwiseAbs() +
                                 programme.stiffness.cwiseAbs() * strained(solution).cwiseAbs() +
                                 programme.A.cwiseAbs().transpose() * solution.force.cwiseAbs());
  return (left.array().abs() <= (rounding + row * epsilon) * size.array()).all();
}

/// Whether all signs are right beyond rounding.
bool signs_hold(const QuadraticProgramme& programme, const Refinement& result,
                const std::vector<Index>& active, double rounding) {
  const VectorXd& force = result.solution.force;
  const double tension = rounding * largest(force);
  const double overlap =
      rounding * (largest(programme.initial_gap) + largest(result.solution.displacement));
  std::vector<bool> is_active(static_cast<std::size_t>(force.size()), false);
  for (const Index i : active) is_active[static_cast<std::size_t>(i)] = true;
  for (Index i = 0; i < result.gap.size(); ++i)
    if (is_active[static_cast<std::size_t>(i)] ? force(i) < -tension : result.gap(i) < -overlap)
      return false;
  return true;
}

PrimalDual started(PrimalDual start, const MatrixXd& modes) {
  const Index n = start.displacement.size();
  if (start.displacement_low.size() == 0) start.displacement_low.setZero(n);
  if (modes.cols() > 0 && start.rigid.size() == 0) start.rigid.setZero(n);
  return start;
}

/// What one sweep adds.
struct Correction {
  VectorXd displacement;
  VectorXd force;  ///< of the pairs that Closing chose
};

/// Sweeps whose rigid motion goes into the part of u that strains nothing. That part is rounded, and later
/// sweeps mend it; what they move is so small that it may as well strain the bodies.
constexpr Index rigid_sweeps = 2;

Correction sweep(const QuadraticProgramme& programme,
                 const std::function<VectorXd(const VectorXd&)>& solve_stiffness,
                 const Closing& closing, Refinement& result) {
  PrimalDual& solution = result.solution;
  Correction change;
  const VectorXd unbalanced = equilibrium_residual(programme, solution);
  change.displacement = solve_stiffness(unbalanced);
  add_displacement(solution, change.displacement);
  ++result.sweeps;
  result.gap = gaps(programme, solution);
  VectorXd amplitude;
  std::tie(change.force, amplitude) = closing.solve(result.gap, unbalanced);
  for (std::size_t k = 0; k < closing.pairs().size(); ++k)
    solution.force(closing.pairs()[k]) += change.force(static_cast<Index>(k));
  if (!closing.floats()) return change;
  VectorXd moved = closing.modes() * amplitude;
  result.amplitude += amplitude;
  change.displacement += moved;
  if (result.sweeps <= rigid_sweeps) {
    const VectorXd last = solution.rigid;
    solution.rigid += moved;
    moved = solution.rigid - last;
  }
  add_displacement(solution, moved);
  result.gap = gaps(programme, solution);
  return change;
}

/// Moves u as the forces would that close the gaps still left, which the rounding of lambda has swallowed:
/// the nodes then miss forces of that rounding, and the gaps of a slender body nothing.
void close_what_rounding_left(const QuadraticProgramme& programme,
                              const std::function<VectorXd(const VectorXd&)>& solve_stiffness,
                              const Closing& closing, double rounding, Refinement& result) {
  if (closing.pairs().empty() || largest(VectorXd(result.gap(closing.pairs()))) <=
                                     rounding * largest(result.solution.displacement))
    return;
  const auto [force, amplitude] = closing.solve(result.gap, VectorXd::Zero(programme.load.size()));
  VectorXd all = VectorXd::Zero(programme.initial_gap.size());
  for (std::size_t k = 0; k < closing.pairs().size(); ++k)
    all(closing.pairs()[k]) = force(static_cast<Index>(k));
  add_displacement(result.solution, -solve_stiffness(programme.A.transpose() * all));
  ++result.sweeps;
  if (closing.floats()) {
    result.amplitude += amplitude;
    add_displacement(result.solution, closing.modes() * amplitude);
  }
  result.gap = gaps(programme, result.solution);
}

}  // namespace

void add_displacement(PrimalDual& solution, const Eigen::VectorXd& change) {
  for (Index i = 0; i < change.size(); ++i) {
    double& high = solution.displacement(i);
    double& low = solution.displacement_low(i);
    const double sum = high + change(i);
    const double part = sum - high;
    const double rest = ((high - (sum - part)) + (change(i) - part)) + low;
    high = sum + rest;
    low = rest - (high - sum);
  }
}

Refinement refine(const QuadraticProgramme& programme,
                  const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve_stiffness,
                  const Eigen::MatrixXd& compliance, PrimalDual start,
                  const std::vector<Index>& active, const MatrixXd& modes) {
  const Closing closing(programme, compliance, active, modes);
  Refinement result;
  result.solution = started(std::move(start), modes);
  result.amplitude.setZero(modes.cols());
  const PrimalDual& solution = result.solution;

  const double rounding = epsilon * static_cast<double>(active.size() + 1);
  const Index first = closing.floats() ? rigid_sweeps + 1 : 1;  // from here on corrections shrink
  double rate = 1;
  double last_u = std::numeric_limits<double>::infinity();
  double last_force = last_u;
  bool settled = false;
  while (true) {
    const Correction change = sweep(programme, solve_stiffness, closing, result);
    // The corrections just made, relative to what they correct. The next sweep shows by how much one
    // sweep shrinks the error of u; once lambda has settled, the next correction will be that much smaller.
    const double moved_u = ratio(largest(change.displacement), largest(solution.displacement));
    const double moved_force = ratio(largest(change.force), largest(solution.force));
    if (result.sweeps == std::max<Index>(first, 2)) rate = std::min(1.0, ratio(moved_u, last_u));
    if (result.sweeps < first) {
      last_u = moved_u;
      continue;
    }
    settled = moved_u * rate <= rounding && moved_force <= rounding;
    const bool stalled = !(moved_u < 0.5 * last_u) && !(moved_force < 0.5 * last_force);
    if (settled || stalled) break;
    last_u = moved_u;
    last_force = moved_force;
  }
  if (settled) close_what_rounding_left(programme, solve_stiffness, closing, rounding, result);
  result.confirmed = settled && solution.displacement.allFinite() && solution.force.allFinite() &&
                     signs_hold(programme, result, active, rounding) &&
                     balanced(programme, solution, modes, rounding);
  return result;
}

}  // namespace signorini

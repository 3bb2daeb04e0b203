#include "signorini/complementarity/refine.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <utility>

namespace signorini {
namespace {

using Eigen::Index;

double ratio(double part, double whole) { return part == 0 ? 0 : part / whole; }

double largest(const Eigen::VectorXd& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }

}  // namespace

void add_displacement(PrimalDual& solution, const Eigen::VectorXd& change) {
  for (Index i = 0; i < change.size(); ++i) {
    const double addend = solution.displacement_low(i) + change(i);
    const double sum = solution.displacement(i) + addend;
    const double part = sum - solution.displacement(i);
    solution.displacement_low(i) = (solution.displacement(i) - (sum - part)) + (addend - part);
    solution.displacement(i) = sum;
  }
}

Refinement refine(const QuadraticProgramme& programme,
                  const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve_stiffness,
                  const Eigen::MatrixXd& compliance, PrimalDual start,
                  const std::vector<Index>& active) {
  Refinement result;
  PrimalDual& solution = result.solution;
  solution = std::move(start);
  if (solution.displacement_low.size() == 0)
    solution.displacement_low.setZero(solution.displacement.size());
  const Eigen::LLT<Eigen::MatrixXd> factor(compliance(active, active));

  const double rounding =
      std::numeric_limits<double>::epsilon() * static_cast<double>(active.size() + 1);
  double rate = 1;
  double last_u = std::numeric_limits<double>::infinity();
  double last_force = last_u;
  bool settled = false;
  while (factor.info() == Eigen::Success) {
    const Eigen::VectorXd change = solve_stiffness(equilibrium_residual(programme, solution));
    add_displacement(solution, change);
    ++result.sweeps;
    result.gap = gaps(programme, solution);
    Eigen::VectorXd force_change;
    if (!active.empty()) {
      force_change = factor.solve(-Eigen::VectorXd(result.gap(active)));
      for (std::size_t k = 0; k < active.size(); ++k)
        solution.force(active[k]) += force_change(static_cast<Index>(k));
    }
    // The corrections just made, relative to what they correct. The second sweep shows by how much one
    // sweep shrinks the error of u; once lambda has settled, the next correction will be that much smaller.
    const double moved_u = ratio(largest(change), largest(solution.displacement));
    const double moved_force = ratio(largest(force_change), largest(solution.force));
    if (result.sweeps == 2) rate = std::min(1.0, ratio(moved_u, last_u));
    settled = moved_u * rate <= rounding && moved_force <= rounding;
    const bool stalled = !(moved_u < 0.5 * last_u) && !(moved_force < 0.5 * last_force);
    if (settled || stalled) break;
    last_u = moved_u;
    last_force = moved_force;
  }
  result.confirmed = settled && solution.displacement.allFinite() && solution.force.allFinite();
  const double tension = rounding * largest(solution.force);
  const double overlap =
      rounding * (largest(programme.initial_gap) + largest(solution.displacement));
  std::vector<bool> is_active(static_cast<std::size_t>(solution.force.size()), false);
  for (const Index i : active) is_active[static_cast<std::size_t>(i)] = true;
  for (Index i = 0; i < result.gap.size(); ++i)
    if (is_active[static_cast<std::size_t>(i)] ? solution.force(i) < -tension
                                               : result.gap(i) < -overlap)
      result.confirmed = false;
  return result;
}

}  // namespace signorini

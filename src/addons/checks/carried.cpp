// What the forces of a solution do, of a programme and of a condensed problem.
#include <utility>

#include "addons/certified/known_forces.hpp"
#include "addons/checks/undetermined.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_system.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Carried carried(const QuadraticProgramme& programme, const PrimalDual& solution,
                const FrictionLaw& law, std::vector<ContactStatus> statuses) {
  const auto roundings =
      2 * static_cast<double>(closed_pairs(statuses).size() + 1);  // as in check_signs()
  return {programme.A.transpose(),
          law,
          solution.force,
          gaps(programme, solution),
          roundings * movement_rounding(programme, solution),
          std::move(statuses)};
}

Carried carried(const ContactProblem& problem, const ContactState& state) {
  const Index rows = problem.compliance.rows();
  const Index modes = problem.rigid.cols();
  const VectorXd force = all_forces(state);
  const VectorXd free = free_movement(problem);
  const VectorXd scale = row_scales(problem.compliance, problem.rigid, free);
  MatrixXd effect(rows + modes, rows);
  effect.topRows(rows) = scale.asDiagonal() * problem.compliance;
  VectorXd size = free.cwiseAbs() + problem.compliance.cwiseAbs() * force.cwiseAbs();
  if (modes > 0) {
    size += problem.rigid.cwiseAbs() * state.amplitude.cwiseAbs();
    const VectorXd lengths = (scale.asDiagonal() * problem.rigid).colwise().norm();
    for (Index k = 0; k < modes; ++k)
      effect.row(rows + k) = problem.rigid.col(k).transpose() / (lengths(k) > 0 ? lengths(k) : 1);
  }
  return {effect.sparseView(),
          problem.law,
          force,
          all_movements(state),
          static_cast<double>(rows + modes + 1) * epsilon * size,
          state.contact_status};
}

}  // namespace signorini

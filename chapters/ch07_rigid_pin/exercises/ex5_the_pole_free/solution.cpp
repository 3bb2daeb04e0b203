#include <stdexcept>

#include "exercise.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace ex7_5 {

Bearing pole_free(const HeldPlate& plate) {
  using namespace signorini;
  const Eigen::Index n = plate.free_gap.size();
  if (plate.compliance.rows() != n || plate.compliance.cols() != n || plate.cosine.size() != n)
    throw std::invalid_argument("pole_free: sizes do not fit");
  ContactProblem problem{Eigen::MatrixXd::Zero(n + 1, n + 1), Eigen::VectorXd::Zero(n + 1)};
  problem.compliance.bottomRightCorner(n, n) = plate.compliance;  // the pole is pair 0
  problem.free_gap.tail(n) = plate.free_gap;
  problem.rigid.resize(n + 1, 1);
  problem.rigid << 1, plate.cosine;
  // A spring on the motion makes the compliance regular. It moves the amplitude only: all of P goes through R.
  const double spring = n > 0 ? plate.compliance.diagonal().mean() : 1;
  problem.compliance += spring * problem.rigid * problem.rigid.transpose();
  problem.resultant = Eigen::VectorXd::Constant(1, plate.load);
  const ContactState state = solve(problem, find_solver("primal_dual_active_set"));
  if (state.report.status != SolveStatus::Solved)
    throw NotSolved(text("pole_free: ", to_string(state.report.status)));
  return {state.force(0), state.gap(0), state.force.tail(n)};
}

}  // namespace ex7_5

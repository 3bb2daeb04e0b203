#include "exercise.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace ex13_2 {

using namespace signorini;

Rest come_to_rest(const Eigen::MatrixXd& compliance, const Eigen::VectorXd& position, double load,
                  double eccentricity) {
  const Eigen::Index n = position.size();
  require_argument(compliance.rows() == n && compliance.cols() == n,
                   "come_to_rest: need a compliance of ", n, " points, got ", compliance.rows(),
                   "x", compliance.cols());
  ContactProblem problem{compliance, Eigen::VectorXd::Zero(n)};
  problem.rigid.resize(n, 2);
  problem.rigid.col(0).setConstant(-1);  // sinking closes every gap
  problem.rigid.col(1) = -position;      // tilting those on the right
  problem.resultant = -load * Eigen::Vector2d(1, eccentricity);
  const ContactState state = solve(problem, find_solver("primal_dual_active_set"));
  if (state.report.status != SolveStatus::Solved)
    throw NotSolved(text("the footing: ", to_string(state.report.status)));
  return {state.force, state.amplitude(0), state.amplitude(1)};
}

}  // namespace ex13_2

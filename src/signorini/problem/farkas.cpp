#include "signorini/problem/farkas.hpp"

#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd farkas_certificate(const ScaledProblem& problem, const std::vector<Index>& active,
                            Index pair) {
  ScaledProblem pressed = problem;
  pressed.free = problem.compliance.col(pair);
  if (problem.rigid.cols() > 0) pressed.resultant = -problem.rigid.row(pair).transpose();
  const ActiveSetSolution held = solve_active_set(pressed, ActiveSet{active});
  if (!held.solvable || held.rows.size() < active.size()) return {};
  VectorXd y = held.force.head(problem.pairs()).cwiseMax(0.0);  // what is no rounding shows in G y
  y(pair) = 1;
  y /= y.sum();
  if (!verify_farkas(as_posed(problem), y)) return {};
  return problem.scale.head(y.size()).cwiseProduct(y);
}

}  // namespace signorini

// # A proof that there is no solution
//
// A method that fails has shown nothing. A problem without a solution can be recognised: by Farkas'
// lemma there then are weights \f$ y \ge 0 \f$ with \f$ Gy = 0 \f$ and \f$ d^Ty < 0 \f$. They show
// that \f$ y^T(d + G\lambda) = d^Ty < 0 \f$ for all forces, so some gap stays negative.
//
// A cart on a spring of stiffness 1 stands between two walls. The left wall pushes it to the right,
// the right one to the left:
// \f[ G = \begin{pmatrix} 1 & -1 \\ -1 & 1 \end{pmatrix}, \qquad
// d = \begin{pmatrix} 0 \\ -1 \end{pmatrix}. \f]
// The room is too short by 1. With y = (1, 1) we have \f$ Gy = 0 \f$ and \f$ d^Ty = -1 \f$: the two
// gaps always add up to -1.

#include "signorini/problem/farkas.hpp"

#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {

using Eigen::Index, Eigen::VectorXd;

// A method that closes pairs one by one meets the proof when a pair p depends on those that are
// closed. We press p with the force 1 and ask which forces on W hold the other pairs where they
// are. Between the walls W is the left one, and the answer is 1.
//
// If one of these forces is negative, that pair has to open, and there is no proof. So negative
// ones become 0. If they were more than rounding, \f$ Gy = 0 \f$ fails, and verify_farkas() refuses
// y.
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

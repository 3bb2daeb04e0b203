#include "exercise.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"

namespace ex13_3 {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Rest rest_of(const FloatingBody& body, Index held, const std::vector<Index>& closed) {
  signorini::require_argument(body.motion(held) != 0, "rest_of: the motion does not move unknown ",
                              held);
  MatrixXd A = body.A(closed, Eigen::all);
  const VectorXd closes = A * body.motion;  // what the motion takes from each closed gap
  signorini::require_input((closes.array() != 0).any(),
                           "no closed pair stops the motion of the body");

  MatrixXd K = body.stiffness;
  VectorXd p = body.load;
  K.row(held).setZero();
  K.col(held).setZero();
  K(held, held) = body.stiffness.diagonal().maxCoeff();
  A.col(held).setZero();
  p(held) = 0;
  const signorini::CholeskyFactor factor(K);
  const VectorXd u0 = factor.solve(p);
  const MatrixXd response = factor.solve_columns(A.transpose());

  // g - A u0 + G lambda - closes a = 0, and closes.lambda = m.p
  const auto n = static_cast<Index>(closed.size());
  MatrixXd bordered = MatrixXd::Zero(n + 1, n + 1);
  bordered.topLeftCorner(n, n) = A * response;
  bordered.topRightCorner(n, 1) = -closes;
  bordered.bottomLeftCorner(1, n) = -closes.transpose();
  VectorXd right(n + 1);
  right << A * u0 - body.initial_gap(closed), -body.motion.dot(body.load);
  const VectorXd found = signorini::LuFactor(bordered).solve(right);

  Rest rest;
  rest.force = VectorXd::Zero(body.initial_gap.size());
  rest.force(closed) = found.head(n);
  rest.amplitude = found(n);
  rest.displacement = u0 - response * found.head(n) + rest.amplitude * body.motion;
  return rest;
}

}  // namespace ex13_3

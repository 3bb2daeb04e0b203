#include "support/floating.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace signorini_test {

namespace {

Eigen::MatrixXd random_matrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
  Eigen::MatrixXd matrix(rows, cols);
  for (Eigen::Index k = 0; k < matrix.size(); ++k) matrix.data()[k] = random.uniform(-1, 1);
  return matrix;
}

}  // namespace

signorini::ContactProblem bar(const Eigen::VectorXd& x, const Eigen::VectorXd& compliance,
                              const Eigen::VectorXd& gap, double w, double at) {
  signorini::ContactProblem problem{
      compliance.asDiagonal(),   gap, {}, {}, Eigen::MatrixXd(x.size(), 2),
      Eigen::Vector2d(w, at * w)};
  problem.rigid << Eigen::VectorXd::Ones(x.size()), x;
  return problem;
}

KnownFloating known_floating(Random& random, double softest, double far) {
  const Eigen::Index n = random.whole(6, 14);
  const Eigen::Index m = random.whole(4, 10);
  const Eigen::Index modes = random.whole(1, 3);
  KnownFloating known;
  known.null_vectors = random_matrix(random, n, modes);
  const Eigen::MatrixXd Q =
      Eigen::HouseholderQR<Eigen::MatrixXd>(known.null_vectors).householderQ();
  const Eigen::MatrixXd Z = Q.rightCols(n - modes);
  const Eigen::MatrixXd V =
      Eigen::HouseholderQR<Eigen::MatrixXd>(random_matrix(random, n - modes, n - modes))
          .householderQ();
  Eigen::VectorXd stiffness(n - modes);
  for (Eigen::Index i = 0; i < n - modes; ++i) stiffness(i) = random.uniform(0.5, 2);
  stiffness(0) = softest;
  Eigen::MatrixXd& K = known.programme.stiffness;
  const Eigen::MatrixXd basis = Z * V;
  K = basis * stiffness.asDiagonal() * basis.transpose();
  K = (0.5 * (K + K.transpose())).eval();
  known.programme.A = random_matrix(random, m, n);
  known.displacement = far * random_matrix(random, n, 1);
  known.force.setZero(m);
  Eigen::VectorXd gap(m);
  for (Eigen::Index i = 0; i < m; ++i) gap(i) = random.uniform(0.1, 2);
  for (Eigen::Index i = random.whole(static_cast<int>(modes), static_cast<int>(std::min(m, n - 1)));
       i-- > 0;) {
    gap(i) = 0;
    known.force(i) = random.uniform(0.1, 2);
  }
  known.programme.load = K * known.displacement + known.programme.A.transpose() * known.force;
  known.programme.initial_gap = known.programme.A * known.displacement + gap;
  return known;
}

}  // namespace signorini_test

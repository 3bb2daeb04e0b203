// Problems that defeated methods before.
#include <cmath>

#include "papers/examples.hpp"
#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"
#include "support/problems.hpp"

namespace signorini_test {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Instances cycling() {  // changing all wrong pairs at once goes {2, 3} -> {1, 2} -> {} -> {2, 3}
  Instance made{"three pairs", cycling_problem()};
  made.force = Eigen::Vector3d(0, 0.4, 0);
  made.gap = Eigen::Vector3d(0.6, 0, 2.2);
  made.accuracy = 1e-13;
  return {made};
}

Instances cycling_asymmetric() {  // the same from {2}: {2} -> {3} -> {1} -> {2}
  Eigen::Matrix3d M;
  M << 1, 0, 2, 2, 1, 0, 0, 2, 1;
  Instances made;
  for (const double q : {1.0, -1.0}) {
    made.push_back({text("q = ", q), {M, Eigen::Vector3d::Constant(q)}});
    made.back().force = Eigen::Vector3d::Constant(q > 0 ? 0 : 1.0 / 3);
    made.back().gap = Eigen::Vector3d::Constant(q > 0 ? 1 : 0);
    made.back().accuracy = 1e-13;
  }
  return made;
}

Instances fathi() {
  Instances made;
  for (const Index n : {2, 4, 8, 12}) {
    made.push_back({text(n, " pairs"), signorini::fathi(n)});
    made.back().force = VectorXd::Unit(n, 0);
    made.back().gap = VectorXd::Ones(n) - VectorXd::Unit(n, 0);
  }
  return made;
}

Instances murty() {  // twos below a diagonal of ones: a P-matrix that takes Lemke 2^n pivots
  Instances made;
  for (const Index n : {2, 4, 8, 12}) {
    MatrixXd M = MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i) M.row(i).head(i).setConstant(2);
    VectorXd easy = VectorXd::Constant(n, -1);  // force (1, 0, ..., 0), gap (0, 1, ..., 1)
    made.push_back({text(n, " pairs, q = -1"), {M, easy}});
    made.back().force = VectorXd::Unit(n, 0);
    made.back().gap = VectorXd::Ones(n) - VectorXd::Unit(n, 0);
    made.push_back({text(n, " pairs, all bases on the way"), signorini::murty(n)});
    made.back().force = std::ldexp(1, static_cast<int>(n)) * VectorXd::Unit(n, n - 1);
    made.back().gap = VectorXd::Zero(n);  // 2, 4, 8, ..., and 0 for the closed pair
    for (Index i = 0; i + 1 < n; ++i) made.back().gap(i) = std::ldexp(1, static_cast<int>(i + 1));
  }
  return made;
}

}  // namespace signorini_test

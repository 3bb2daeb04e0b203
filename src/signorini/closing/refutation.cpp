#include "signorini/closing/refutation.hpp"

#include <cmath>

#include "signorini/closing/closed_pairs.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// A x, summed in twice the working precision.
Eigen::VectorXd product(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::VectorXd& x) {
  Eigen::VectorXd result(A.rows());
  for (Index i = 0; i < A.rows(); ++i) {
    ExactSum sum;
    for (Index j = 0; j < A.cols(); ++j) sum.add_product(A(i, j), x(j));
    result(i) = sum.value();
  }
  return result;
}

/// Whether the gaps of a problem can be summed with these numbers.
bool is_combination(const Eigen::VectorXd& free_gap, const Eigen::VectorXd& y) {
  return y.size() == free_gap.size() && y.size() > 0 && y.allFinite() && (y.array() >= 0).all();
}

/// Whether d^T y < 0 beyond rounding, G y = 0 but for rounding, and no forces within reach lift d^T y to 0.
/// \param moved  G y
bool out_of_reach(const Eigen::VectorXd& free_gap, const Eigen::VectorXd& y,
                  const Eigen::VectorXd& moved, const Eigen::VectorXd& scale) {
  ExactSum overlap;
  for (Index i = 0; i < y.size(); ++i) overlap.add_product(-free_gap(i), y(i));
  const double rounded = 1e3 * epsilon;  // what rounding may have done to the data
  const double lost = static_cast<double>(y.size()) * rounded * free_gap.cwiseAbs().dot(y);
  const double deepest = -free_gap.cwiseProduct(scale).minCoeff();
  const double most = moved.cwiseProduct(scale).cwiseAbs().maxCoeff();
  return overlap.value() > lost && most <= rounded * y.cwiseQuotient(scale).sum() &&
         most * deepest < overlap.value() * std::sqrt(epsilon);
}

}  // namespace

bool refutes(const ContactProblem& problem, const Eigen::VectorXd& y) {
  return is_combination(problem.free_gap, y) &&
         out_of_reach(problem.free_gap, y, product(problem.compliance.transpose(), y),
                      pair_scales(problem.compliance));
}

bool refutes(const HalfProblem& problem, const Eigen::VectorXd& y) {
  if (!is_combination(problem.free_gap, y)) return false;
  const Eigen::VectorXd length = problem.half.colwise().norm();
  return out_of_reach(problem.free_gap, y,
                      product(problem.half.transpose(), product(problem.half, y)),
                      length.unaryExpr([](double h) { return h > 0 ? 1 / h : 1; }));
}

}  // namespace signorini

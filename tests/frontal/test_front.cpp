#include <Eigen/Cholesky>

#include "addons/frontal/front.hpp"
#include "catch_compat.hpp"
#include "signorini/core/random.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// Symmetric, positive definite.
MatrixXd definite(Index n, std::uint64_t seed) {
  Random random(seed);
  MatrixXd B(n, n);
  for (Index k = 0; k < B.size(); ++k) B.data()[k] = random.uniform(-1, 1);
  MatrixXd A = B * B.transpose();
  A.diagonal().array() += 1;
  return A;
}

MatrixXd lower(const MatrixXd& matrix) { return matrix.triangularView<Eigen::Lower>(); }

}  // namespace

TEST_CASE("a front becomes columns of L and a Schur complement, whatever its size", "[front]") {
  for (const Index own : {0, 1, 3, 4, 5, 8, 63, 64, 65, 130, 200})
    for (const Index rim : {0, 1, 2, 4, 7, 33, 120}) {
      CAPTURE(own, rim);
      const MatrixXd A = definite(own + rim, static_cast<std::uint64_t>(own + 7 * rim));
      MatrixXd columns = A.leftCols(own);
      MatrixXd update = A.bottomRightCorner(rim, rim);
      REQUIRE(eliminate(columns, update, VectorXd::Zero(own)) == own);
      const MatrixXd L = lower(Eigen::LLT<MatrixXd>(A).matrixLLT());
      const MatrixXd trailing = L.bottomRightCorner(rim, rim);
      CHECK((lower(columns.topRows(own)) - L.topLeftCorner(own, own)).norm() <= 1e-12 * A.norm());
      CHECK((columns.bottomRows(rim) - L.bottomLeftCorner(rim, own)).norm() <= 1e-12 * A.norm());
      CHECK((lower(update) - lower(trailing * trailing.transpose())).norm() <= 1e-12 * A.norm());
    }
}

TEST_CASE(
    "a pivot that is not larger than its bound ends the elimination and stays on the diagonal",
    "[front]") {
  const Index own = 90;
  for (const Index bad : {0, 1, 5, 63, 64, 70, 89}) {
    MatrixXd A = definite(own + 10, 3);
    const MatrixXd L = lower(Eigen::LLT<MatrixXd>(A).matrixLLT());
    const double pivot = L(bad, bad) * L(bad, bad);
    for (const double left : {0.5, 0.0, -2.0}) {  // of the bound 1e-3
      CAPTURE(bad, left);
      MatrixXd columns = A.leftCols(own);
      columns(bad, bad) += left * 1e-3 - pivot;
      MatrixXd update = A.bottomRightCorner(10, 10);
      CHECK(eliminate(columns, update, VectorXd::Constant(own, 1e-3)) == bad);
      CHECK(columns(bad, bad) == Approx(left * 1e-3).margin(1e-11));
    }
    MatrixXd columns = A.leftCols(own);
    MatrixXd update = A.bottomRightCorner(10, 10);
    columns(bad, bad) = std::numeric_limits<double>::quiet_NaN();
    CHECK(eliminate(columns, update, VectorXd::Zero(own)) == bad);
  }
}

// Factors of dense matrices: each is tested by what it must do to a matrix that has known properties.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/random.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {
MatrixXd random_matrix(Index rows, Index columns, std::uint64_t seed) {
  Random random(seed);
  MatrixXd matrix(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i) matrix(i, j) = random.uniform(-1, 1);
  return matrix;
}

/// A matrix of rank 2 whose third column is the first minus twice the second.
MatrixXd of_rank_two(Index rows) {
  MatrixXd matrix = random_matrix(rows, 3, 5);
  matrix.col(2) = matrix.col(0) - 2 * matrix.col(1);
  return matrix;
}

bool orthonormal(const MatrixXd& Q) {
  return (Q.transpose() * Q - MatrixXd::Identity(Q.cols(), Q.cols())).norm() < 1e-13;
}

constexpr double rounding =
    1e-12;  // a few hundred roundings: the matrices are small and well conditioned

}  // namespace

TEST_CASE("elimination solves a system without symmetry", "[dense]") {
  const Index n = GENERATE(1, 2, 7, 40);
  CAPTURE(n);
  const MatrixXd A = random_matrix(n, n, 1) + 3 * MatrixXd::Identity(n, n);
  const MatrixXd X = random_matrix(n, 3, 2);
  const LuFactor factor(A);
  CHECK((factor.solve_columns(A * X) - X).norm() < rounding);
  CHECK((factor.solve(A * X.col(1)) - X.col(1)).norm() < rounding);
}

TEST_CASE("pivots and the sign of the permutation make the determinant", "[dense]") {
  MatrixXd A(3, 3);
  A << 0, 2, 0,  //
      0, 0, 5,   //
      3, 0, 0;   // two exchanges: + 2 * 5 * 3
  CHECK(LuFactor(A).permutation_sign() * LuFactor(A).pivots().prod() == Approx(30).epsilon(1e-15));
  A.row(0).swap(A.row(1));
  CHECK(LuFactor(A).permutation_sign() * LuFactor(A).pivots().prod() == Approx(-30).epsilon(1e-15));
}

TEST_CASE("the condition of a diagonal matrix is the ratio of its entries", "[dense]") {
  const VectorXd entries = Eigen::Vector3d(4, -1e-3, 2);
  CHECK(LuFactor(entries.asDiagonal()).rcond() == Approx(2.5e-4).epsilon(1e-14));
  CHECK(LuFactor(Eigen::Vector3d(1, 0, 1).asDiagonal()).rcond() == 0);
}

TEST_CASE("a Cholesky factor reads the lower triangle and says whether the matrix is positive",
          "[dense]") {
  const Index n = GENERATE(1, 3, 40);
  CAPTURE(n);
  const MatrixXd half = random_matrix(n + 5, n, 3);
  const MatrixXd A = half.transpose() * half;
  MatrixXd lower = A;
  lower.triangularView<Eigen::StrictlyUpper>().setConstant(1e3);
  const CholeskyFactor factor(lower);
  REQUIRE(factor.positive());
  const MatrixXd L = factor.lower().triangularView<Eigen::Lower>();
  CHECK((L * L.transpose() - A).norm() < rounding);
  const MatrixXd X = random_matrix(n, 4, 4);
  CHECK((factor.solve_columns(A * X) - X).norm() <
        1e-9);  // condition of the square of a random matrix
  CHECK((factor.solve(A * X.col(0)) - X.col(0)).norm() < 1e-9);
  MatrixXd Y = L * X;
  solve_lower_columns(factor.lower(), Y);
  CHECK((Y - X).norm() < rounding);
  lower(n - 1, n - 1) -= 2 * L(n - 1, n - 1) * L(n - 1, n - 1);
  CHECK_FALSE(CholeskyFactor(lower).positive());
}

TEST_CASE("copies of a factor outlive the original", "[dense]") {
  LuFactor lu;
  CholeskyFactor cholesky;
  {
    const MatrixXd A = 2 * MatrixXd::Identity(2, 2);
    lu = LuFactor(A);
    cholesky = CholeskyFactor(A);
  }
  CHECK(lu.solve(Eigen::Vector2d(2, 4)) == Eigen::Vector2d(1, 2));
  CHECK((cholesky.solve(Eigen::Vector2d(2, 4)) - Eigen::Vector2d(1, 2)).norm() < 1e-15);
}

TEST_CASE("the span of dependent columns", "[dense]") {
  const MatrixXd A = of_rank_two(5);
  const ColumnSpan span = column_span(A);
  CHECK(span.rank == 2);
  CHECK(orthonormal(span.basis));
  CHECK((span.basis * (span.basis.transpose() * A) - A).norm() < rounding);
  std::vector<Index> order = span.order;
  std::sort(order.begin(), order.end());
  CHECK(order == std::vector<Index>{0, 1, 2});
  Index longest = 0;
  A.colwise().norm().maxCoeff(&longest);
  CHECK(span.order.front() == longest);
}

TEST_CASE("a threshold decides what counts as dependent", "[dense]") {
  MatrixXd A = MatrixXd::Identity(3, 2);
  A(0, 1) = 1;
  A(1, 1) = 1e-6;
  CHECK(column_span(A).rank == 2);
  CHECK(column_span(A, 1e-3).rank == 1);
  CHECK(column_span(A, 1e-3).basis.cols() == 1);
}

TEST_CASE("the null space is all that a matrix takes to zero", "[dense]") {
  const MatrixXd E = of_rank_two(6).transpose();
  const MatrixXd Z = null_space(E);
  CHECK(Z.cols() == 4);
  CHECK(orthonormal(Z));
  CHECK((E * Z).norm() < rounding);
}

TEST_CASE("the shortest solution lies in the span of the rows", "[dense]") {
  const MatrixXd A = of_rank_two(6);
  const VectorXd b = random_matrix(6, 1, 7);
  const VectorXd x = least_norm_solution(A, b);
  CHECK((A.transpose() * (A * x - b)).norm() < rounding);  // nothing comes closer
  CHECK(std::abs(x.dot(Eigen::Vector3d(1, -2, -1))) <
        rounding);  // the direction that A takes to zero
  CHECK((pseudo_inverse(A) * b - x).norm() < rounding);
}

TEST_CASE(
    "the shortest solution of blocks is that of the whole, however their rows and columns are "
    "mixed",
    "[dense]") {
  Random random(11);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    const Index rows = random.whole(1, 12);
    const Index columns = random.whole(1, 12);
    MatrixXd A = random_matrix(rows, columns, static_cast<std::uint64_t>(100 + trial));
    for (double& entry : A.reshaped())
      if (random.whole(1, 5) > 1) entry = 0;  // so that there are blocks, rows and columns of zeros
    const VectorXd b = random_matrix(rows, 1, static_cast<std::uint64_t>(500 + trial));
    const VectorXd whole = pseudo_inverse(A) * b;
    CHECK((least_norm_solution(A, b) - whole).norm() <= 1e-9 * (1 + whole.norm()));
  }
}

TEST_CASE("singular values of a matrix made of known ones", "[dense]") {
  const MatrixXd U = column_span(random_matrix(6, 3, 8)).basis;
  const MatrixXd V = column_span(random_matrix(3, 3, 9)).basis;
  const Eigen::Vector3d values(5, 2, 1e-7);
  const MatrixXd A = U * values.asDiagonal() * V.transpose();
  const SingularValues found = singular_values(A);
  CHECK((found.values - values).norm() < rounding);
  CHECK(orthonormal(found.U));
  CHECK(orthonormal(found.V));
  CHECK((found.U * found.values.asDiagonal() * found.V.transpose() - A).norm() < rounding);
}

TEST_CASE("eigenvalues of a symmetric matrix rise and are signed", "[dense]") {
  Eigen::Matrix2d A;
  A << 1, 9,  // above the diagonal nothing is read
      2, -2;  // of [1 2; 2 -2]: 2 and -3
  CHECK((symmetric_eigenvalues(A) - Eigen::Vector2d(-3, 2)).norm() < 1e-14);
}

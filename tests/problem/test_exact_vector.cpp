// Residuals of many equations at once: as exact as ExactSum, entry by entry.
#include "catch_compat.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/problem/exact_vector.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ExactSum;
using signorini::ExactVector;

TEST_CASE("columns times factors are summed as exactly as by ExactSum", "[exact_vector]") {
  signorini_test::Random random(4);
  MatrixXd matrix(7, 30);
  VectorXd factor(30);
  for (Index j = 0; j < 30; ++j) {
    factor(j) = random.uniform(-1e8, 1e8);
    for (Index i = 0; i < 7; ++i) matrix(i, j) = random.uniform(-1e8, 1e8);
  }
  const VectorXd rounded = -(matrix * factor);  // what is left over is rounding
  ExactVector by_columns(rounded);
  for (Index j = 0; j < 30; ++j) by_columns.add_product(matrix.col(j), factor(j));
  ExactVector by_rows(rounded);
  by_rows.add_products(matrix.transpose(), factor);
  for (Index i = 0; i < 7; ++i) {
    ExactSum sum(rounded(i));
    for (Index j = 0; j < 30; ++j) sum.add_product(matrix(i, j), factor(j));
    CHECK(by_columns.value()(i) == sum.value());
    CHECK(by_rows.value()(i) == sum.value());
    CHECK(sum.value() != 0);
  }
}

TEST_CASE("a cancelled sum keeps its last product", "[exact_vector]") {
  ExactVector sum(VectorXd::Constant(1, 1e16));
  sum.add_product(VectorXd::Constant(1, 1.0 / 3), 3);
  sum.add_product(VectorXd::Constant(1, -1e8), 1e8);
  // 3 times the double next to 1/3 is 1 - 2^-54.
  CHECK(sum.value()(0) == 1 - 0x1p-54);
  sum.add_small(VectorXd::Constant(1, 0x1p-54));
  CHECK(sum.value()(0) == 1);
}

TEST_CASE("a sparse column adds what the same column adds with its zeros", "[exact_vector]") {
  const VectorXd start = (VectorXd(4) << 1, 0.1, -3, 1e16).finished();
  const VectorXd column = (VectorXd(4) << 0, 0.1, 0, 1 / 3.0).finished();
  const Eigen::SparseMatrix<double> matrix = Eigen::MatrixXd(column).sparseView();
  ExactVector full(start);
  ExactVector few(start);
  for (const double factor : {0.7, -1e15, 1e-17}) {
    full.add_product(column, factor);
    few.add_product(matrix, 0, factor);
    CHECK(few.value() == full.value());
  }
  CHECK_FALSE(few.value() == start);
}

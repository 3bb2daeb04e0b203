// The LU factor that keeps to the diagonal, beside the one that takes any order of the rows.
#include <Eigen/LU>
#include <vector>

#include "addons/many_bodies/diagonal_lu.hpp"
#include "catch_compat.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// Springs between neighbours on a square of nodes, each held by a spring of its own, and a little more one way than the other.
Eigen::SparseMatrix<double> grid(Index n, double own) {
  Random random(7);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n * n; ++i) {
    entries.emplace_back(i, i, 4 + own);
    for (const Index other : {i % n + 1 < n ? i + 1 : i, i + n < n * n ? i + n : i}) {
      if (other == i) continue;
      entries.emplace_back(i, other, -random.uniform(0.9, 1));
      entries.emplace_back(other, i, -random.uniform(0.9, 1));
    }
  }
  Eigen::SparseMatrix<double> A(n * n, n * n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// Entries of the factor of a grid. Expects that it solves.
Index entries(double own) {
  const Eigen::SparseMatrix<double> A = grid(30, own);
  DiagonalLu factor;
  REQUIRE(factor.factorise(A));
  const VectorXd b = VectorXd::LinSpaced(A.rows(), -1, 1);
  CHECK((A * factor.solve(b) - b).norm() < 1e-10 * b.norm());
  return factor.entries();
}

}  // namespace

TEST_CASE("pivots on the diagonal leave fewer entries where it is large, and others are taken where it is small",
          "[diagonal_lu]") {
  const Eigen::SparseMatrix<double> A = grid(30, 0.1);
  Eigen::SparseLU<Eigen::SparseMatrix<double>> any;
  any.compute(A);
  const Index fewest = entries(0.1);
  CHECK(4 * fewest < 3 * (any.nnzL() + any.nnzU()));
  CHECK(entries(-3.99) > fewest);
}

TEST_CASE("the factor that keeps to the diagonal knows the sign of a determinant, matrix after matrix", "[diagonal_lu]") {
  DiagonalLu factor;
  for (const double own : {0.1, -0.3, -1.0, 2.0}) {
    const Eigen::SparseMatrix<double> A = grid(4, own);
    REQUIRE(factor.factorise(A));
    CHECK(factor.sign() == (Eigen::MatrixXd(A).determinant() > 0 ? 1 : -1));
  }
}

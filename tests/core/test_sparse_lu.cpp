#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/sparse_lu.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

TEST_CASE("matrices with entries in the same places are factored one after the other",
          "[sparse_lu]") {
  Random random(4);
  const Index n = 12;
  SparseLuFactor factor;
  for (int sample = 0; sample < 5; ++sample) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < n; ++i) {
      const double sign = i < sample ? -1 : 1;
      entries.emplace_back(i, i, sign * random.uniform(4, 5));
      entries.emplace_back(i, (5 * i + 1) % n, random.uniform(-2, 2));
      entries.emplace_back((3 * i + 2) % n, i, random.uniform(-1, 1));
    }
    Eigen::SparseMatrix<double> A(n, n);
    A.setFromTriplets(entries.begin(), entries.end());
    VectorXd b(n);
    for (double& entry : b) entry = random.uniform(-1, 1);
    REQUIRE(factor.factorise(A));
    const VectorXd x = factor.solve(b);
    CAPTURE(sample);
    CHECK((A * x - b).norm() < 1e-14 * static_cast<double>(n) * b.norm());
    const LuFactor dense{MatrixXd(A)};
    CHECK((x - dense.solve(b)).norm() < 1e-13 * x.norm());
    const bool odd = (dense.pivots().array() < 0).count() % 2 == 1;
    CHECK(factor.sign() == (odd ? -1 : 1) * dense.permutation_sign());
    CHECK(factor.sign() == (sample % 2 == 1 ? -1 : 1));  // discs of Gershgorin: as many negative
  }
}

TEST_CASE("a pivot that is zero is told, and the next matrix is another matter", "[sparse_lu]") {
  Eigen::SparseMatrix<double> A = MatrixXd((MatrixXd(2, 2) << 1, 2, 2, 4).finished()).sparseView();
  SparseLuFactor factor;
  CHECK_FALSE(factor.factorise(A));
  A.coeffRef(1, 1) = 5;
  REQUIRE(factor.factorise(A));
  CHECK((factor.solve(Eigen::Vector2d(1, 1)) - Eigen::Vector2d(3, -1)).norm() < 1e-15);
}

TEST_CASE("a matrix without entries in a column, or without columns, is singular", "[sparse_lu]") {
  Eigen::SparseMatrix<double> hollow(2, 2);
  hollow.insert(0, 0) = 1;
  hollow.insert(1, 0) = 1;
  Eigen::SparseMatrix<double> flat(2, 2);  // a row has none
  flat.insert(0, 0) = 1;
  flat.insert(0, 1) = 1;
  for (const Eigen::SparseMatrix<double>& A : {hollow, flat, Eigen::SparseMatrix<double>(0, 0)}) {
    CAPTURE(A.cols());
    SparseLuFactor factor;
    CHECK_FALSE(factor.factorise(A));
  }
}

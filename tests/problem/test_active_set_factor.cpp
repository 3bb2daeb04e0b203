// The factor of the closed pairs: L L^T = G_WW and y = -L^-1 d_W, whatever joined or left before.

#include "catch_compat.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/problem/active_set_factor.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ActiveSetFactor;
using signorini_test::Random;

namespace {

/// Unit columns, their products, and gaps.
struct Rows {
  MatrixXd H;
  MatrixXd G;
  VectorXd d;
};

Rows random_rows(Random& random, Index n, Index m) {
  Rows rows{MatrixXd(n, m), {}, VectorXd(m)};
  for (Index k = 0; k < m; ++k) {
    for (Index i = 0; i < n; ++i) rows.H(i, k) = random.uniform(-1, 1);
    rows.H.col(k).normalize();
    rows.d(k) = random.uniform(-1, -0.1);
  }
  rows.G = rows.H.transpose() * rows.H;
  return rows;
}

/// Candidates with their gaps under the forces of the basis.
ActiveSetFactor::Candidates candidates(const Rows& rows, const ActiveSetFactor& basis,
                                       const std::vector<Index>& list, bool columns) {
  VectorXd force;
  basis.solve(force);
  const VectorXd gap = rows.d + rows.G(Eigen::all, basis.rows()) * force.head(basis.size());
  ActiveSetFactor::Candidates result;
  result.rows = list;
  result.gap = gap(list);
  result.rounding = VectorXd::Zero(static_cast<Index>(list.size()));
  if (columns) result.columns = rows.H(Eigen::all, list);
  if (!columns) result.cross = rows.G(basis.rows(), list);
  if (!columns) result.block = rows.G(list, list);
  return result;
}

void check_factor(const Rows& rows, const ActiveSetFactor& basis) {
  const Index k = basis.size();
  const MatrixXd L = basis.factor().triangularView<Eigen::Lower>();
  const MatrixXd G = rows.G(basis.rows(), basis.rows());
  CHECK((L * L.transpose() - G).norm() < 1e-13);
  VectorXd force;
  basis.solve(force);
  const VectorXd expected = signorini::LuFactor(G).solve(-rows.d(basis.rows()));
  CHECK((force.head(k) - expected).norm() < 1e-10 * expected.norm());  // condition times rounding
  // -d.lambda - lambda.G.lambda / 2 at its maximum
  CHECK(basis.dual_energy() ==
        Approx(-0.5 * expected.dot(VectorXd(rows.d(basis.rows())))).epsilon(1e-11).margin(0));
}

}  // namespace

TEST_CASE("pairs that join and leave in any order leave the factor of the rest",
          "[active_set_factor]") {
  for (const bool columns : {true, false}) {
    Random random(3);
    const Rows rows = random_rows(random, 12, 9);
    ActiveSetFactor basis(columns ? 12 : 0, 9);
    ActiveSetFactor::Candidates first = candidates(rows, basis, {4, 1, 7, 2}, columns);
    CHECK(basis.append(first, ActiveSetFactor::Choice::All, 4) == 4);
    check_factor(rows, basis);
    ActiveSetFactor::Candidates second = candidates(rows, basis, {0, 8, 3}, columns);
    CHECK(basis.append(second, ActiveSetFactor::Choice::All, 3) == 3);
    check_factor(rows, basis);
    basis.remove({0, 3, 5});
    CHECK(basis.rows() == std::vector<Index>{1, 7, 0, 3});
    check_factor(rows, basis);
    if (columns) {
      const MatrixXd Q = basis.directions();
      CHECK((Q.transpose() * Q - MatrixXd::Identity(4, 4)).norm() < 1e-14);
    }
  }
}

TEST_CASE("the best gain joins first, and no pair that the others have opened",
          "[active_set_factor]") {
  // Pair 1 overlaps more, but pair 0 gains as much per energy; pressing 0 opens its twin 2.
  MatrixXd H(2, 3);
  H << 1, 0.6, 1, 0, 0.8, 0;
  const Rows rows{H, H.transpose() * H, Eigen::Vector3d(-2, -1, -0.5)};
  for (const bool columns : {true, false}) {
    ActiveSetFactor basis(columns ? 2 : 0, 3);
    ActiveSetFactor::Candidates all = candidates(rows, basis, {2, 1, 0}, columns);
    CHECK(basis.append(all, ActiveSetFactor::Choice::Violated, 3) == 1);
    CHECK(basis.rows() == std::vector<Index>{0});
    CHECK(all.gap(0) == Approx(1.5).epsilon(1e-15).margin(0));  // -0.5 + 2
    CHECK(all.gap(1) == Approx(0.2).epsilon(1e-14).margin(0));  // -1 + 0.6 * 2
  }
}

TEST_CASE("a pair that depends on the others does not join", "[active_set_factor]") {
  Random random(5);
  Rows rows = random_rows(random, 6, 4);
  rows.H.col(3) = (rows.H.col(0) - 2 * rows.H.col(1)).normalized();
  rows.G = rows.H.transpose() * rows.H;
  for (const bool columns : {true, false}) {
    ActiveSetFactor basis(columns ? 6 : 0, 4);
    ActiveSetFactor::Candidates all = candidates(rows, basis, {0, 1, 2, 3}, columns);
    CHECK(basis.append(all, ActiveSetFactor::Choice::All, 4) == 3);
    const ActiveSetFactor::Candidates last = candidates(rows, basis, {3}, columns);
    const ActiveSetFactor::Response response = basis.response(last);
    CHECK((rows.H.leftCols(3) * response.yield - rows.H.col(3)).norm() < 1e-14);
    CHECK(response.opening == 0);
  }
}

TEST_CASE("columns tell nearly parallel pairs apart, products do not", "[active_set_factor]") {
  for (const double angle : {1e-4, 1e-9}) {
    MatrixXd H(2, 2);
    H << 1, std::cos(angle), 0, std::sin(angle);
    const Rows rows{H, H.transpose() * H, Eigen::Vector2d(-1, -1 - angle)};
    ActiveSetFactor by_columns(2, 2);
    ActiveSetFactor::Candidates first = candidates(rows, by_columns, {0, 1}, true);
    CHECK(by_columns.append(first, ActiveSetFactor::Choice::All, 2) == 2);
    CHECK(by_columns.factor()(1, 1) == Approx(std::sin(angle)).epsilon(1e-15 / angle).margin(0));
    ActiveSetFactor by_products(0, 2);
    ActiveSetFactor::Candidates second = candidates(rows, by_products, {0, 1}, false);
    CHECK(by_products.append(second, ActiveSetFactor::Choice::All, 2) == (angle > 1e-5 ? 2 : 1));
  }
}

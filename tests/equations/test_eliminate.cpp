// Equations solved for unknowns, by hand.
#include "addons/equations/eliminate.hpp"
#include "signorini/core/random.hpp"
#include "catch_compat.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Numbers = std::vector<Index>;

namespace {

/// All rows as equations. \param rounding  of each right side
Eliminated eliminated(const MatrixXd& rows, const VectorXd& right, double rounding = 0,
                      Numbers own = {}) {
  Numbers which;
  for (Index k = 0; k < rows.rows(); ++k) which.push_back(k);
  own.resize(which.size(), -1);
  return eliminate(rows.sparseView(), right, VectorXd::Constant(right.size(), rounding), own, which);
}

Index pivot(const MatrixXd& row, Index own) {
  return eliminated(row, VectorXd::Zero(1), 0, {own}).unknown.front();
}

}  // namespace

TEST_CASE("a row is solved for what it names, or for its largest entry", "[eliminate]") {
  const MatrixXd row = Eigen::RowVector4d(0.2, 1, -3, 0);
  CHECK(pivot(row, -1) == 2);
  CHECK(pivot(row, 1) == 1);
  CHECK(pivot(row, 0) == 2);  // less than a tenth of the largest
  CHECK(pivot(row, 3) == 2);  // it has none of this
  CHECK(pivot(Eigen::RowVector3d(1, -2, 2), -1) == 1);
  CHECK(pivot(Eigen::RowVector3d(1, 2, 2 * (1 + 1e-15)), -1) == 1);  // as large up to rounding: the first
}

// u0 + u1 - 4 u2 = 1 and 2 u2 - u3 = 6: u2 = 3 + u3 / 2 goes into u0 = 1 - u1 + 4 u2 = 13 - u1 + 2 u3.
TEST_CASE("a solved unknown goes into the rows before it", "[eliminate]") {
  MatrixXd rows(2, 4);
  rows << 1, 1, -4, 0, 0, 0, 2, -1;
  const VectorXd right = Eigen::Vector2d(1, 6);
  const Eliminated solved = eliminated(rows, right, 0, {0, 2});
  CHECK(solved.unknown == Numbers{0, 2});
  MatrixXd by(2, 4);
  by << 0, -1, 0, 2, 0, 0, 0, 0.5;
  CHECK(MatrixXd(solved.by) == by);
  CHECK(VectorXd(solved.right * right) == Eigen::Vector2d(13, 3));
  // Solved for u2 first, the other one is u0 / 2 + u1 / 2 - u3 = 6.5.
  CHECK(eliminated(rows, right).unknown == Numbers{2, 3});
}

TEST_CASE("rows that others say are told from those that contradict", "[eliminate]") {
  MatrixXd rows(4, 3);
  rows << 1, -1, 0, 0, 1, -1, 2, 0, -2, 1, 1, 1;
  const Eliminated same = eliminated(rows, Eigen::Vector4d(3, 4, 14, 5));
  CHECK(same.repeated == Numbers{2});
  CHECK(same.contradicting.empty());
  CHECK(same.unknown.size() == 3);
  CHECK(MatrixXd(same.right).col(2).isZero(0));  // nothing depends on what was left out
  const Eliminated other = eliminated(rows, Eigen::Vector4d(3, 4, 14.001, 5));
  CHECK(other.repeated.empty());
  CHECK(other.contradicting == Numbers{2});
  CHECK(other.apart == Approx(0.001).epsilon(1e-9));
  CHECK((other.other == 0 || other.other == 1));
  // Rows that are no equations say nothing.
  const Eliminated some = eliminate(rows.sparseView(), Eigen::Vector4d(3, 4, 14.001, 5),
                                    Eigen::Vector4d::Zero(), Numbers(4, -1), {0, 1, 3});
  CHECK(some.contradicting.empty());
  CHECK(some.unknown.size() == 3);
}

// Of thirds and tenths the sums are rounded: what is left of the third row is no entry, and of its right side no contradiction.
TEST_CASE("rows that contradict by rounding alone repeat others", "[eliminate]") {
  MatrixXd rows(3, 3);
  rows << 0.1, 1.0 / 3, 0.7, 0.3, -0.1, 1.0 / 7, 0, 0, 0;
  rows.row(2) = rows.row(0) / 3 + rows.row(1) * 0.7;
  Eigen::Vector3d right(0.1, 0.7, 0.1 / 3 + 0.7 * 0.7);
  CHECK(eliminated(rows, right).repeated == Numbers{2});
  right(2) += 1e-14;
  CHECK(eliminated(rows, right).repeated == Numbers{2});
  right(2) += 1e-9;
  CHECK(eliminated(rows, right).contradicting == Numbers{2});
  CHECK(eliminated(rows, right, 1e-9).repeated == Numbers{2});
}

// A chain of rows, each with the next two unknowns, and a sum of some of them that is wrong: factors grow along the chain.
TEST_CASE("a row that contradicts a long chain of others is found", "[eliminate]") {
  const Index count = GENERATE(10, 30, 50, 100);
  CAPTURE(count);
  MatrixXd rows = MatrixXd::Zero(count + 1, count + 2);
  VectorXd right(count + 1);
  signorini::Random random(7);
  for (Index k = 0; k < count; ++k) {
    rows(k, k) = 1;
    rows(k, k + 1) = random.uniform(-1, 1);
    rows(k, k + 2) = random.uniform(-1, 1);
    right(k) = random.uniform(-1, 1);
  }
  VectorXd factor(count);
  for (double& one : factor) one = random.uniform(-1, 1);
  rows.row(count) = factor.transpose() * rows.topRows(count);
  right(count) = factor.dot(right.head(count));
  CHECK(eliminated(rows, right).repeated == Numbers{count});
  right(count) += 1e-6;
  CHECK(eliminated(rows, right).contradicting == Numbers{count});
}

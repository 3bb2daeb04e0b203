#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex5_1::Tableau;

// w1 - 2 z1 - z2 - z0 = -7, w2 - z1 - 2 z2 - z0 = -5, after z0 has come in for w1.
TEST_CASE("ex5.1 one pivot solves its row and clears the column", "[ex5.1]") {
  Tableau tableau{Eigen::MatrixXd(2, 6), {0, 1}};
  tableau.rows << 1, 0, -2, -1, -1, -7, 0, 1, -1, -2, -1, -5;
  ex5_1::pivot(tableau, 0, 4);
  CHECK(tableau.basic == std::vector<Index>{4, 1});
  Eigen::MatrixXd expected(2, 6);
  expected << -1, 0, 2, 1, 1, 7, -1, 1, 1, -1, 0, 2;
  CHECK(equal_within(tableau.rows, expected, 1e-14));
}

// z1 may grow until w2 (2 - z1) or z0 (7 - 2 z1) is zero.
TEST_CASE("ex5.1 the smallest ratio blocks", "[ex5.1]") {
  Tableau tableau{Eigen::MatrixXd(2, 6), {4, 1}};
  tableau.rows << -1, 0, 2, 1, 1, 7, -1, 1, 1, -1, 0, 2;
  CHECK(ex5_1::blocking_row(tableau, 2) == 1);
  CHECK(ex5_1::blocking_row(tableau, 3) == 0);   // only z0 falls when z2 grows
  CHECK(ex5_1::blocking_row(tableau, 0) == -1);  // nothing falls when w1 grows
}

// Three rows block at 2. Divided by their entries in column 3 the columns of w1 and w2 read (1, 0), (0, 5) and (1, -3).
TEST_CASE("ex5.1 a tie goes to the lexicographically smallest row", "[ex5.1]") {
  Tableau tableau{Eigen::MatrixXd::Zero(3, 8), {0, 1, 2}};
  tableau.rows.col(0) << 1, 0, 2;
  tableau.rows.col(1) << 0, 5, -6;
  tableau.rows.col(3) << 1, 1, 2;
  tableau.rows.col(7) << 2, 2, 4;
  CHECK(ex5_1::blocking_row(tableau, 3) == 1);
  tableau.rows(1, 7) = 3;  // the second row blocks later: the tie is between the others
  CHECK(ex5_1::blocking_row(tableau, 3) == 2);
}

// Both pairs touch as z0 falls to 1, and again when the problem is solved.
TEST_CASE("ex5.1 two pairs alike make ties on the way", "[ex5.1]") {
  const signorini::ContactProblem problem{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(),
                                          Eigen::Vector2d(-1, -1)};
  const ex5_1::Path path = ex5_1::drive(problem, VectorXd::Ones(2), 100);
  CHECK(path.solved);
  CHECK(equal_within(path.force, Eigen::Vector2d(1, 1) / 3, 1e-14));
}

// The two pairs of chapter 3: forces (3, 1).
TEST_CASE("ex5.1 two pairs", "[ex5.1]") {
  const signorini::ContactProblem problem{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(),
                                          Eigen::Vector2d(-7, -5)};
  const ex5_1::Path path = ex5_1::drive(problem, VectorXd::Ones(2), 100);
  CHECK(path.solved);
  CHECK(path.pivots == 3);
  CHECK(equal_within(path.force, Eigen::Vector2d(3, 1), 1e-13));
}

TEST_CASE("ex5.1 Fathi's problems take every basis", "[ex5.1]") {
  for (const Index n : {2, 3, 4, 5}) {
    const ex5_1::Path path = ex5_1::drive(signorini::fathi(n), VectorXd::Ones(n), 1000);
    CAPTURE(n);
    CHECK(path.solved);
    CHECK(path.pivots == 1 << n);
    CHECK(equal_within(path.force, VectorXd::Unit(n, 0), 1e-9));
  }
}

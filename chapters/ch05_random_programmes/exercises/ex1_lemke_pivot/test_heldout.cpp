#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex5_1::Tableau;

// Both rows block at 1. Divided by the entering entry they read (1/2, 0) and (0, 1): the second is smaller.
TEST_CASE("ex5.1 held out: ties go to the lexicographically smallest row", "[ex5.1]") {
  Tableau tableau{Eigen::MatrixXd(2, 6), {0, 1}};
  tableau.rows << 1, 0, 2, 5, -1, 2, 0, 1, 1, 5, -1, 1;
  CHECK(ex5_1::blocking_row(tableau, 2) == 1);
  tableau.rows.row(0).swap(tableau.rows.row(1));
  tableau.basic = {1, 0};
  CHECK(ex5_1::blocking_row(tableau, 2) == 0);
}

TEST_CASE("ex5.1 held out: of tied rows z_0 leaves", "[ex5.1]") {
  Tableau tableau{Eigen::MatrixXd(2, 6), {4, 1}};
  tableau.rows << 3, 0, 2, 0, 1, 2, -3, 1, 1, 0, 0, 1;  // z_0's row is lexicographically larger
  CHECK(ex5_1::blocking_row(tableau, 2) == 0);
}

// A tie at the start and one at the end. Every pair alone carries 1/3 of what closes all three.
TEST_CASE("ex5.1 held out: three pairs in a ring, all alike", "[ex5.1]") {
  Eigen::Matrix3d M;
  M << 1, 2, 0, 0, 1, 2, 2, 0, 1;
  const signorini::ContactProblem problem{M, Eigen::Vector3d(-1, -1, -1)};
  const ex5_1::Path path = ex5_1::drive(problem, VectorXd::Ones(3), 100);
  CHECK(path.solved);
  CHECK(equal_within(path.force, Eigen::Vector3d::Constant(1.0 / 3), 1e-13));
}

TEST_CASE("ex5.1 held out: random contact problems", "[ex5.1]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 200; ++sample) {
    const Index n = random.whole(1, 8);
    Eigen::MatrixXd B(n, n);
    VectorXd d(n);
    for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
    for (double& entry : d) entry = random.uniform(-1, 0.5);
    const signorini::ContactProblem problem{
        B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n), d};
    const ex5_1::Path path = ex5_1::drive(problem, VectorXd::Ones(n), 1000);
    CAPTURE(sample, n);
    REQUIRE(path.solved);
    const VectorXd gap = d + problem.compliance * path.force;
    CHECK(path.force.minCoeff() >= 0);
    CHECK(gap.minCoeff() >= -1e-10);
    CHECK(path.force.cwiseProduct(gap).cwiseAbs().maxCoeff() <= 1e-10);
  }
}

// Whole numbers: pairs that touch without force make ties all along the path.
TEST_CASE("ex5.1 held out: whole numbers, many ties", "[ex5.1]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 500; ++sample) {
    const Index n = random.whole(2, 6);
    Eigen::MatrixXd B(n, n);
    VectorXd d(n);
    for (double& entry : B.reshaped()) entry = random.whole(-1, 1);
    for (double& entry : d) entry = random.whole(-1, 0);
    const signorini::ContactProblem problem{B * B.transpose() + Eigen::MatrixXd::Identity(n, n), d};
    const ex5_1::Path path = ex5_1::drive(problem, VectorXd::Ones(n), 1000);
    CAPTURE(sample, n);
    REQUIRE(path.solved);
    const VectorXd gap = d + problem.compliance * path.force;
    CHECK(gap.minCoeff() >= -1e-10);
    CHECK(path.force.cwiseProduct(gap).cwiseAbs().maxCoeff() <= 1e-10);
  }
}

// One pair that nothing can close: force does not change the gap.
TEST_CASE("ex5.1 held out: a ray is no solution", "[ex5.1]") {
  const signorini::ContactProblem problem{Eigen::MatrixXd::Zero(1, 1), VectorXd::Constant(1, -1)};
  const ex5_1::Path path = ex5_1::drive(problem, VectorXd::Ones(1), 100);
  CHECK_FALSE(path.solved);
  CHECK(path.pivots == 1);
}

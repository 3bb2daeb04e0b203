// Programmes whose K has negative eigenvalues, and none where the equations hold.
#include <cmath>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/random.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using signorini_test::problem_message;

namespace {

/// (x^2 + y^2) / 2 + c x y - y with x + y = 1, y in units of which it has one of its own.
DenseProgramme coupled(double c, double unit) {
  DenseProgramme programme;
  programme.stiffness.resize(2, 2);
  programme.stiffness << 1, c * unit, c * unit, unit * unit;
  programme.load = Vector2d(0, unit);
  programme.A = Eigen::RowVector2d(1, unit);
  programme.initial_gap = VectorXd::Ones(1);
  programme.equations = 1;
  return programme;
}

MatrixXd drawn(Random& random, Index rows, Index columns) {
  return MatrixXd::NullaryExpr(rows, columns, [&] { return random.uniform(-1, 1); });
}

void check_solved(const DenseProgramme& programme) {
  const DenseSolution solution = solve(programme, find_solver("quasi_active_set"));
  REQUIRE(solution.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.holds());
}

}  // namespace

TEST_CASE("a negative curvature across the equations is no obstacle, however large",
          "[dense_programme]") {
  for (const char* solver :
       {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set", "lemke"})
    for (const double c : {-1.9, -2.0, -3.0, -10.0, -100.0, -1e6})
      for (const double unit : {1.0, 0x1p-20, 0x1p20}) {
        CAPTURE(solver, c, unit);
        const DenseSolution solution = solve(coupled(c, unit), find_solver(solver));
        REQUIRE(solution.report.status == SolveStatus::Solved);
        const double x = -c / (2 * (1 - c));
        CHECK(solution.refined.displacement(0) == Approx(x).epsilon(1e-14));
        CHECK(solution.refined.displacement(1) * unit == Approx(1 - x).epsilon(1e-14));
      }
}

TEST_CASE("an unknown with a negative stiffness may be held by an equation", "[dense_programme]") {
  DenseProgramme programme;
  programme.stiffness = Vector2d(-0.5, 1).asDiagonal();
  programme.load = Vector2d(0, 3);
  programme.A.resize(2, 2);
  programme.A << 1, 0, 1, 1;  // x = 1, x + y <= 2
  programme.initial_gap = Vector2d(1, 2);
  programme.equations = 1;
  const DenseSolution solution = solve(programme, find_solver("quasi_active_set"));
  REQUIRE(solution.report.status == SolveStatus::Solved);
  CHECK(solution.refined.displacement.isApprox(Vector2d(1, 1), 1e-15));
  CHECK(solution.refined.force.isApprox(Vector2d(-1.5, 2), 1e-14));
}

TEST_CASE("random programmes that are convex on their equations alone are solved",
          "[dense_programme]") {
  Random random(5);
  for (int sample = 0; sample < 40; ++sample) {
    CAPTURE(sample);
    const Index n = 6, equations = random.whole(1, 3);
    DenseProgramme programme;
    const MatrixXd half = drawn(random, n, n);
    const MatrixXd E = drawn(random, equations, n);
    programme.stiffness = half.transpose() * half + MatrixXd::Identity(n, n) -
                          std::pow(10, random.whole(0, 4)) * E.transpose() * E;
    programme.stiffness = (programme.stiffness + programme.stiffness.transpose()).eval() / 2;
    programme.load = drawn(random, n, 1);
    programme.A.resize(equations + 1, n);  // the last equation twice
    programme.A << E, E.bottomRows(1);
    programme.initial_gap = programme.A * drawn(random, n, 1);
    programme.equations = equations + 1;
    check_solved(programme);
  }
}

TEST_CASE("a K that is nothing along the equations and negative across them is solved in a box",
          "[dense_programme]") {
  Random random(8);
  for (int sample = 0; sample < 40; ++sample) {
    CAPTURE(sample);
    const Index n = 6, equations = random.whole(1, 3);
    const MatrixXd E = drawn(random, equations, n);
    const MatrixXd across = E.transpose() * drawn(random, equations, n);
    DenseProgramme programme;
    programme.stiffness = across + across.transpose() - random.uniform(0, 30) * E.transpose() * E;
    programme.load = drawn(random, n, 1);
    programme.A.resize(equations + 2 * n, n);  // -1 <= u <= 1
    programme.A << E, MatrixXd::Identity(n, n), -MatrixXd::Identity(n, n);
    programme.initial_gap = VectorXd::Ones(programme.A.rows());
    programme.initial_gap.head(equations) = E * drawn(random, n, 1);
    programme.equations = equations;
    check_solved(programme);
  }
}

TEST_CASE("what is not convex on its equations is refused", "[dense_programme]") {
  for (const double c : {1.5, 3.0, 100.0})  // along (1, -1) the curvature is 2 - 2 c
    CHECK_THAT(problem_message([&] {
                 static_cast<void>(solve(coupled(c, 1), find_solver("quasi_active_set")));
               }),
               ContainsSubstring("K is not positive definite"));
}

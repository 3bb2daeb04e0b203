// The safeguarded quasi-active set at the edges: stiffness without inverse, rows that only touch, and what
// counts as a proof.
#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/programme/active_set_programme.hpp"

using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

namespace {

const Solver& method() { return find_solver("quasi_active_set"); }

}  // namespace

TEST_CASE("a stiffness without inverse is refused, or held by equations", "[quasi_active_set]") {
  DenseProgramme programme{MatrixXd::Zero(2, 2), VectorXd::Zero(2), MatrixXd::Ones(1, 2),
                           VectorXd::Ones(1), 0};
  programme.stiffness << 2, -2, -2, 2;
  CHECK_THROWS_AS(quasi_active_set(programme), ProblemError);
  programme.equations = 1;  // u1 + u2 = 1 with least (u1 - u2)^2
  const DenseSolution solution = solve(programme, method());
  CHECK(solution.report.status == Status::Solved);
  CHECK((solution.refined.displacement - Eigen::Vector2d(0.5, 0.5)).norm() < 1e-15);
}

TEST_CASE("rows that only touch where others are closed are no contradiction",
          "[quasi_active_set][hard]") {
  // The last row depends on closed ones, and its overlap is the rounding of theirs.
  DenseProgramme three{3 * MatrixXd::Identity(2, 2), Eigen::Vector2d(6, 6), MatrixXd(3, 2),
                       Eigen::Vector3d(6, -4, 0)};
  three.A << 1, 2, -2, 0, 2, -2;  // the free minimum (2, 2) touches all of them
  DenseProgramme line{MatrixXd::Constant(1, 1, 6), VectorXd::Constant(1, -1), MatrixXd(2, 1),
                      Eigen::Vector2d(0, 0), 1};
  line.A << 1, -1;  // u = 0, and -u <= 0
  DenseProgramme zero{MatrixXd::Ones(1, 1), VectorXd::Ones(1), MatrixXd::Zero(1, 1),
                      VectorXd::Zero(1), 1};  // 0 u = 0
  for (const DenseProgramme& programme : {three, line, zero})
    for (const Solver& solver : solvers()) {
      if (may_fail(solver, Trait::Ordinary) || may_fail(solver, Trait::Dependent)) continue;
      CAPTURE(solver.name);
      CHECK(solve(programme, solver).report.status == Status::Solved);
    }
}

TEST_CASE("numbers prove a contradiction only if no displacement near by escapes it",
          "[quasi_active_set]") {
  DenseProgramme wedge{MatrixXd::Identity(1, 1), VectorXd::Zero(1), MatrixXd(2, 1),
                       Eigen::Vector2d(-1, 0.5)};
  wedge.A << 1, -1;  // u <= -1 and u >= -0.5
  const VectorXd u = VectorXd::Constant(1, -0.7);
  CHECK(proves_infeasible(wedge, Eigen::Vector2d(2, 2), u));
  CHECK_FALSE(proves_infeasible(wedge, Eigen::Vector2d(1, -1), u));     // a force that pulls
  CHECK_FALSE(proves_infeasible(wedge, Eigen::Vector2d(1, 0.999), u));  // u = -1000 escapes
  wedge.initial_gap << -1, 1;                                           // u = -1 does both
  CHECK_FALSE(proves_infeasible(wedge, Eigen::Vector2d(1, 1), u));
  for (const Solver& solver : solvers()) {
    const DenseSolution solution =
        solve({wedge.stiffness, wedge.load, wedge.A, Eigen::Vector2d(-1, 0.5), 0}, solver);
    CAPTURE(solver.name);
    CHECK(solution.report.status != Status::Solved);
    if (solution.report.status == Status::Infeasible) CHECK(solution.infeasibility.size() == 2);
  }
}

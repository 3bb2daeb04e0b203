// The safeguarded quasi-active set at the edges: stiffness without inverse, rows that only touch, and what
// counts as a proof.
#include "addons/programme/active_set_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"

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
  CHECK(solution.report.status == SolveStatus::Solved);
  CHECK((solution.refined.displacement - Eigen::Vector2d(0.5, 0.5)).norm() < 1e-15);
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
}

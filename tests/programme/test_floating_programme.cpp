#include <algorithm>
#include <string>

#include "addons/certified/solve_with_proofs.hpp"
#include "addons/programme/floating_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/floating.hpp"
#include "support/message.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {}  // namespace

TEST_CASE("a soft body and other units: the certificate stays, the iterations too",
          "[floating][units]") {
  const Solver& solver = find_solver("primal_dual_active_set");
  Random random(8);
  for (int sample = 0; sample < 40; ++sample) {
    const KnownFloating known = known_floating(random, 1e-8, 1);  // condition 1e8 without the modes
    const FloatingSolution solution = solve(known.programme, known.null_vectors, solver);
    CAPTURE(sample);
    REQUIRE(solution.dense.report.status == SolveStatus::Solved);
    CHECK(solution.dense.certificate.worst() <= 1e-12);

    ContactProblem problem = condense(known.programme, known.null_vectors).problem;
    const ContactState state = solve_with_proofs(problem, solver);
    REQUIRE(certify(problem, state).worst() <= 1e-12);
    const ContactProblem scaled = in_units({problem.compliance, problem.free_gap}, 0x1p20, 0x1p-20);
    problem.compliance = scaled.compliance;  // exact in binary
    problem.free_gap = scaled.free_gap;
    problem.rigid.col(0) *= 0x1p10;  // a mode in other units, too
    problem.resultant *= 0x1p-20;
    problem.resultant(0) *= 0x1p10;
    const ContactState other = solve_with_proofs(problem, solver);
    CHECK(other.report.iterations == state.report.iterations);
    CHECK(other.active() == state.active());
    CHECK((0x1p20 * other.force - state.force).norm() <= 1e-12 * state.force.norm());
  }
}

TEST_CASE("a bar of two springs pressed on a wall: force and sink in closed form",
          "[floating][closed-form]") {
  // Three nodes in a row, springs of stiffness 2 and 4, pushed by 3 at the far end; a wall 0.5 ahead.
  DenseProgramme row;
  row.stiffness.resize(3, 3);
  row.stiffness << 2, -2, 0, -2, 6, -4, 0, -4, 4;
  row.load = Eigen::Vector3d(3, 0, 0);
  row.A = Eigen::RowVector3d(0, 0, 1);
  row.initial_gap = VectorXd::Constant(1, 0.5);
  for (const double length : {1.0, 1000.0, -0.01}) {  // the length of a null vector says nothing
    const FloatingSolution solution =
        solve(row, VectorXd::Constant(3, length), find_solver("primal_dual_active_set"));
    REQUIRE(solution.dense.report.status == SolveStatus::Solved);
    CHECK(solution.dense.refined.force(0) == Approx(3).epsilon(1e-15));
    const Eigen::Vector3d u(0.5 + 0.75 + 1.5, 0.5 + 0.75, 0.5);
    CHECK((solution.dense.refined.displacement - u).norm() <= 1e-15 * u.norm());
    CHECK(solution.dense.certificate.worst() <= 1e-15);
  }
  row.load *= -1;
  const FloatingSolution away =
      solve(row, VectorXd::Ones(3), find_solver("primal_dual_active_set"));
  CHECK(away.dense.report.status == SolveStatus::Infeasible);
  REQUIRE(away.unbounded_direction.size() == 1);
  CHECK(away.unbounded_direction(0) < 0);  // away from the wall
}

TEST_CASE("null vectors that are none, repeat others or miss one are refused", "[floating]") {
  DenseProgramme two;  // two free springs: 1-2 and 3-4
  two.stiffness.setZero(4, 4);
  for (const Index i : {0, 2}) two.stiffness.block(i, i, 2, 2) << 1, -1, -1, 1;
  two.load = VectorXd::Ones(4);
  two.A = MatrixXd::Identity(2, 4);
  two.initial_gap = VectorXd::Ones(2);
  const auto complaint = [&](const MatrixXd& N) {
    return problem_message([&] { static_cast<void>(condense(two, N)); });
  };
  MatrixXd both(4, 2);
  both << 1, 0, 1, 0, 0, 1, 0, 1;
  CHECK(complaint(both).empty());
  CHECK_THAT(complaint(VectorXd::Unit(4, 0)),
             ContainsSubstring("column 1") && ContainsSubstring("no rigid mode"));
  MatrixXd stretched = both;
  stretched(1, 0) = 1 + 1e-15;  // rounding
  CHECK(complaint(stretched).empty());
  stretched(1, 0) = 1 + 1e-9;
  CHECK_THAT(complaint(stretched), ContainsSubstring("no rigid mode"));
  CHECK_THAT(complaint(VectorXd::Ones(4)), ContainsSubstring("not positive definite"));
  MatrixXd repeated(4, 2);
  repeated << 1, 2, 1, 2, 1, 2, 1, 2;
  CHECK_THAT(complaint(repeated), ContainsSubstring("dependent, of rank 1"));
  CHECK_THAT(argument_message([&] { static_cast<void>(condense(two, MatrixXd::Ones(3, 1))); }),
             ContainsSubstring("N have 4 rows"));
}

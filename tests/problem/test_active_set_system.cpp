// One unit for all rows, and the linear system of a known set.
#include <cmath>
#include <string>
#include <vector>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/problems.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using namespace signorini;

namespace {

Matrix2d matrix(double a, double b, double c, double d) {
  Matrix2d m;
  m << a, b, c, d;
  return m;
}

}  // namespace

TEST_CASE("equilibration gives a unit diagonal and goes back", "[active_set]") {
  const ContactProblem problem{matrix(4, 3, 3, 25), Vector2d(-8, 10)};
  const ScaledProblem scaled = equilibrate(problem);
  CHECK((scaled.compliance - matrix(1, 0.3, 0.3, 1)).norm() < 1e-15);
  CHECK((scaled.free - Vector2d(-4, 2)).norm() < 1e-15);
  const ContactState state =
      finished(problem, scaled, solve_active_set(scaled, ActiveSet{{0}}), statuses_of({0}, 2), {});
  CHECK((state.force - Vector2d(2, 0)).norm() < 1e-15);
  CHECK((state.gap - Vector2d(0, 16)).norm() < 1e-14);
}

TEST_CASE("the equilibrated problem does not know units or the scale of a row",
          "[active_set][units]") {
  signorini_test::Random random(4);
  const ContactProblem problem = signorini_test::random_problem(random, 5);
  const ScaledProblem scaled = equilibrate(problem);
  Eigen::VectorXd row(5);
  row << 0x1p-20, 0x1p20, 1, 0x1p10, 0x1p-5;  // powers of two: without rounding
  const ScaledProblem rows = equilibrate(signorini_test::with_rows(problem, row));
  CHECK((rows.compliance - scaled.compliance).norm() < 1e-15);
  CHECK((rows.free - scaled.free).norm() < 1e-15 * scaled.free.norm());
}

TEST_CASE("a row that no force moves has no unit of its own", "[active_set][units]") {
  const auto problem = [](double unit, const Eigen::MatrixXd& rigid) {
    Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
    F.topLeftCorner(2, 2) = matrix(2, 1, 1, 2);
    ContactProblem made{F, Eigen::Vector3d(-1, 0.3, 2 * unit)};
    made.rigid = rigid;
    made.resultant = Eigen::Vector2d(1.5, 0.4).head(rigid.cols());
    if (rigid.cols() > 0) made.rigid.row(2) *= unit;
    return made;
  };
  Eigen::Matrix<double, 3, 2> known;
  known << 1, 0, 1, 0, 1, 0.5;
  Eigen::Matrix<double, 3, 2> unknown;  // only the last row feels the second mode
  unknown << 1, 0, 1, 0, 0, 1;
  for (const Eigen::MatrixXd& rigid : {Eigen::MatrixXd(), Eigen::MatrixXd(known.leftCols(1)),
                                       Eigen::MatrixXd(known), Eigen::MatrixXd(unknown)}) {
    const ScaledProblem one = equilibrate(problem(1, rigid));
    for (const double unit : {0x1p-60, 0x1p-30, 0x1p30, 0x1p60}) {
      CAPTURE(rigid.cols(), unit);
      const ScaledProblem other = equilibrate(problem(unit, rigid));
      CHECK(other.compliance == one.compliance);
      CHECK(other.free == one.free);
      CHECK(other.rigid == one.rigid);
      CHECK(other.resultant == one.resultant);
      const ContactState state = solve_with_proofs(problem(unit, rigid), find_solver("lemke"));
      const ContactState same = solve_with_proofs(problem(1, rigid), find_solver("lemke"));
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK(state.report.iterations == same.report.iterations);
      CHECK(state.active() == same.active());
      CHECK(state.force.head(2) == same.force.head(2));
      CHECK(state.force(2) * unit == same.force(2));
    }
  }
}

TEST_CASE("closing pairs leaves no gap in them and no force elsewhere", "[active_set]") {
  signorini_test::Random random(6);
  const ContactProblem problem = signorini_test::random_problem(random, 7);
  const ScaledProblem scaled = equilibrate(problem);
  const std::vector<Eigen::Index> active = {1, 2, 5};
  const ActiveSetSolution closed = solve_active_set(scaled, ActiveSet{active});
  REQUIRE(closed.solvable);
  const Eigen::VectorXd gap = scaled.free + scaled.compliance * closed.force;
  for (const Eigen::Index i : {0, 3, 4, 6}) {
    CHECK(closed.force(i) == 0);
    CHECK(closed.movement(i) == Approx(gap(i)).epsilon(1e-12));
  }
  for (const Eigen::Index i : active) {
    CHECK(closed.movement(i) == 0);
    CHECK(std::abs(gap(i)) < 1e-14);
  }
}

TEST_CASE("a nearly singular block is solved to the last digits", "[active_set]") {
  // G_ij = 1 - |i - j| 2^-22 has a condition number of 1e8; forces are whole, so d is exact.
  const Eigen::Index n = 6;
  Eigen::MatrixXd G(n, n);
  Eigen::VectorXd force(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    force(i) = static_cast<double>(1 + i * i % 5);
    for (Eigen::Index j = 0; j < n; ++j)
      G(i, j) = 1 - static_cast<double>(std::abs(i - j)) * 0x1p-22;
  }
  const ActiveSetSolution closed =
      solve_active_set(equilibrate({G, -G * force}), ActiveSet{{0, 1, 2, 3, 4, 5}});
  REQUIRE(closed.solvable);
  CHECK((closed.force - force).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("of rows that repeat each other the first is kept, and closes the others if it can",
          "[active_set]") {
  const std::vector<ContactStatus> both = statuses_of({0, 1}, 2);
  const ScaledProblem same = equilibrate({matrix(1, 1, 1, 1), Vector2d(-1, -1)});
  for (const Eigen::Index first : {0, 1}) {
    const ActiveSetSolution kept = solve_active_set(same, ActiveSet{{first, 1 - first}});
    CHECK(kept.rows == std::vector<Eigen::Index>{first});
    CHECK(kept.force(first) == 1);
    CHECK(solves(same, both, kept));
  }
  const ScaledProblem apart = equilibrate({matrix(1, 1, 1, 1), Vector2d(-1, -0.5)});
  CHECK(solves(apart, statuses_of({0}, 2), solve_active_set(apart, ActiveSet{{0, 1}})));
  CHECK_FALSE(
      solves(apart, both, solve_active_set(apart, ActiveSet{{0, 1}})));  // the other is open
  const ScaledProblem nothing =
      equilibrate({Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Ones(1)});
  CHECK(solve_active_set(nothing, ActiveSet{{0}}).rows.empty());
}

TEST_CASE("a dependent block is found out, whatever rounding leaves of its last pivot",
          "[active_set]") {
  // Six rows of length 1 in a space of four dimensions: G is exact and singular, its factor is rounded.
  signorini_test::Random random(14);
  int found = 0;
  for (int sample = 0; sample < 200; ++sample) {
    Eigen::MatrixXd V(6, 4);
    for (Eigen::Index k = 0; k < V.size(); ++k) V.data()[k] = random.whole(0, 1) - 0.5;
    const ScaledProblem scaled = equilibrate({V * V.transpose(), -Eigen::VectorXd::Ones(6)});
    found += solve_active_set(scaled, ActiveSet{{0, 1, 2, 3, 4, 5}}).rows.size() < 6 ? 1 : 0;
  }
  CHECK(found == 200);
}

TEST_CASE("a singular block that rounding lets pass gives no solution", "[active_set]") {
  // Rows 0, 2 and 3 satisfy a_0 + (a_2 + a_3) / 2 = 0 and contradict each other: the last pivot is 2e-15,
  // the forces are 1e15, and gaps of the size of the overlaps are rounding.
  Eigen::Matrix3d G;
  G << 5, -5, -5, -5, 9, 1, -5, 1, 9;
  const ContactProblem problem{G, Eigen::Vector3d(-1, -4, 0)};
  const ScaledProblem scaled = equilibrate(problem);
  CHECK_FALSE(
      solves(scaled, statuses_of({0, 1, 2}, 3), solve_active_set(scaled, ActiveSet{{0, 1, 2}})));
  CHECK_FALSE(confirmed(scaled, {0, 1, 2}).has_value());
  CHECK(find_solver("enumerate").solve(problem, {}).report.status == SolveStatus::Infeasible);
  CHECK(find_solver("primal_dual_active_set").solve(problem, {}).report.status !=
        SolveStatus::Solved);
}

TEST_CASE("what is solved only before scaling back is not called solved", "[active_set][hard]") {
  // Both matrices are singular but for rounding; found among random problems.
  Eigen::MatrixXd first(4, 4);
  first << 10, 0, -5, -7, 0, 9, -2, -6, -5, -2, 10, 4, -7, -6, 4, 9;
  Eigen::MatrixXd second(5, 5);
  second << 7, -7, 6, 0, -1, -7, 14, -6, 3, -2, 6, -6, 17, 7, -5, 0, 3, 7, 14, -8, -1, -2, -5, -8,
      5;
  const ContactProblem problems[] = {{first, Eigen::Vector4d(-3, -1, 0, -3)},
                                     {second, (Eigen::VectorXd(5) << 0, 0, -1, -3, 0).finished()}};
  for (const ContactProblem& problem : problems)
    for (const char* name : {"primal_dual_active_set", "enumerate", "surrogate_dual"}) {
      const ContactState state = find_solver(name).solve(problem, {});
      if (state.report.status == SolveStatus::Solved) CHECK(certify(problem, state).holds());
    }
}

TEST_CASE("a system that is known for a set is factored no more", "[active_set]") {
  signorini_test::Random random(6);
  const ContactProblem problem = signorini_test::random_problem(random, 5);
  ScaledProblem scaled = equilibrate(problem);
  const ActiveSet set{{3, 0, 4}};
  const ActiveSetSolution first = solve_active_set(scaled, set);
  REQUIRE(first.system);
  CHECK(first.system->set.closed == set.closed);
  int solves = 0;
  ActiveSetSystem counted = *first.system;
  counted.solve = [&](const Eigen::VectorXd& top, const Eigen::VectorXd& bottom) {
    ++solves;
    return first.system->solve(top, bottom);
  };
  scaled.factored = std::make_shared<const ActiveSetSystem>(counted);
  CHECK(solve_active_set(scaled, set).force == first.force);
  CHECK(solves > 0);
  const ActiveSetSolution rising = solve_active_set(scaled, ActiveSet{{0, 3, 4}});  // all are independent
  CHECK((rising.force - first.force).norm() <= 1e-14 * first.force.norm());
  const int so_far = solves;
  CHECK(solve_active_set(scaled, ActiveSet{{0, 3}}).rows == std::vector<Eigen::Index>{0, 3});
  CHECK(solves == so_far);
}

TEST_CASE("of rows that repeat each other a known system keeps those that were first", "[active_set]") {
  ScaledProblem scaled = equilibrate({matrix(1, 1, 1, 1), Vector2d(-1, -1)});
  scaled.factored = solve_active_set(scaled, ActiveSet{{1, 0}}).system;
  CHECK(solve_active_set(scaled, ActiveSet{{1, 0}}).rows == std::vector<Eigen::Index>{1});
  CHECK(solve_active_set(scaled, ActiveSet{{0, 1}}).rows == std::vector<Eigen::Index>{0});
}

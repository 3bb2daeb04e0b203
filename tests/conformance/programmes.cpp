// Every solver from K, p, A, g to a certified solution, where the classes do not ask for it.
#include "addons/programme/dense_programme.hpp"
#include "addons/programme/floating_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/chosen.hpp"
#include "support/floating.hpp"

using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("every solver: rows that only touch where others are closed are no contradiction",
          "[conformance][hard]") {
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
    for (const Solver& solver : chosen(solvers())) {
      if (may_fail(solver, Trait::Ordinary) || may_fail(solver, Trait::Dependent)) continue;
      CAPTURE(solver.name);
      CHECK(solve(programme, solver).report.status == SolveStatus::Solved);
    }
}

TEST_CASE("every solver: rows that contradict each other are not solved, and refused with a proof",
          "[conformance]") {
  DenseProgramme wedge{MatrixXd::Identity(1, 1), VectorXd::Zero(1), MatrixXd(2, 1),
                       Eigen::Vector2d(-1, 0.5)};
  wedge.A << 1, -1;  // u <= -1 and u >= -0.5
  for (const Solver& solver : chosen(solvers())) {
    const DenseSolution solution = solve(wedge, solver);
    CAPTURE(solver.name);
    CHECK(solution.report.status != SolveStatus::Solved);
    if (solution.report.status == SolveStatus::Infeasible)
      CHECK(solution.farkas_certificate.size() == 2);
  }
}

TEST_CASE("every solver: floating bodies built backwards from their answer",
          "[conformance][floating]") {
  for (const Solver& solver : chosen(solvers())) {
    Random random(7);
    for (int sample = 0; sample < 40; ++sample) {
      const KnownFloating known = known_floating(random, 0.5, sample % 2 == 0 ? 1 : 100);
      if (solver.largest > 0 && solver.largest < known.force.size()) continue;
      const FloatingSolution solution = solve(known.programme, known.null_vectors, solver);
      CAPTURE(solver.name, sample);
      // Not those that leave even plain problems unsolved; springs raise the condition of G by 1e2 or more.
      const bool promised = !may_fail(solver, Trait::Ordinary) &&
                            !may_fail(solver, Trait::Several) && !may_fail(solver, Trait::Slow);
      if (!promised && solution.dense.report.status != SolveStatus::Solved) continue;
      REQUIRE(solution.dense.report.status == SolveStatus::Solved);
      CHECK(solution.dense.certificate.worst() <= 1e-13);
      CHECK((solution.dense.refined.displacement - known.displacement).norm() <=
            1e-11 * known.displacement.norm());
    }
  }
}

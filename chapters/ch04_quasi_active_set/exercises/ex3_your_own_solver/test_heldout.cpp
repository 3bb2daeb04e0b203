#include <cmath>
#include <stdexcept>
#include <string>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"
#include "support/problems.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

TEST_CASE("ex4.3 held out: random problems agree with the trial of all sets", "[ex4.3]") {
  const Solver solver = ex4_3::my_solver();
  Random random(99);
  for (int sample = 0; sample < 300; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(1, 9));
    const ContactState state = solver.solve(problem, {});
    const ContactState sure = enumerate(problem);
    CAPTURE(sample, problem.free_gap.size());
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.active() == sure.active());
    CHECK(equal_within(state.force, sure.force, 1e-12 * sure.force.norm()));
  }
}

TEST_CASE("ex4.3 held out: units and the scale of rows change no decision", "[ex4.3]") {
  const Solver solver = ex4_3::my_solver();
  Random random(5);
  for (int sample = 0; sample < 60; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(2, 12));
    Eigen::VectorXd row(problem.free_gap.size());
    for (Index i = 0; i < row.size(); ++i) row(i) = std::ldexp(1, random.whole(-30, 30));
    const ContactState plain = solver.solve(problem, {});
    const ContactState other = solver.solve(in_units(with_rows(problem, row), 0x1p20, 0x1p-30), {});
    CHECK(other.report.status == SolveStatus::Solved);
    CHECK(other.active() == plain.active());
    CHECK(other.report.iterations == plain.report.iterations);
  }
}

TEST_CASE("ex4.3 held out: the same bits again, a limit that is kept", "[ex4.3]") {
  const Solver solver = ex4_3::my_solver();
  const ContactState once = solver.solve(string_problem(40), {});
  CHECK(once.force == solver.solve(string_problem(40), {}).force);
  SolverOptions stop;
  stop.iteration_limit = 1;
  const ContactState stopped = solver.solve(string_problem(40), stop);
  CHECK(stopped.report.iterations <= 1);
  CHECK(std::string(to_string(stopped.report.status)) == "iteration limit");  // 40 pairs, one round
}

// Of two pairs that push each other open, the more the closer they come to being one pair turned round.
TEST_CASE("ex4.3 held out: what solves() does not confirm is not claimed", "[ex4.3]") {
  for (const double rest : {3e-6, 3e-7, 1e-7, 1e-8, 1e-9, 1e-10})
    for (const double second : {-0.3, -0.7, -2.0}) {
      CAPTURE(rest, second);
      const double almost = 1 - rest;
      const Eigen::Matrix2d G = (Eigen::Matrix2d() << 1, -almost, -almost, 1).finished();
      const ContactState state = ex4_3::my_solver().solve({G, Eigen::Vector2d(-1, second)}, {});
      CHECK(state.reason == "");
    }
}

TEST_CASE("ex4.3 held out: a bad problem is the caller's mistake", "[ex4.3]") {
  const Solver solver = ex4_3::my_solver();
  const Eigen::Matrix2d tilted = (Eigen::Matrix2d() << 1, 2, 0, 1).finished();
  CHECK_THROWS_AS(solver.solve({tilted, Eigen::Vector2d(-1, -1)}, {}), std::invalid_argument);
  CHECK_THROWS_AS(solver.solve({Eigen::Matrix2d::Identity(), Eigen::Vector3d(1, 1, 1)}, {}),
                  std::invalid_argument);
}

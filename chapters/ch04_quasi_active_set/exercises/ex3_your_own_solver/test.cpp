#include <algorithm>
#include <string>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"
#include "support/problem_classes.hpp"
#include "support/problems.hpp"

using namespace signorini;

TEST_CASE("ex4.3 two pairs that both close bear 2 and 1", "[ex4.3]") {
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  const ContactState state = ex4_3::my_solver().solve({G, Eigen::Vector2d(-5, -4)}, {});
  REQUIRE(std::string(to_string(state.report.status)) == "solved");
  CHECK(equal_within(state.force, Eigen::Vector2d(2, 1), 1e-14));
  CHECK(state.active() == std::vector<Eigen::Index>{0, 1});
}

TEST_CASE("ex4.3 three pairs that make whole groups run in circles", "[ex4.3]") {
  const ContactState state = ex4_3::my_solver().solve(signorini_test::cycling_problem(), {});
  REQUIRE(std::string(to_string(state.report.status)) == "solved");
  CHECK(equal_within(state.force, Eigen::Vector3d(0, 0.4, 0), 1e-14));
}

// Who can solve it may do so: finished() has looked at the certificate.
static std::string unless_honest(const ContactState& state) {
  const SolveStatus status = state.report.status;
  const bool honest = status == SolveStatus::Breakdown || status == SolveStatus::Solved;
  return honest ? "" : to_string(status);
}

// Step 5, end by end.
TEST_CASE("ex4.3 a limit and a set that cannot be closed have their statuses", "[ex4.3]") {
  const Solver solver = ex4_3::my_solver();
  SolverOptions one;
  one.iteration_limit = 1;
  const ContactState stopped = solver.solve(signorini_test::cycling_problem(), one);
  CHECK(std::string(to_string(stopped.report.status)) == "iteration limit");
  CHECK(stopped.report.iterations == 1);
  const ContactState twice =
      solver.solve({Eigen::Matrix2d::Ones(), Eigen::Vector2d(-1, -1)}, {});  // one stop, twice
  CHECK(unless_honest(twice) == "");
}

// Two pairs that push each other open. Their forces are a million times the load, and no pair is wrong beyond
// rounding. finished() takes back the claim that this is a solution, and says so in `reason`; solves() keeps
// you from making it.
TEST_CASE("ex4.3 no wrong pair is not yet a solution", "[ex4.3]") {
  const double almost = 1 - 1e-6;
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 1, -almost, -almost, 1).finished();
  const ContactState state = ex4_3::my_solver().solve({G, Eigen::Vector2d(-1, -0.5)}, {});
  CHECK(unless_honest(state) == "");
  CHECK(state.reason == "");
}

TEST_CASE("ex4.3 the conformance suite has no complaint", "[ex4.3]") {
  const Solver solver = ex4_3::my_solver();
  const std::vector<Trait> excuses = {Trait::Asymmetric, Trait::Dependent, Trait::Infeasible,
                                      Trait::IllConditioned};
  for (const Trait trait : solver.may_fail) {
    CAPTURE(to_string(trait));
    CHECK(std::count(excuses.begin(), excuses.end(), trait) == 1);
  }
  const std::string said = signorini_test::complaints(solver);
  CHECK(said == "");
}

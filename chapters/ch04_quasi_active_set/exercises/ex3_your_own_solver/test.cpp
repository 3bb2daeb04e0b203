#include <algorithm>
#include <string>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/problem_classes.hpp"
#include "support/problems.hpp"

using namespace signorini;

TEST_CASE("ex4.3 two pairs that both close bear 2 and 1", "[ex4.3]") {
  const Eigen::Matrix2d G = (Eigen::Matrix2d() << 2, 1, 1, 2).finished();
  const ContactState state = ex4_3::my_solver().solve({G, Eigen::Vector2d(-5, -4)}, {});
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Eigen::Vector2d(2, 1)).norm() < 1e-14);
  CHECK((state.active == std::vector<Eigen::Index>{0, 1}));
}

TEST_CASE("ex4.3 three pairs that make whole groups run in circles", "[ex4.3]") {
  const ContactState state = ex4_3::my_solver().solve(signorini_test::cycling_problem(), {});
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Eigen::Vector3d(0, 0.4, 0)).norm() < 1e-14);
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

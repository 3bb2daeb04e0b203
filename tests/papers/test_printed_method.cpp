// The steps of the paper's method on problems small enough to do by hand.
#include "catch_compat.hpp"
#include "papers/printed_method.hpp"
#include "papers/weight_iteration.hpp"

using Eigen::Vector3d;
using namespace signorini;

namespace {

// Three springs of their own; the first two overlap.
const ContactProblem springs{Eigen::Matrix3d::Identity(), Vector3d(-1, -2, 3)};
const Vector3d at(10, 20, 30);

}  // namespace

TEST_CASE("all violated rows of separate springs close in one step", "[printed_method]") {
  CHECK(outer_steps(run_quasi_active_set_literal(springs), at).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,quasi_active,closed\n0,10,1,1\n0,20,1,1\n");
}

TEST_CASE("a pair that overlaps but is lifted by its neighbour is in QAS and not closed",
          "[printed_method]") {
  const ContactProblem coupled{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(),
                               Eigen::Vector2d(-1, -3)};
  CHECK(outer_steps(run_quasi_active_set_literal(coupled), at.head(2)).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,quasi_active,closed\n0,10,1,0\n0,20,1,1\n");
}

TEST_CASE("one row at a time needs a step per spring, the largest overlap first",
          "[printed_method]") {
  const QuasiActiveRun run =
      run_quasi_active_set_literal(springs, {}, QuasiActiveRows::MostViolated);
  CHECK(outer_steps(run, at).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,quasi_active,closed\n"
        "0,10,0,0\n0,20,1,1\n1,10,1,1\n");
}

TEST_CASE("the weights take in the springs one after the other", "[printed_method]") {
  const auto supports = weight_supports(springs, WeightRule::FullyCorrective, 10);
  CHECK(supports == std::vector<std::vector<Eigen::Index>>{{1}, {0, 1}});
  CHECK(inner_steps(supports, at).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,joins\n0,20,1\n1,10,1\n1,20,0\n");
  CHECK(weight_supports(springs, WeightRule::FullyCorrective, 0).size() == 1);
}

TEST_CASE("the printed rule jumps between the springs and ends where it has been",
          "[printed_method]") {
  // The mean overlap is none, so the start is the pairs that overlap.
  CHECK(weight_supports(springs, WeightRule::LiteralVertex, 10) ==
        std::vector<std::vector<Eigen::Index>>{{0, 1}, {1}, {0}});
}

TEST_CASE("separate springs are solved in one step, and only by their own solution",
          "[printed_method]") {
  ContactState solution = run_quasi_active_set_literal(springs).state;
  CHECK(solved_in_one_step(springs, solution));
  solution.force(0) += 1e-6;
  CHECK_FALSE(solved_in_one_step(springs, solution));

  const PrintedMethod run = printed_method(springs);
  CHECK(run.group == std::vector<Eigen::Index>{0, 1});
  CHECK(run.jumps == 2);
  CHECK(run.one.outer_steps == 2);
  Results results("springs");
  add_counts(results, run, "_s");
  CHECK(results.value("overlaps_s") == 2);
  CHECK(results.value("weight_steps_s") == 1);
  CHECK(results.value("single_closed_s") == 2);
  CHECK_THROWS_AS(printed_method({Eigen::Matrix3d::Identity(), at}), std::invalid_argument);
}

TEST_CASE("steps without positions are refused", "[printed_method]") {
  CHECK_THROWS_AS(outer_steps(run_quasi_active_set_literal(springs), Vector3d(1, 2, 3).head(2)),
                  std::invalid_argument);
  CHECK_THROWS_AS(inner_steps({{3}}, at), std::invalid_argument);
}

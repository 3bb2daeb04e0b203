// The steps of the paper's method on problems small enough to do by hand.
#include "catch_compat.hpp"
#include "signorini/complementarity/weight_iteration.hpp"
#include "signorini/report/step_tables.hpp"

using Eigen::Vector3d;
using namespace signorini;

namespace {

// Three springs of their own; the first two overlap.
const ContactProblem springs{Eigen::Matrix3d::Identity(), Vector3d(-1, -2, 3)};
const Vector3d at(10, 20, 30);

}  // namespace

TEST_CASE("all violated rows of separate springs close in one step", "[step_tables]") {
  CHECK(outer_steps(run_quasi_active_set_literal(springs), at).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,quasi_active,closed\n0,10,1,1\n0,20,1,1\n");
}

TEST_CASE("one row at a time needs a step per spring, the largest overlap first", "[step_tables]") {
  const QuasiActiveRun run =
      run_quasi_active_set_literal(springs, {}, QuasiActiveRows::MostViolated);
  CHECK(outer_steps(run, at).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,quasi_active,closed\n"
        "0,10,0,0\n0,20,1,1\n1,10,1,1\n");
}

TEST_CASE("the weights take in the springs one after the other", "[step_tables]") {
  const auto supports = weight_supports(springs, WeightRule::FullyCorrective, 10);
  CHECK(supports == std::vector<std::vector<Eigen::Index>>{{1}, {0, 1}});
  CHECK(inner_steps(supports, at).csv() ==
        "# tolerance rel 1e-6 abs 1e-9\nstep,at,joins\n0,20,1\n1,10,1\n1,20,0\n");
  CHECK(weight_supports(springs, WeightRule::FullyCorrective, 0).size() == 1);
}

TEST_CASE("the printed rule jumps between the springs and ends where it has been",
          "[step_tables]") {
  // The mean overlap is none, so the start is the pairs that overlap.
  CHECK(weight_supports(springs, WeightRule::LiteralVertex, 10) ==
        std::vector<std::vector<Eigen::Index>>{{0, 1}, {1}, {0}});
}

TEST_CASE("steps without positions are refused", "[step_tables]") {
  CHECK_THROWS_AS(outer_steps(run_quasi_active_set_literal(springs), Vector3d(1, 2, 3).head(2)),
                  std::invalid_argument);
  CHECK_THROWS_AS(inner_steps({{3}}, at), std::invalid_argument);
}

// Which violated rows make up the quasi-active set, and when its loop ends.
#include <algorithm>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/quasi_active_set_literal.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/closest_point.hpp"
#include "support/problems.hpp"
#include "support/sample.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

constexpr QuasiActiveRows readings[] = {
    QuasiActiveRows::AllViolated, QuasiActiveRows::IndependentByIndex,
    QuasiActiveRows::IndependentByViolation, QuasiActiveRows::MostViolated};

bool contains(const std::vector<Index>& all, const std::vector<Index>& some) {  // both in order
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// The largest overlap that the last step met, over the first.
double last_overlap(const QuasiActiveRun& run) {
  const auto& history = run.state.report.history;
  const auto last = static_cast<std::size_t>(std::max<Index>(run.outer_steps, 1)) - 1;
  return history[last].penetration / history[0].penetration;
}

}  // namespace

// A loop that ends at a point comes from an overlap of its own size, one that goes to a limit from one
// of the size of the tolerance, 1e-12 of the first.
TEST_CASE("one step or never: with all violated rows a loop ends after one step or at its limit",
          "[literal]") {
  Index one = 0;
  Index never = 0;
  const auto check = [&](const ContactProblem& problem) {
    const QuasiActiveRun run = run_quasi_active_set_literal(problem);
    if (run.state.report.status == SolveStatus::Breakdown) CHECK(last_overlap(run) < 1e-9);
    if (run.state.report.status == SolveStatus::IterationLimit ||
        run.state.report.status == SolveStatus::Breakdown)
      return;
    CHECK(((run.outer_steps <= 1) != (last_overlap(run) < 1e-9)));
    if (run.outer_steps == 1)
      CHECK((run.optimal && run.state.report.status == SolveStatus::Solved));
    (run.outer_steps <= 1 ? one : never) += 1;
  };
  for (const auto& [n, m] : {std::pair<Index, Index>{10, 10}, {10, 40}, {20, 20}, {50, 25}})
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
      check(condense(rosen_suzuki(n, m, seed).programme).problem);
  Random random(2);
  for (int sample = 0; sample < 300; ++sample) check(eight_half_spaces(random).problem());
  CHECK((one > 200 && never > 200));  // both happen
}

TEST_CASE("a loop ends at a later step only if the last step but one left a violated row out",
          "[literal]") {
  Random random(3);
  int later = 0;
  bool subsets = true;
  for (int sample = 0; sample < 300; sample += sample_step) {
    const ContactProblem problem = eight_half_spaces(random).problem();
    for (const QuasiActiveRows choice : readings) {
      const QuasiActiveRun run = run_quasi_active_set_literal(problem, {}, choice);
      for (const QuasiActiveStep& step : run.steps) {
        subsets = subsets && !step.quasi_active.empty() &&
                  contains(step.violated, step.quasi_active) &&
                  contains(step.quasi_active, step.closed);
        const std::size_t most = choice == QuasiActiveRows::AllViolated    ? 8
                                 : choice == QuasiActiveRows::MostViolated ? 1
                                                                           : 3;
        subsets = subsets && step.quasi_active.size() <= most;  // three unknowns
      }
      const bool ended = run.state.report.status == SolveStatus::Solved ||
                         run.state.report.status == SolveStatus::Feasible;
      if (!ended || run.outer_steps < 2 || last_overlap(run) < 1e-9) continue;
      const QuasiActiveStep& last_but_one = run.steps[run.steps.size() - 2];
      CHECK(last_but_one.quasi_active != last_but_one.violated);
      ++later;
    }
  }
  CHECK(subsets);
  CHECK(later > 50 / sample_step);
}

TEST_CASE("two walls taken one at a time need two steps", "[literal][closed-form]") {
  const ClosestPoint plane{Eigen::Matrix2d::Identity(), Vector2d(2, 1), Vector2d::Zero()};
  const QuasiActiveRun run =
      run_quasi_active_set_literal(plane.problem(), {}, QuasiActiveRows::MostViolated);
  REQUIRE(run.outer_steps == 2);
  CHECK(run.steps[0].quasi_active == std::vector<Index>{0});
  CHECK(run.steps[1].quasi_active == std::vector<Index>{1});
  CHECK((run.optimal && run.state.report.status == SolveStatus::Solved));
  CHECK(run.state.force == Vector2d(2, 1));
}

// Both in exact fractions: u^2 by projection, then the tight rows and how far they may be followed.
TEST_CASE("loops that leave violated rows out end after two steps, and not at the optimum",
          "[literal][closed-form]") {
  ClosestPoint plane{Eigen::MatrixXd(3, 2), Vector2d(1, 0), Vector3d::Zero()};
  plane.A << 1, -1, 2, -1, 1, 1;
  ClosestPoint space{Eigen::MatrixXd(4, 3), Vector3d(0, 3, 1), Eigen::Vector4d::Zero()};
  space.A << -2, 2, 1, -1, 2, 0, 1, 2, 2, 1, 2, -2;  // its optimum is 0 as well
  for (const QuasiActiveRows choice : readings) {
    CAPTURE(static_cast<int>(choice));
    const QuasiActiveRun flat = run_quasi_active_set_literal(plane.problem(), {}, choice);
    const QuasiActiveRun deep = run_quasi_active_set_literal(space.problem(), {}, choice);
    CHECK(flat.state.report.status == SolveStatus::Solved);
    if (choice == QuasiActiveRows::AllViolated) {
      CHECK((flat.outer_steps == 1 && deep.outer_steps == 1));
      CHECK(deep.state.report.status == SolveStatus::Solved);
      continue;
    }
    CHECK((flat.outer_steps == 2 && deep.outer_steps == 2));
    CHECK((!flat.optimal && !deep.optimal));
    CHECK(flat.fraction == Approx(1 / 6.0).epsilon(1e-14));  // and (35) is the optimum
    CHECK(plane.displacement(flat.state).norm() < 1e-15);
    CHECK(deep.state.report.status == SolveStatus::Feasible);
    const bool single = choice == QuasiActiveRows::MostViolated;
    CHECK(deep.fraction == Approx(single ? 1 / 36.0 : 2 / 155.0).epsilon(1e-13));
    const Vector3d end = single ? Vector3d(2 / 3.0, -1 / 3.0, 0) : Vector3d(18, -9, 0) / 155;
    CHECK((space.displacement(deep.state) - end).norm() < 1e-14);
  }
  CHECK(space.displacement(enumerate(space.problem())).norm() < 1e-14);
}

TEST_CASE("independent rows leave out those that depend on the ones before", "[literal]") {
  ClosestPoint plane{Eigen::MatrixXd(4, 2), Vector2d(2, 3), Eigen::Vector4d(1, 0, 2, 9)};
  plane.A << 1, 0, 2, 0, 0, 1, 1, 1;  // two walls at x = 1 and 0, one at y = 2, and one far away
  const struct {
    QuasiActiveRows choice;
    std::vector<Index> quasi_active, closed;
    Index steps;
  } first_steps[] = {{QuasiActiveRows::AllViolated, {0, 1, 2}, {1, 2}, 1},
                     {QuasiActiveRows::IndependentByIndex, {0, 2}, {0, 2}, 2},
                     {QuasiActiveRows::IndependentByViolation, {1, 2}, {1, 2}, 1},
                     {QuasiActiveRows::MostViolated, {1}, {1}, 2}};
  for (const auto& [choice, quasi_active, closed, steps] : first_steps) {
    const QuasiActiveRun run = run_quasi_active_set_literal(plane.problem(), {}, choice);
    CAPTURE(static_cast<int>(choice));
    REQUIRE(run.steps.size() == static_cast<std::size_t>(run.outer_steps));
    CHECK((run.steps[0].violated == std::vector<Index>{0, 1, 2}));
    CHECK(run.steps[0].quasi_active == quasi_active);
    CHECK(run.steps[0].closed == closed);
    CHECK(run.state.report.status == SolveStatus::Solved);
    CHECK(plane.displacement(run.state) == Vector2d(0, 2));
    CHECK(run.outer_steps == steps);
    CHECK(run.optimal);
  }
}

// What each reading of the printed method ends with, on problems by hand; and shares of random programmes.
#include "../chapters/ch05_random_programmes/readings.hpp"
#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/method_readings.hpp"
#include "support/closest_point.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

// Two half-planes y <= 0 and x <= y, from (1, 2): the loop goes to (1, 0), (1/2, 1/2), (1/2, 0), ...
const ClosestPoint corner{(Eigen::Matrix2d() << 0, 1, 1, -1).finished(), Vector2d(1, 2),
                          Vector2d(0, 0)};

}  // namespace

TEST_CASE("each row once: the zigzag ends after two steps, with the first row violated again",
          "[readings][closed-form][XuanLi2002-32][XuanLi2002-34][XuanLi2002-35]") {
  const QuasiActiveRun run = run_quasi_active_set_literal(
      corner.problem(), {}, QuasiActiveRows::AllViolated, QuasiActivePool::UnusedPairs);
  REQUIRE(run.outer_steps == 2);
  CHECK(run.steps[0].quasi_active == std::vector<Index>{0});
  CHECK(run.steps[1].quasi_active == std::vector<Index>{1});
  CHECK((run.moved - Vector2d(2, 0.5)).norm() < 1e-15);  // u^2 = (1/2, 1/2)
  // Only row 2 is tight there, and it is open at u^0: (33) leads back to u^0, where row 1 overlaps by 2. On that way it
  // overlaps by 1/2 + 3/2 t, and (34) says t = -1/3: backwards, to where it does not overlap.
  CHECK(run.tight == std::vector<Index>{1});
  CHECK(run.next.norm() == 0);
  CHECK(run.left_over == std::vector<Index>{0});
  CHECK(run.fraction == Approx(-1 / 3.0).epsilon(1e-14));
  CHECK((run.state.force - Vector2d(8, 2) / 3).norm() < 1e-14);
  CHECK(run.state.gap(1) == Approx(-1 / 3.0).epsilon(1e-13));  // and row 2 overlaps
  CHECK(run.state.report.status == SolveStatus::IterationLimit);
  // No row is met on the way to u^0, so all of it is gone.
  CHECK(last_step_to_open_pairs(corner.problem(), run).norm() == 0);
}

TEST_CASE("each row once: a loop of one step is the solution as before", "[readings]") {
  const ContactProblem apart{Eigen::Matrix3d::Identity(), Vector3d(-1, -2, 3)};
  const QuasiActiveRun run = run_quasi_active_set_literal(apart, {}, QuasiActiveRows::AllViolated,
                                                          QuasiActivePool::UnusedPairs);
  CHECK(run.outer_steps == 1);
  CHECK(run.state.report.status == SolveStatus::Solved);
  CHECK(run.state.force == Vector3d(1, 2, 0));
}

// The way to u^{k+1} meets row 1 of the fan, after a sixth of it: there the reading is the one that is printed.
TEST_CASE("where u^k overlaps nowhere, the last step to open pairs is that of the paper",
          "[readings][closed-form][XuanLi2002-34]") {
  ClosestPoint fan{Eigen::MatrixXd(3, 2), Vector2d(1, 0), Vector3d::Zero()};
  fan.A << 1, -1, 2, -1, 1, 1;
  const QuasiActiveRun run =
      run_quasi_active_set_literal(fan.problem(), {}, QuasiActiveRows::MostViolated);
  CHECK(run.fraction == Approx(1 / 6.0).epsilon(1e-14));
  const VectorXd force = last_step_to_open_pairs(fan.problem(), run);
  CHECK((Vector2d(1, 0) - fan.A.transpose() * force).norm() < 1e-14);
}

// From (1/2, 1/2) the harmonic steps have the lengths 1, 2/3, 1/2: weights 1, 1/3, 2/3 of the first pair (table of chapter 3).
TEST_CASE("weights stop where they are told", "[readings][closed-form][XuanLi2002-28]") {
  const ContactProblem two{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-7, -5)};
  const auto first = [&](WeightRule rule, Index steps) {
    const VectorXd force = stopped_weights(two, rule, steps);
    return force(0) / force.sum();
  };
  CHECK(first(WeightRule::Harmonic, 0) == 0.5);
  CHECK(first(WeightRule::Harmonic, 1) == 1);
  CHECK(first(WeightRule::Harmonic, 2) == Approx(1 / 3.0).epsilon(1e-15));
  CHECK(first(WeightRule::Harmonic, 3) == Approx(2 / 3.0).epsilon(1e-15));
  CHECK((stopped_weights(two, WeightRule::LineSearch, 1) - Vector2d(3, 1)).norm() < 1e-14);
  CHECK((stopped_weights(two, WeightRule::LiteralVertex, 9) - Vector2d(0, 2.5)).norm() < 1e-15);
}

TEST_CASE("weights compare pairs in the units of the problem, as (28) does", "[readings]") {
  // Equal weights leave the overlaps (30 - 31.7, 2 - 0.3). With the first row ten times as short, (3 - 2.5, 2 - 2.5).
  const ContactProblem pairs{Vector2d(100, 1).asDiagonal().toDenseMatrix(), Vector2d(-30, -2)};
  CHECK((stopped_weights(pairs, WeightRule::LiteralVertex, 1) - Vector2d(0, 2)).norm() < 1e-15);
  const ContactProblem scaled{Eigen::Matrix2d::Identity(), Vector2d(-3, -2)};
  CHECK((stopped_weights(scaled, WeightRule::LiteralVertex, 1) - Vector2d(3, 0)).norm() < 1e-15);
}

TEST_CASE("the loop with weights that stop early ends with no overlap above its tolerance",
          "[readings]") {
  for (const double tolerance : {1e-2, 1e-4}) {
    const VectorXd force = loop_of_stopped_weights(corner.problem(), 1000, tolerance);
    const VectorXd gap = corner.problem().free_gap + corner.problem().compliance * force;
    CHECK(force.minCoeff() >= 0);
    CHECK(gap.minCoeff() >= -2 * tolerance);
    CHECK(gap.minCoeff() < -2 * tolerance / 4);  // each pair of steps halves it
  }
}

// Why the sign tells: forces of one weighted gap have at most the energy of the solution, those of a loop that ends where
// nothing overlaps have at least this.
TEST_CASE("stopped weights have less energy than the solution, loops that end feasible have more",
          "[readings]") {
  int below = 0, above = 0;
  for (const auto draw : {rosen_suzuki, whole_number_programme})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const KnownProgramme known = draw(10, 20, seed);
      const ContactProblem problem = condense(known.programme).problem;
      const auto work = [&](const VectorXd& force) {
        return 0.5 * force.dot(problem.compliance * force);
      };
      const double best = work(known.force);
      const double stopped = work(stopped_weights(problem, WeightRule::Harmonic, 100));
      CHECK(stopped <= best * (1 + 1e-12));
      below += stopped < best * (1 - 1e-9) ? 1 : 0;
      const QuasiActiveRun loop = run_quasi_active_set_literal(problem);
      if (loop.state.report.status != SolveStatus::Feasible) continue;
      CHECK(work(loop.state.force) > best * (1 + 1e-9));
      ++above;
    }
  CHECK(below > 8);  // more than half of 16
  CHECK(above > 0);  // some: otherwise nothing was tested
}

TEST_CASE("a ratio counts by its sign, and by its size from a tenth to ten times", "[readings]") {
  ch05::Counts counts;
  counts.add(1e-5, 1e-4);
  counts.add(1e-5, -2e-5);
  counts.add(1e-5, 2e-4);
  counts.add(1e-5, 0);
  CHECK((counts.above == 2 && counts.below == 1 && counts.none == 1));
  CHECK((counts.sign == 2 && counts.size == 2 && counts.both == 1));
  CHECK(counts.percent(counts.both) == 25);
  CHECK(ch05::at_share({3, 1, 2}, 0.5) == 2);
}

// The table of the chapter, on a tenth of its programmes.
TEST_CASE("shares of a size are those of a run again, and only stopped weights have the sign",
          "[readings]") {
  ch05::Counts stopped, loop;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<double> ratios = ch05::deviations(rosen_suzuki(20, 20, seed));
    REQUIRE(ratios.size() == 11);
    CHECK(ch05::deviations(rosen_suzuki(20, 20, seed)) == ratios);
    loop.add(1.4e-4, ratios[1]);
    stopped.add(1.4e-4, ratios[9]);
  }
  CHECK(loop.below + loop.none == 10);
  CHECK(loop.below > 0);  // some: otherwise the loop was right
  CHECK(stopped.sign == 10);
}

#include "catch_compat.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"
#include "signorini/solvers/solvers.hpp"
#include "support/whole_numbers.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Three directions in a plane, the first between the others.
HalfProblem fan() {
  MatrixXd H(2, 3);
  H << 1, 0.8, 0.8, 0, 0.6, -0.6;
  return {H, Vector3d(-1, -0.9, -0.9)};
}

}  // namespace

TEST_CASE("the pair that overlaps most may have to leave again", "[goldfarb_idnani][closed-form]") {
  // The outer two pairs carry 0.9 / 1.28 each and lift the first one by 1.44 / 1.28 - 1.
  for (const bool half : {false, true}) {
    CAPTURE(half);
    const ContactState state =
        half ? goldfarb_idnani(fan()) : goldfarb_idnani(multiplied_out(fan()));
    REQUIRE(state.report.status == Status::Solved);
    CHECK((state.force - Vector3d(0, 0.703125, 0.703125)).norm() < 1e-15);
    CHECK((state.gap - Vector3d(0.125, 0, 0)).norm() < 1e-15);
    CHECK(state.active == std::vector<Index>{1, 2});
    CHECK(state.report.iterations == 4);  // the first, a second, the first leaves, the third
    REQUIRE(state.report.history.size() == 4);
    CHECK(state.report.history.back().changes == 0);
    CHECK(state.report.history.back().dual_energy == Approx(0.6328125).epsilon(1e-14));
  }
}

TEST_CASE("the dual energy grows whenever a pair has closed", "[goldfarb_idnani]") {
  Random random(3);
  Index longest = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const HalfProblem problem = whole_problem(random);
    const ContactState state = goldfarb_idnani(problem);
    const std::vector<Iteration>& history = state.report.history;
    for (std::size_t k = 1; k < history.size(); ++k)
      CHECK(history[k].dual_energy > history[k - 1].dual_energy);
    longest = std::max(longest, state.report.iterations);
  }
  CHECK(longest > 5);  // the sample is not trivial
}

TEST_CASE("2000 problems in whole numbers, solved or proved infeasible, G given or H",
          "[goldfarb_idnani][hard]") {
  Random random(12);
  int solved = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    const HalfProblem half = whole_problem(random);
    const ContactProblem problem = multiplied_out(half);
    CAPTURE(sample, problem.free_gap.size());
    const ContactState given = goldfarb_idnani(problem);
    const ContactState product = goldfarb_idnani(half);
    CHECK(given.report.iterations <= 3 * problem.free_gap.size());
    CHECK(product.report.iterations <= 3 * problem.free_gap.size());
    solved += agrees_with_enumeration(problem, given) ? 1 : 0;
    if (product.report.status == Status::Breakdown)  // only if no rounded forces are good enough
      CHECK(product.force.sum() > 100);
    else
      agrees_with_enumeration(problem, product);
  }
  CHECK(solved > 1000);
  CHECK(solved < 1900);
}

TEST_CASE("gap rows that contradict each other are proved to", "[goldfarb_idnani][closed-form]") {
  // Pressing one pair opens the other as much: y = (1, 1) / 2, and no force changes the sum of the gaps.
  MatrixXd H(1, 2);
  H << 1, -1;
  const ContactState state = goldfarb_idnani(HalfProblem{H, Vector2d(-1, -0.5)});
  CHECK(state.report.status == Status::Infeasible);
  CHECK((state.infeasibility - Vector2d(0.5, 0.5)).norm() < 1e-15);
  const ContactState fixed = goldfarb_idnani(
      ContactProblem{MatrixXd::Zero(1, 1), VectorXd::Constant(1, -1)});  // nothing moves the pair
  CHECK(fixed.report.status == Status::Infeasible);
  CHECK(fixed.infeasibility == VectorXd::Ones(1));
}

TEST_CASE("nearly parallel pairs, with forces that are large and nearly cancel",
          "[goldfarb_idnani][hard]") {
  // Columns (1, 0) and (-1, t) almost against each other: to close both, H lambda must be (1, 1), so that
  // the forces are 1 + 1/t and 1/t.
  const double t = 1.0 / 512;  // a power of two: H, d and the answer are exact
  MatrixXd H(2, 2);
  H << 1, -1, 0, t;
  const HalfProblem problem{H, Vector2d(-1, 1 - t)};
  for (const bool half : {false, true}) {
    CAPTURE(half);
    const ContactState state =
        half ? goldfarb_idnani(problem) : goldfarb_idnani(multiplied_out(problem));
    REQUIRE(state.report.status == Status::Solved);
    CHECK((state.force - Vector2d(513, 512)).norm() <=
          1e-7);  // rounding times condition 1e6, times 700
    CHECK(certify(multiplied_out(problem), state).worst() <= 1e-12);
  }
}

TEST_CASE("more unknowns than pairs: H is replaced by its triangle", "[goldfarb_idnani]") {
  Random random(21);
  for (int sample = 0; sample < 50; ++sample) {
    HalfProblem problem{MatrixXd(30, 6), VectorXd(6)};
    for (Index k = 0; k < problem.half.size(); ++k) problem.half.data()[k] = random.uniform(-1, 1);
    for (Index i = 0; i < 6; ++i) problem.free_gap(i) = random.uniform(-1, 1);
    CAPTURE(sample);
    CHECK(agrees_with_enumeration(multiplied_out(problem), goldfarb_idnani(problem)));
  }
}

TEST_CASE("neither the scale of rows nor units change the number of steps",
          "[goldfarb_idnani][units]") {
  Random random(7);
  for (int sample = 0; sample < 200; ++sample)
    CHECK(changes_with_scale(random, [](const ContactProblem& p) { return goldfarb_idnani(p); }) ==
          0);
}

TEST_CASE("Goldfarb and Idnani's method finds the solution of every size of Table 1",
          "[goldfarb_idnani]") {
  solves_table_1(find_solver("goldfarb_idnani"));
}

TEST_CASE("a limit on steps is kept and reported", "[goldfarb_idnani]") {
  const ContactState state = goldfarb_idnani(fan(), {2});
  CHECK(state.report.status == Status::IterationLimit);
  CHECK(state.report.iterations == 2);
  CHECK_THROWS_AS(goldfarb_idnani(HalfProblem{MatrixXd::Zero(2, 3), Vector2d(0, 0)}),
                  std::invalid_argument);
}

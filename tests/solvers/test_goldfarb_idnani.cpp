#include "addons/programme/active_set_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/whole_numbers.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// K = I and no load: G = A A^T and d = g.
DenseProgramme programme(const MatrixXd& A, const VectorXd& gap) {
  return {MatrixXd::Identity(A.cols(), A.cols()), VectorXd::Zero(A.cols()), A, gap, 0};
}

/// Three directions in a plane, the first between the others.
DenseProgramme fan() {
  MatrixXd A(3, 2);
  A << 1, 0, 0.8, 0.6, 0.8, -0.6;
  return programme(A, Vector3d(-1, -0.9, -0.9));
}

}  // namespace

TEST_CASE("the pair that overlaps most may have to leave again", "[goldfarb_idnani][closed-form]") {
  // The outer two pairs carry 0.9 / 1.28 each and lift the first one by 1.44 / 1.28 - 1.
  const ContactState given = goldfarb_idnani(whole_problem(fan()));
  const DenseSolution product = goldfarb_idnani(fan());
  CHECK((product.refined.force - given.force).norm() < 1e-15);
  CHECK(product.active == given.active());
  CHECK(product.report.iterations == given.report.iterations);
  {
    const ContactState& state = given;
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK((state.force - Vector3d(0, 0.703125, 0.703125)).norm() < 1e-15);
    CHECK((state.gap - Vector3d(0.125, 0, 0)).norm() < 1e-15);
    CHECK(state.active() == std::vector<Index>{1, 2});
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
    const ContactProblem problem = whole_problem(random);
    const ContactState state = goldfarb_idnani(problem);
    const std::vector<Iteration>& history = state.report.history;
    for (std::size_t k = 1; k < history.size(); ++k)
      CHECK(history[k].dual_energy > history[k - 1].dual_energy);
    longest = std::max(longest, state.report.iterations);
  }
  CHECK(longest > 5);  // the sample is not trivial
}

TEST_CASE("2000 problems in whole numbers, solved or proved infeasible, condensed or not",
          "[goldfarb_idnani][hard]") {
  Random random(12);
  int solved = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    const DenseProgramme whole = whole_programme(random);
    const ContactProblem problem = whole_problem(whole);
    CAPTURE(sample, problem.free_gap.size());
    const ContactState given = goldfarb_idnani(problem);
    CHECK(given.report.iterations <= 3 * problem.free_gap.size());
    const bool solvable = agrees_with_enumeration(problem, given);
    solved += solvable ? 1 : 0;
    const DenseSolution product = solve(whole, find_solver("goldfarb_idnani"));
    CHECK(product.report.iterations <= 3 * problem.free_gap.size());
    CHECK(product.report.status == (solvable ? SolveStatus::Solved : SolveStatus::Infeasible));
  }
  CHECK(solved > 1000);
  CHECK(solved < 1900);
}

TEST_CASE("gap rows that contradict each other are proved to", "[goldfarb_idnani][closed-form]") {
  // Pressing one pair opens the other as much: y = (1, 1) / 2, and no force changes the sum of the gaps.
  MatrixXd G(2, 2);
  G << 1, -1, -1, 1;
  const ContactState state = goldfarb_idnani(ContactProblem{G, Vector2d(-1, -0.5)});
  CHECK(state.report.status == SolveStatus::Infeasible);
  CHECK((state.farkas_certificate - Vector2d(0.5, 0.5)).norm() < 1e-15);
  const ContactState fixed = goldfarb_idnani(
      ContactProblem{MatrixXd::Zero(1, 1), VectorXd::Constant(1, -1)});  // nothing moves the pair
  CHECK(fixed.report.status == SolveStatus::Infeasible);
  CHECK(fixed.farkas_certificate == VectorXd::Ones(1));
}

TEST_CASE("nearly parallel pairs, with forces that are large and nearly cancel",
          "[goldfarb_idnani][hard]") {
  // Columns (1, 0) and (-1, t) almost against each other: to close both, H lambda must be (1, 1), so that
  // the forces are 1 + 1/t and 1/t.
  const double t = 1.0 / 512;  // a power of two: H, d and the answer are exact
  MatrixXd A(2, 2);
  A << 1, 0, -1, t;
  const DenseProgramme given = programme(A, Vector2d(-1, 1 - t));
  const ContactState state = goldfarb_idnani(whole_problem(given));
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Vector2d(513, 512)).norm() <=
        1e-7);  // rounding times condition 1e6, times 700
  CHECK(certify(whole_problem(given), state).worst() <= 1e-12);
  CHECK((goldfarb_idnani(given).refined.force - Vector2d(513, 512)).norm() <= 1e-10);
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
  const ContactState state = goldfarb_idnani(whole_problem(fan()), {2});
  CHECK(state.report.status == SolveStatus::IterationLimit);
  CHECK(state.report.iterations == 2);
}

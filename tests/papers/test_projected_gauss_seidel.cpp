#include "catch_compat.hpp"
#include "papers/projected_gauss_seidel.hpp"
#include "papers/solver_table.hpp"
#include "support/whole_numbers.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Two pairs with the exact answer (2, 1): every sweep shrinks the error by 1/4.
ContactProblem two_pairs() {
  return {(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-5, -4)};
}

/// n pairs in a row, each of which opens its neighbours as much as half of itself: G is tridiagonal with
/// eigenvalues 2 - 2 cos(k pi / (n + 1)), and a sweep shrinks the error by cos^2(pi / (n + 1)) only.
ContactProblem chain(Index n) {
  MatrixXd G = 2 * MatrixXd::Identity(n, n);
  G.diagonal(1).setConstant(-1);
  G.diagonal(-1).setConstant(-1);
  return {G, VectorXd::Constant(n, -1)};
}

}  // namespace

TEST_CASE("the error of two pairs shrinks by four in every sweep", "[gauss_seidel][closed-form]") {
  // Sweep k leaves the force (2 + 1/2 4^(1-k), 1 - 1/4 4^(1-k)): by hand from (0, 0).
  for (const Index sweeps : {1, 2}) {
    const ContactState state = projected_gauss_seidel(two_pairs(), {sweeps});
    REQUIRE(state.report.status ==
            SolveStatus::Solved);  // the set is right from the first sweep on
    CHECK((state.force - Vector2d(2, 1)).norm() < 1e-15);
  }
  const ContactState state = projected_gauss_seidel(two_pairs());
  REQUIRE(state.report.history.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double t = std::pow(4.0, -static_cast<double>(k));
    const Vector2d force(2 + t / 2, 1 - t / 4);
    const double energy =
        -two_pairs().free_gap.dot(force) - 0.5 * force.dot(two_pairs().compliance * force);
    CHECK(state.report.history[k].dual_energy == Approx(energy).epsilon(1e-15));
  }
}

TEST_CASE("a set that is right from the start ends a problem on which sweeps are slow",
          "[gauss_seidel][closed-form]") {
  const ContactState state = projected_gauss_seidel(chain(50));
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.report.iterations == 2);
  for (Index i = 0; i < 50; ++i)  // the parabola (i + 1)(n - i) / 2
    CHECK(state.force(i) == Approx(0.5 * static_cast<double>((i + 1) * (50 - i))).epsilon(1e-13));
}

TEST_CASE("sweeps raise the dual energy, and what they say is right", "[gauss_seidel][hard]") {
  Random random(13);
  int solved = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    const ContactProblem problem = whole_problem(random);
    CAPTURE(sample, problem.free_gap.size());
    const ContactState state = projected_gauss_seidel(problem, {300});
    const std::vector<Iteration>& history = state.report.history;
    for (std::size_t k = 1; k < history.size(); ++k)
      CHECK(history[k].dual_energy >= history[k - 1].dual_energy * (1 - 1e-13));
    if (state.report.status == SolveStatus::Solved) {
      CHECK(agrees_with_enumeration(problem, state));
      ++solved;
    } else {
      CHECK(state.report.status == SolveStatus::IterationLimit);
    }
  }
  CHECK(solved > 1250);  // of 2000, of which some have no solution
}

TEST_CASE("an asymmetric matrix with a dominant diagonal", "[gauss_seidel][enumerate]") {
  Random random(6);
  for (int sample = 0; sample < 200; ++sample) {
    const Index n = random.whole(2, 8);
    ContactProblem problem{MatrixXd(n, n), VectorXd(n)};
    for (Index k = 0; k < n * n; ++k) problem.compliance.data()[k] = random.uniform(-1, 1);
    for (Index i = 0; i < n; ++i) {
      problem.compliance(i, i) = static_cast<double>(n);
      problem.free_gap(i) = random.uniform(-1, 1);
    }
    const ContactState state = projected_gauss_seidel(problem);
    const ContactState sure = enumerate(problem);
    CAPTURE(sample, n);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK((state.force - sure.force).norm() <= 1e-13 * (1 + sure.force.norm()));
    CHECK(state.report.iterations <= 50);
  }
  const ContactProblem game{(Eigen::Matrix2d() << 0, 1, 1, 0).finished(), Vector2d(-1, -1)};
  CHECK(projected_gauss_seidel(game).report.status == SolveStatus::Breakdown);
}

TEST_CASE("neither the scale of rows nor units change a sweep", "[gauss_seidel][units]") {
  Random random(7);
  for (int sample = 0; sample < 200; ++sample)
    CHECK(changes_with_scale(
              random, [](const ContactProblem& p) { return projected_gauss_seidel(p); }) == 0);
}

TEST_CASE("projected Gauss-Seidel finds the solution of every size of Table 1", "[gauss_seidel]") {
  solves_table_1(find_solver("projected_gauss_seidel"));
}

TEST_CASE("gaps that contradict each other reach the limit, with a thinned history",
          "[gauss_seidel]") {
  const ContactProblem wedged{(Eigen::Matrix2d() << 1, -1, -1, 1).finished(), Vector2d(-1, -0.5)};
  const ContactState state = projected_gauss_seidel(wedged);
  CHECK(state.report.status == SolveStatus::IterationLimit);
  CHECK(state.report.iterations == 1020);
  CHECK(state.report.history.size() < 32 + 16 * 6);
}

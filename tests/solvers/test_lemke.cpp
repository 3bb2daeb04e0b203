#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/solvers/lemke.hpp"
#include "support/whole_numbers.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

ContactState classic(const ContactProblem& problem) {
  return lemke(problem, VectorXd::Ones(problem.free_gap.size()));
}

MatrixXd rows(Index n, std::initializer_list<double> entries) {
  MatrixXd M(n, n);
  Index k = 0;
  for (const double entry : entries) {
    M(k / n, k % n) = entry;
    ++k;
  }
  return M;
}

VectorXd vector(std::initializer_list<double> entries) {
  return Eigen::Map<const VectorXd>(entries.begin(), static_cast<Index>(entries.size()));
}

}  // namespace

TEST_CASE("one pair that overlaps takes two pivots, an open one none", "[lemke][closed-form]") {
  const MatrixXd G = MatrixXd::Constant(1, 1, 4);
  const ContactState closed = lemke({G, vector({-2})});
  CHECK(closed.force(0) == 0.5);
  CHECK(closed.report.iterations == 2);
  CHECK(lemke({G, vector({2})}).report.iterations == 0);
}

TEST_CASE("Fathi's and Murty's problems take 2^n pivots with a covering vector of ones",
          "[lemke][hard]") {
  for (Index n = 2; n <= 10; ++n) {
    CAPTURE(n);
    const ContactState spd = classic(fathi(n));
    REQUIRE(spd.report.status == SolveStatus::Solved);
    CHECK(spd.report.iterations == Index{1} << n);
    CHECK((spd.force - VectorXd::Unit(n, 0)).norm() < 1e-14);
    const ContactProblem triangular = murty(n);
    const ContactState far = classic(triangular);
    REQUIRE(far.report.status == SolveStatus::Solved);
    CHECK(far.report.iterations == Index{1} << n);
    CHECK((far.force - std::ldexp(1, static_cast<int>(n)) * VectorXd::Unit(n, n - 1)).norm() == 0);
    CHECK(certify(triangular, far).worst() <= 1e-15);
  }
}

TEST_CASE("equilibration takes the length out of Fathi's path, but not of Murty's",
          "[lemke][hard]") {
  CHECK(lemke(fathi(10)).report.iterations == 2);
  CHECK(lemke(murty(10)).report.iterations == 1024);
}

TEST_CASE("pivots and solutions of published problems, known in exact arithmetic",
          "[lemke][literature]") {
  struct Case {
    const char* name;
    ContactProblem problem;
    Index pivots;
    VectorXd force;  // empty: ends in a ray
  };
  const MatrixXd linked = rows(4, {11, 0, 10, -1, 0, 11, 10, -1, 10, 10, 21, -1, 1, 1, 1, 0});
  const Case cases[] = {
      {"one pair twice", {rows(2, {1, 1, 1, 1}), vector({-1, -1})}, 2, vector({0, 1})},
      {"example 4.4.7",
       {rows(3, {0, -1, 2, 2, 0, -2, -1, 1, 0}), vector({-3, 6, -1})},
       5,
       vector({0, 1, 3})},
      {"bimatrix game 4.4.23",
       {rows(4, {0, 0, 10, 20, 0, 0, 30, 15, 10, 20, 0, 0, 30, 15, 0, 0}),
        vector({-1, -1, -1, -1})},
       1,
       {}},
      {"saddle point", {linked, vector({50, 50, 10, -6})}, 5, vector({2, 2, 2, 92})},
      {"saddle point, other load", {linked, vector({50, 50, 23, -6})}, 5, vector({3, 3, 0, 83})},
      {"example 4.4.16", {rows(2, {1, -1, -1, 1}), vector({1, -1})}, 2, vector({0, 1})},
      {"Pang", {rows(3, {0, -1, -1, 1, 0, 0, -1, 0, 0}), vector({0, -1, 1})}, 3, vector({1, 0, 0})},
      {"Pang, perturbed", {rows(3, {0, -1, -1, 1, 0, 0, -1, 0, 0}), vector({-1e-4, -1, 1})}, 4, {}},
      {"many solutions, perturbed",
       {rows(3, {0, -1, 1, 1, 0, 0, -1, 0, 0}), vector({-1e-4, -1, 1})},
       5,
       vector({1, 0, 1e-4})},
      {"two pairs", {rows(2, {2, 1, 1, 2}), vector({-5, -6})}, 3, vector({4.0 / 3, 7.0 / 3})}};
  for (const Case& expected : cases)
    for (const bool scaled : {false, true}) {
      CAPTURE(expected.name, scaled);
      const ContactState state = scaled ? lemke(expected.problem) : classic(expected.problem);
      if (!scaled) CHECK(state.report.iterations == expected.pivots);
      if (expected.force.size() == 0) {
        const bool refuted = expected.name == std::string("Pang, perturbed");
        CHECK(state.report.status == SolveStatus::Ray);
        CHECK(solve_with_proofs(expected.problem, lemke()).report.status ==
              (refuted ? SolveStatus::Infeasible : SolveStatus::Ray));
        continue;
      }
      REQUIRE(state.report.status == SolveStatus::Solved);
      CHECK((state.force - expected.force).norm() <= 1e-14 * expected.force.norm());
      CHECK(certify(expected.problem, state).worst() <= 1e-15);
    }
}

TEST_CASE("2000 problems in whole numbers, solved or proved infeasible", "[lemke][hard]") {
  Random random(11);
  int solved = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    const ContactProblem problem = whole_problem(random);
    CAPTURE(sample, problem.free_gap.size());
    const ContactState state = lemke(problem);
    CHECK(state.report.iterations <= 3 * problem.free_gap.size() + 2);
    solved += agrees_with_enumeration(problem, state) ? 1 : 0;
  }
  CHECK(solved > 1000);
  CHECK(solved < 1900);
}

TEST_CASE("ties at every pivot do not make it run in circles", "[lemke][hard]") {
  // All gaps are equal and all pairs alike, so that every ratio test is a tie; with G = 1 + I each force
  // is 1 / (n + 1), with G = 1, one pair written n times, the forces sum to 1.
  for (const Index n : {2, 5, 20, 100}) {
    const MatrixXd ones = MatrixXd::Ones(n, n);
    const VectorXd d = VectorXd::Constant(n, -1);
    CAPTURE(n);
    const ContactState alike = lemke({ones + MatrixXd::Identity(n, n), d});
    REQUIRE(alike.report.status == SolveStatus::Solved);
    CHECK(alike.report.iterations <= n + 1);
    CHECK((alike.force.array() - 1.0 / static_cast<double>(n + 1)).abs().maxCoeff() < 1e-15);
    const ContactState copies = lemke({ones, d});
    REQUIRE(copies.report.status == SolveStatus::Solved);
    CHECK(copies.report.iterations == 2);
    CHECK(copies.force.sum() == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("asymmetric matrices with positive definite symmetric part", "[lemke][enumerate]") {
  Random random(5);
  for (int sample = 0; sample < 300; ++sample) {
    ContactProblem problem = random_problem(random, random.whole(2, 8));
    for (Index j = 0; j < problem.free_gap.size(); ++j)
      for (Index i = 0; i < j; ++i) {
        const double skew = random.uniform(-2, 2);
        problem.compliance(i, j) += skew;
        problem.compliance(j, i) -= skew;
      }
    const ContactState found = lemke(problem);
    const ContactState sure = enumerate(problem);
    CAPTURE(sample);
    REQUIRE(found.report.status == SolveStatus::Solved);
    REQUIRE(sure.report.status == SolveStatus::Solved);
    CHECK((found.force - sure.force).norm() <= 1e-12 * sure.force.norm());
    CHECK(certify(problem, found).worst() <= 1e-13);
  }
}

TEST_CASE("neither the scale of rows nor units change a pivot", "[lemke][units]") {
  Random random(7);
  for (int sample = 0; sample < 200; ++sample)
    CHECK(changes_with_scale(random, [](const ContactProblem& p) { return lemke(p); }) == 0);
}

TEST_CASE("Lemke's method finds the solution of every size of Table 1", "[lemke]") {
  solves_table_1(find_solver("lemke"));
}

// Three unknowns and four pairs: one row depends on the others, and the path ends with a pair in its basis whose force
// and gap are both rounding.
TEST_CASE("a pair that touches without force at the end of the path is not called closed",
          "[lemke][hard]") {
  const MatrixXd thirds =
      (MatrixXd(3, 4) << 2, -1, 1, -2, 1, 2, 0, -1, -1, -2, -2, -1).finished() / 3;
  const MatrixXd whole = (MatrixXd(3, 4) << 2, 2, 2, 0, 2, -1, 1, -2, 0, -2, -1, -2).finished();
  const auto end = [](const MatrixXd& H, const VectorXd& force, const VectorXd& gap) {
    const MatrixXd G = H.transpose() * H;
    return find_solver("lemke").solve({G, gap - G * force}, {});
  };
  const ContactState first = end(thirds, vector({0.3, 0, 0, 0.1}), vector({0, 0.2, 0, 0}));
  CHECK(first.report.status == SolveStatus::Solved);
  CHECK(first.active() == std::vector<Index>{0, 3});
  const ContactState second = end(whole, vector({0, 0, 0.2, 0.1}), VectorXd::Zero(4));
  CHECK(second.report.status == SolveStatus::Solved);
  CHECK(second.active() == std::vector<Index>{2, 3});
}

TEST_CASE("a limit on pivots is kept, and a bad covering vector refused", "[lemke]") {
  const ContactState state = lemke(murty(6), {7});
  CHECK(state.report.status == SolveStatus::IterationLimit);
  CHECK(state.report.iterations == 7);
  CHECK(state.farkas_certificate.size() == 0);
  CHECK_THROWS_AS(lemke(fathi(2), vector({1, 0})), std::invalid_argument);
  CHECK_THROWS_AS(lemke(fathi(2), vector({1, 1, 1})), std::invalid_argument);
}

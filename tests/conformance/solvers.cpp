// What every member of the family of solvers promises. A new member joins by its line in solvers.cpp.
#include "signorini/complementarity/solvers.hpp"

#include <cmath>

#include "catch_compat.hpp"
#include "signorini/complementarity/certificate.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

bool accepts(const Solver& solver, Index n) { return solver.largest == 0 || n <= solver.largest; }

/// Members that say they may take too long are not asked for an answer, only for honesty.
std::vector<Solver> quick_solvers() {
  std::vector<Solver> quick;
  for (const Solver& solver : solvers())
    if (!may_fail(solver, Trait::Slow)) quick.push_back(solver);
  return quick;
}

/// The state of a problem that every solver must solve, certified.
ContactState solved(const Solver& solver, const ContactProblem& problem) {
  const ContactState state = solver.solve(problem, {});
  INFO("solver " << solver.name << ", " << problem.free_gap.size() << " pairs");
  REQUIRE(state.report.status == Status::Solved);
  REQUIRE(state.force.size() == problem.free_gap.size());
  REQUIRE(state.gap.size() == problem.free_gap.size());
  CHECK(certify(problem, state).worst() <= 1e-12);
  for (Index i = 0; i < state.force.size(); ++i) {
    CHECK(state.force(i) >= 0);
    CHECK(state.gap(i) >= 0);
  }
  for (std::size_t k = 0; k < state.active.size(); ++k) {
    CHECK(state.gap(state.active[k]) == 0);
    if (k > 0) CHECK(state.active[k] > state.active[k - 1]);
  }
  return state;
}

}  // namespace

TEST_CASE("every solver: one pair, closed form max(0, -d/G)", "[conformance][closed-form]") {
  for (const Solver& solver : solvers())
    for (const double gap : {-9.8, 0.0, 3.0}) {
      const ContactState state =
          solved(solver, {Eigen::MatrixXd::Constant(1, 1, 2), Eigen::VectorXd::Constant(1, gap)});
      CHECK(state.force(0) == Approx(std::max(0.0, -gap / 2)).epsilon(1e-15).margin(0));
      CHECK(state.gap(0) == Approx(std::max(0.0, gap)).epsilon(1e-15).margin(0));
    }
}

TEST_CASE("every solver: two pairs in each of the four states", "[conformance][closed-form]") {
  Eigen::Matrix2d G;
  G << 2, 1, 1, 2;
  struct Case {
    Vector2d free_gap, force, gap;
  };
  const Case cases[] = {{{1, 2}, {0, 0}, {1, 2}},     // both open
                        {{-4, 3}, {2, 0}, {0, 5}},    // only the first
                        {{-4, -1}, {2, 0}, {0, 1}},   // the first one opens the second
                        {{1, -6}, {0, 3}, {4, 0}},    // only the second
                        {{-5, -4}, {2, 1}, {0, 0}},   // both closed
                        {{-4, -2}, {2, 0}, {0, 0}}};  // the second just touches
  for (const Solver& solver : quick_solvers())
    for (const Case& expected : cases) {
      const ContactState state = solved(solver, {G, expected.free_gap});
      CAPTURE(solver.name, expected.free_gap.transpose());
      CHECK((state.force - expected.force).norm() < 1e-14);
      CHECK((state.gap - expected.gap).norm() < 1e-14);
    }
}

TEST_CASE("every solver: an empty problem is solved by nothing", "[conformance]") {
  for (const Solver& solver : solvers()) {
    const ContactState state = solved(solver, {Eigen::MatrixXd(0, 0), Eigen::VectorXd(0)});
    CHECK(state.active.empty());
  }
}

TEST_CASE("every solver: no pair in reach, and all pairs closed", "[conformance]") {
  Random random(1);
  for (const Solver& solver : quick_solvers())
    for (const Index n : {3, 8, 40}) {
      if (!accepts(solver, n)) continue;
      ContactProblem problem = random_problem(random, n);
      problem.free_gap = problem.free_gap.cwiseAbs();
      CHECK(solved(solver, problem).force == Eigen::VectorXd::Zero(n));
      Eigen::VectorXd force(n);
      for (Index i = 0; i < n; ++i) force(i) = random.uniform(0.5, 2);
      problem.free_gap = -problem.compliance * force;
      const ContactState closed = solved(solver, problem);
      CHECK(closed.active.size() == static_cast<std::size_t>(n));
      CHECK((closed.force - force).norm() <
            1e-9 * force.norm());  // rounding times condition number
    }
}

TEST_CASE("every solver: problems built backwards from their answer", "[conformance]") {
  Random random(8);
  for (const Solver& solver : quick_solvers())
    for (int sample = 0; sample < 60; ++sample) {
      const Index n = sample < 50 ? random.whole(2, 9) : 30 + 10 * (sample - 50);
      if (!accepts(solver, n)) continue;
      ContactProblem problem = random_problem(random, n);
      Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
      Eigen::VectorXd gap = Eigen::VectorXd::Zero(n);
      for (Index i = 0; i < n; ++i)
        (random.whole(0, 1) == 0 ? force : gap)(i) = random.uniform(0.1, 1);
      problem.free_gap = gap - problem.compliance * force;
      const ContactState state = solved(solver, problem);
      CAPTURE(solver.name, sample, n);
      CHECK((state.force - force).norm() < 1e-9 * (force.norm() + 1));
      CHECK((state.gap - gap).norm() < 1e-9 * (gap.norm() + 1));
    }
}

TEST_CASE("every solver: pairs that touch without force are a valid end", "[conformance]") {
  // Gap and force are both zero in a third of the pairs.
  Random random(9);
  for (const Solver& solver : quick_solvers())
    for (int sample = 0; sample < 30; ++sample) {
      const Index n = 6;
      ContactProblem problem = random_problem(random, n);
      Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
      Eigen::VectorXd gap = Eigen::VectorXd::Zero(n);
      force.head(2) << 1, 0.5;
      gap.tail(2) << 2, 0.25;
      problem.free_gap = gap - problem.compliance * force;
      const ContactState state = solved(solver, problem);
      CHECK((state.force - force).norm() < 1e-11);
    }
}

TEST_CASE("every solver: the family of hard cases", "[conformance][hard]") {
  for (const Solver& solver : quick_solvers()) {
    CHECK((solved(solver, cycling_problem()).force - Eigen::Vector3d(0, 0.4, 0)).norm() < 1e-14);
    CHECK((solved(solver, fathi_problem(8)).force - Eigen::VectorXd::Unit(8, 0)).norm() < 1e-12);
    solved(solver, string_problem(10));
    if (accepts(solver, 80)) solved(solver, string_problem(80));
  }
}

TEST_CASE("every solver: a pair written twice gives one total force or an honest refusal",
          "[conformance][hard]") {
  Eigen::Matrix3d G;
  G << 2, 2, 1, 2, 2, 1, 1, 1, 2;
  const ContactProblem problem{G, Eigen::Vector3d(-2, -2, 5)};
  for (const Solver& solver : solvers()) {
    const ContactState state = solver.solve(problem, {});
    CAPTURE(solver.name);
    if (state.report.status == Status::Solved) {
      CHECK(certify(problem, state).worst() <= 1e-12);
      CHECK(state.force(0) + state.force(1) == Approx(1).epsilon(1e-12));
    } else {
      CHECK((state.report.status == Status::Breakdown ||
             state.report.status == Status::IterationLimit));
    }
  }
}

TEST_CASE("every solver: dependent pairs give a certified solution or an honest refusal",
          "[conformance][hard]") {
  // Gap rows in a space of fewer dimensions than pairs, rounded: singular but for the rounding. The
  // problem is built backwards, so that forces that solve it exist.
  Random random(31);
  for (const Solver& solver : solvers())
    for (int sample = 0; sample < 300; ++sample) {
      const Index n = random.whole(3, 8);
      Eigen::MatrixXd V(n, n - random.whole(1, 2));
      for (Index k = 0; k < V.size(); ++k) V.data()[k] = random.uniform(-1, 1);
      Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
      Eigen::VectorXd gap = Eigen::VectorXd::Zero(n);
      for (Index i = 0; i < n; ++i)
        (random.whole(0, 2) > 0 ? force : gap)(i) = random.uniform(0.1, 1);
      const Eigen::MatrixXd G = V * V.transpose();
      const ContactProblem problem{G, gap - G * force};
      const ContactState state = solver.solve(problem, {});
      CAPTURE(solver.name, sample, to_string(state.report.status));
      if (state.report.status == Status::Solved) CHECK(certify(problem, state).worst() <= 1e-12);
    }
}

TEST_CASE("every solver: what has no solution is never called solved", "[conformance][hard]") {
  Eigen::Matrix2d G;
  G << 1, -1, -1, 1;
  const ContactProblem wedged{G, Vector2d(-1, -0.5)};
  const ContactProblem immovable{Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Constant(1, -1)};
  for (const Solver& solver : solvers()) {
    CAPTURE(solver.name);
    CHECK(solver.solve(wedged, {}).report.status != Status::Solved);
    CHECK(solver.solve(immovable, {}).report.status != Status::Solved);
  }
}

TEST_CASE("every solver: the same problem gives the same bits", "[conformance]") {
  Random random(12);
  const ContactProblem problem = random_problem(random, 9);
  for (const Solver& solver : solvers()) {
    const ContactState first = solver.solve(problem, {});
    const ContactState second = solver.solve(problem, {});
    CHECK(first.force == second.force);
    CHECK(first.gap == second.gap);
    CHECK(first.report.iterations == second.report.iterations);
  }
}

TEST_CASE("every solver: a bad problem is the caller's mistake", "[conformance]") {
  for (const Solver& solver : solvers())
    CHECK_THROWS_AS(solver.solve({Eigen::MatrixXd::Identity(2, 2), Eigen::VectorXd::Zero(3)}, {}),
                    std::invalid_argument);
}

#include <algorithm>
#include <cmath>
#include <set>

#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/portfolio.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/quasi_active_set.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Vector3d;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("enumeration and the active set method agree on 600 random problems",
          "[active_set][enumerate]") {
  Random random(2026);
  Index exchanges = 0;
  for (int sample = 0; sample < 600; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(1, 8));
    const ContactState found = primal_dual_active_set(problem);
    const ContactState sure = enumerate(problem);
    CAPTURE(sample, problem.free_gap.size());
    REQUIRE(sure.report.status == SolveStatus::Solved);
    REQUIRE(found.report.status == SolveStatus::Solved);
    CHECK(found.active() == sure.active());
    CHECK((found.force - sure.force).norm() <= 1e-12 * sure.force.norm());
    CHECK(certify(problem, found).worst() < 1e-13);
    exchanges = std::max(exchanges, found.report.iterations);
  }
  CHECK(exchanges > 3);  // the sample is not trivial
}

TEST_CASE("a problem that is known scaled has the same bits, and is taken for no other", "[active_set]") {
  Random random(77);
  for (int sample = 0; sample < 20; ++sample) {
    const ContactProblem problem = random_problem(random, 6), other = random_problem(random, 6);
    const ScaledProblem scaled = equilibrate(problem);
    SolverOptions options;
    options.known = &problem;
    options.scaled = &scaled;
    CHECK(primal_dual_active_set(problem, options).force == primal_dual_active_set(problem).force);
    CHECK(primal_dual_active_set(other, options).force == primal_dual_active_set(other).force);
  }
}

TEST_CASE("neither the scale of rows nor units change a decision or an iteration",
          "[active_set][units]") {
  Random random(7);
  for (int sample = 0; sample < 200; ++sample) {
    const ContactProblem problem = random_problem(random, random.whole(2, 8));
    Eigen::VectorXd row(problem.free_gap.size());
    for (Index i = 0; i < row.size(); ++i) row(i) = std::pow(10.0, random.uniform(-8, 8));
    const double length = std::pow(10.0, random.uniform(-6, 6));
    const double force = std::pow(10.0, random.uniform(-6, 6));
    const ContactState plain = primal_dual_active_set(problem);
    const ContactState other =
        primal_dual_active_set(in_units(with_rows(problem, row), length, force));
    CAPTURE(sample);
    REQUIRE(other.report.status == SolveStatus::Solved);
    CHECK(other.active() == plain.active());
    CHECK(other.report.iterations == plain.report.iterations);
    const Eigen::VectorXd back = other.force.cwiseProduct(row) / force;
    CHECK((back - plain.force).norm() <= 1e-11 * plain.force.norm());
  }
}

namespace {

/// Exchanges every wrong pair at once, without a safeguard; true if a set of closed pairs comes back.
bool group_exchange_cycles(const ContactProblem& problem) {
  const ScaledProblem scaled = equilibrate(problem);
  const Index n = problem.free_gap.size();
  std::vector<bool> closed;
  for (Index i = 0; i < n; ++i) closed.push_back(problem.free_gap(i) < 0);
  std::set<std::vector<bool>> seen;
  while (seen.insert(closed).second) {
    std::vector<Index> active;
    for (Index i = 0; i < n; ++i)
      if (closed[static_cast<std::size_t>(i)]) active.push_back(i);
    const ActiveSetSolution now = solve_active_set(scaled, ActiveSet{active});
    bool changed = false;
    for (Index i = 0; i < n; ++i) {
      const bool is_closed = closed[static_cast<std::size_t>(i)];
      if (is_closed ? now.force(i) >= 0 : now.movement(i) >= 0) continue;
      closed[static_cast<std::size_t>(i)].flip();
      changed = true;
    }
    if (!changed) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("three pairs that make plain group exchanges run in circles are solved",
          "[active_set][hard]") {
  const ContactProblem problem = cycling_problem();
  REQUIRE(group_exchange_cycles(problem));
  const ContactState state = primal_dual_active_set(problem);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.active() == std::vector<Index>{1});
  CHECK((state.force - Vector3d(0, 0.4, 0)).norm() < 1e-15);
  CHECK((state.gap - Vector3d(0.6, 0, 2.2)).norm() < 1e-14);
  CHECK(state.report.iterations <= 40);
}

TEST_CASE("Fathi's family, on which pivoting is exponential, takes few iterations",
          "[active_set][hard]") {
  for (const Index n : {1, 2, 5, 8, 10}) {
    CAPTURE(n);
    const ContactProblem problem = fathi(n);
    const ContactState state = primal_dual_active_set(problem);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK((state.force - Eigen::VectorXd::Unit(n, 0)).norm() < 1e-12);
    CHECK(state.report.iterations <= 10 * n + 10);
    CHECK(certify(problem, state).worst() < 1e-13);
  }
}

TEST_CASE("nearly dependent pairs are still decided rightly", "[active_set][hard]") {
  // G = 1 + 1e-9 I: the pairs act almost as one, and the one with the deepest overlap takes the force.
  const Index n = 6;
  const Eigen::MatrixXd G = Eigen::MatrixXd::Ones(n, n) + 1e-9 * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd d(n);
  d << -1, -0.5, -2, 0.3, -1.9, -1.99;
  const ContactState state = primal_dual_active_set({G, d});
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.active() == std::vector<Index>{2});
  CHECK(state.force(2) == Approx(2 / (1 + 1e-9)).epsilon(1e-15));
}

// A chain of springs of stiffness 1: a force on cart j moves carts 1 to j back by as much as springs lie before it.
TEST_CASE("three carts: of three that overlap the middle one pulls and is released",
          "[active_set][closed-form]") {
  Eigen::Matrix3d G;
  G << 1, 1, 1, 1, 2, 2, 1, 2, 3;
  const ContactState state = primal_dual_active_set({G, Vector3d(-2, -1, -3)});
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.active() == std::vector<Index>{0, 2});
  CHECK((state.force - Vector3d(1.5, 0, 0.5)).norm() < 1e-14);
  CHECK((state.gap - Vector3d(0, 1.5, 0)).norm() < 1e-14);
  REQUIRE(state.report.history.size() == 2);
  CHECK(state.report.history[0].active == 3);
  CHECK(state.report.history[0].changes == 1);
  CHECK(state.report.history[0].tension == Approx(3).epsilon(1e-14));
  CHECK(state.report.history[1].active == 2);
}

TEST_CASE("on a string over a wave the sets shrink to the answer without going back",
          "[active_set]") {
  // The inverse of G has no positive entry off its diagonal: closed pairs never pull others shut, so
  // that from the first set on, pairs only open, at most n times.
  const ContactProblem problem = string_problem(60);
  const ContactState state = primal_dual_active_set(problem);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.report.iterations <= 60);
  CHECK(certify(problem, state).worst() < 1e-13);
  REQUIRE(state.report.history.size() == static_cast<std::size_t>(state.report.iterations));
  for (std::size_t k = 1; k < state.report.history.size(); ++k)
    CHECK(state.report.history[k].active <= state.report.history[k - 1].active);
  CHECK(state.report.history.back().changes == 0);
}

TEST_CASE("a clamped beam that overlaps everywhere starts from every second pair", "[active_set]") {
  for (const Index pairs : {100, 200, 400}) {
    ContactProblem beam{Eigen::MatrixXd(pairs, pairs), Eigen::VectorXd(pairs)};
    for (Index i = 0; i < pairs; ++i) {
      const double x = static_cast<double>(i + 1) / static_cast<double>(pairs);
      for (Index j = 0; j < pairs; ++j) {
        const double y = static_cast<double>(j + 1) / static_cast<double>(pairs);
        beam.compliance(i, j) =
            std::pow(std::min(x, y), 2) * (3 * std::max(x, y) - std::min(x, y)) / 6;
      }
      beam.free_gap(i) = 1e-3 - x * x * (6 - 4 * x + x * x) / 24;
    }
    beam.free_gap = beam.free_gap.cwiseMin(-1e-6);  // all overlap
    const ContactState found = primal_dual_active_set(beam);
    const ContactState sure = quasi_active_set(beam);
    CAPTURE(pairs, found.report.factorisations);
    REQUIRE(found.report.status == SolveStatus::Solved);
    CHECK(found.active() == sure.active());
    CHECK(found.report.iterations <= 4);
    CHECK(found.report.factorisations <= 40);
    CHECK(found.report.iterations == static_cast<Index>(found.report.history.size()));
  }
}

TEST_CASE("a limit on iterations is kept and reported, not called solved", "[active_set]") {
  const ContactState state = primal_dual_active_set(cycling_problem(), {2});
  CHECK(state.report.status == SolveStatus::IterationLimit);
  CHECK(state.report.iterations == 2);
  CHECK(primal_dual_active_set(cycling_problem(), {1000}).report.status == SolveStatus::Solved);
}

TEST_CASE("pairs that depend on each other are solved, or refuted with a proof",
          "[active_set][hard]") {
  Eigen::Matrix2d G;
  G << 1, 1, 1, 1;
  CHECK(primal_dual_active_set({G, Eigen::Vector2d(-1, -1)}).report.status == SolveStatus::Solved);
  G << 1, -1, -1, 1;  // pushing one pair opens the other: no forces can close both
  const ContactProblem wedged{G, Eigen::Vector2d(-1, -0.5)};
  for (const ContactState& state : {solve(wedged, primal_dual_active_set()), enumerate(wedged)}) {
    CHECK(state.report.status == SolveStatus::Infeasible);
    REQUIRE(state.farkas_certificate.size() == 2);
    CHECK(state.farkas_certificate(0) > 0);
    CHECK(state.farkas_certificate(0) == Approx(state.farkas_certificate(1)).epsilon(1e-15));
  }
  const ContactState rigid =
      solve(ContactProblem{Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Constant(1, -1)},
            primal_dual_active_set());
  CHECK(rigid.report.status == SolveStatus::Infeasible);
  CHECK(rigid.farkas_certificate.size() == 1);
}

TEST_CASE("enumeration prefers the set with fewest pairs and passes over singular ones",
          "[enumerate]") {
  Eigen::Matrix2d G;
  G << 1, 1, 1, 1;  // one pair written twice
  const ContactState twice = enumerate({G, Eigen::Vector2d(-1, -1)});
  REQUIRE(twice.report.status == SolveStatus::Solved);
  CHECK(twice.active().size() == 1);
  CHECK(twice.force.sum() == Approx(1).epsilon(1e-15));
  G << 2, 0, 0, 2;  // the second pair just touches
  CHECK(enumerate({G, Eigen::Vector2d(-2, 0)}).active() == std::vector<Index>{0});
}

TEST_CASE("enumeration refuses what it cannot finish", "[enumerate]") {
  const Index n = largest_enumeration + 1;
  CHECK_THROWS_AS(enumerate({Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd::Zero(n)}),
                  std::invalid_argument);
}

TEST_CASE("the report counts what was done", "[active_set]") {
  const ContactState open =
      primal_dual_active_set({Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 2)});
  CHECK(open.report.iterations == 1);
  CHECK(open.report.factorisations == 0);
  const ContactState closed =
      primal_dual_active_set({Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, 2)});
  CHECK(closed.report.factorisations == 1);
  REQUIRE(closed.report.history.size() == 1);
  CHECK(closed.report.history[0].active == 1);
  CHECK(closed.report.history[0].penetration == 0);
}

TEST_CASE("of pairs that repeat each other the deepest is closed, and opens the others at once",
          "[active_set][closed-form]") {
  const Eigen::MatrixXd G = Eigen::MatrixXd::Ones(3, 3);
  Vector3d overlap(1, 2, 3);
  do {
    const ContactState state = primal_dual_active_set({G, -overlap});
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.report.iterations == 1);
    CHECK(state.force == (overlap.array() == 3).select(overlap, Vector3d::Zero()));
    CHECK(state.gap == Vector3d(3 - overlap.array()));
  } while (std::next_permutation(overlap.data(), overlap.data() + 3));
}

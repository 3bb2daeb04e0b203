// Piles of discs: more contact forces than unknowns, so that the equations of many motions are singular.
#include <array>
#include <vector>

#include "addons/certified/many_bodies.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "addons/many_bodies/central_path.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/pile_of_discs.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini_test::pile;

TEST_CASE("a pile of discs: soft pairs spare the pivots", "[friction][soft]") {
  for (const double mu : {0.1, 0.3, 0.6, 1.0}) {
    const ContactProblem problem = pile(10, 10, mu);
    const ContactState state = solve_with_proofs(problem, find_solver("primal_dual_active_set"));
    CAPTURE(mu, state.reason, state.report.iterations);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(certify(problem, state).worst() <= 1e-13);
    // Pivots alone would be a hundred thousand.
    CHECK(state.report.iterations <= 2 * problem.free_gap.size());
  }
}

TEST_CASE("a large pile of discs is closed by its few entries", "[friction][soft]") {
  const ContactProblem problem = pile(15, 15, 0.1);
  REQUIRE(equilibrate_any(problem).sparse.size() > 0);
  const ContactState state = solve_with_proofs(problem, find_solver("primal_dual_active_set"));
  CAPTURE(state.reason, state.report.iterations);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(certify(problem, state).worst() <= 1e-13);
}

TEST_CASE("the central path leads near, and few sets are left", "[friction][soft]") {
  const double mu = GENERATE(0.1, 0.3);
  CAPTURE(mu);
  const ContactProblem problem = pile(15, 15, mu);
  REQUIRE(few_entries(problem));
  const auto state = many_bodies_state(problem, {});
  REQUIRE(state.has_value());
  CHECK(certify(problem, *state).worst() <= 1e-13);
  CHECK(state->report.iterations <= 150);  // soft pairs take two thousand, and sweeps did not end for 0.3
  CHECK(state->report.factorisations == state->report.iterations);  // no sweeps
  CHECK_FALSE(few_entries(pile(4, 4, 0.6)));
}

TEST_CASE("a pile whose paths turn too often is solved by sweeps", "[friction][soft]") {
  const ContactProblem problem = pile(15, 15, 0.6);
  const auto state = many_bodies_state(problem, {});
  REQUIRE(state.has_value());
  CHECK(certify(problem, *state).worst() <= 1e-13);
  CHECK(state->report.factorisations <= 400);  // two paths are 180 of them
}

TEST_CASE("the central path of one pair is in closed form", "[friction][soft]") {
  // F = 1 of a pair without coupling: lambda (lambda - 1) = m, and tau pushes the slip back.
  const Eigen::SparseMatrix<double> F = MatrixXd(MatrixXd::Identity(2, 2)).sparseView();
  const FrictionLaw law = signorini::law_of_all(VectorXd::Constant(1, 0.5), VectorXd::Zero(1));
  const auto force = [&](double slip) {
    CentralPath path(F, Eigen::Vector2d(-1, slip), law, 1);
    REQUIRE(path.follow(1e-14, 60));
    return path.force();
  };
  // What is left is m over the smaller factor, 1e-14 / 0.1 and less.
  CHECK((force(0.2) - Eigen::Vector2d(1, -0.2)).norm() <= 1e-12);   // sticks
  CHECK((force(0.7) - Eigen::Vector2d(1, -0.5)).norm() <= 1e-12);   // slides forward
  CHECK((force(-0.7) - Eigen::Vector2d(1, 0.5)).norm() <= 1e-12);   // slides backward
  CentralPath open(F, Eigen::Vector2d(1, 0.7), law, 1);
  REQUIRE(open.follow(1e-14, 60));
  CHECK(open.force().norm() <= 1e-12);
  CHECK_FALSE(CentralPath(F, Eigen::Vector2d(-1, 0.2), law, 1).follow(1e-14, 3));
}

TEST_CASE("few entries or all of them: the same closure", "[friction][soft]") {
  ScaledProblem dense = equilibrate_any(pile(6, 6, 0.5));
  REQUIRE(dense.sparse.size() == 0);
  const Index rows = dense.free.size();
  const auto sparse = [&] {
    ScaledProblem problem = dense;
    problem.sparse = dense.compliance.sparseView(0, 0);
    return problem;
  };

  SECTION("more forces than unknowns: the gaps and slips are the same") {
    const std::vector<ContactStatus> stuck(static_cast<std::size_t>(dense.pairs()),
                                           ContactStatus::Stick);
    const ActiveSetSolution all = solve_active_set(dense, stuck);
    const ActiveSetSolution few = solve_active_set(sparse(), stuck);
    REQUIRE(all.solvable);
    REQUIRE(few.solvable);
    CHECK((dense.compliance * (few.force - all.force)).norm() <= 1e-13 * all.force.norm());
  }
  SECTION("one answer: forces and the sign of the determinant are the same") {
    dense.compliance.diagonal().array() += 0.1;
    const bool floating = GENERATE(false, true);
    if (floating) {
      dense.rigid = VectorXd::Constant(rows, 1 / std::sqrt(static_cast<double>(rows)));
      dense.resultant = VectorXd::Ones(1);
    }
    signorini_test::Random random(2);
    int reversed = 0;
    for (int sample = 0; sample < 40; ++sample) {
      dense.law.coefficient.setConstant(sample < 20 ? 0.5 : 8);
      std::vector<ContactStatus> statuses;
      for (Index i = 0; i < dense.pairs(); ++i)
        statuses.push_back(static_cast<ContactStatus>(random.uniform(0, 4)));
      const ActiveSetSolution all = solve_active_set(dense, statuses);
      const ActiveSetSolution few = solve_active_set(sparse(), statuses);
      CAPTURE(floating, sample);
      REQUIRE(all.solvable);
      REQUIRE(few.solvable);
      CHECK((few.force - all.force).norm() <= 1e-11 * all.force.norm());
      CHECK((few.movement - all.movement).norm() <= 1e-11 * all.force.norm());
      CHECK((few.amplitude - all.amplitude).norm() <= 1e-11 * all.force.norm());
      CHECK(few.reversed == all.reversed);
      reversed += all.reversed ? 1 : 0;
    }
    CHECK(reversed > 0);
    CHECK(reversed < 40);
  }
}

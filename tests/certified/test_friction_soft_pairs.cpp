// Piles of discs: more contact forces than unknowns, so that the equations of many motions are singular.
#include <array>
#include <cmath>
#include <vector>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/random.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Discs of radius 1/2 in layers on a floor, each touching those beside and below it; u = W r + q are the
/// velocities at the contacts after the impulses r, with W = H M^-1 H^T.
ContactProblem pile(Index columns, Index layers, double mu) {
  signorini_test::Random random(1);
  struct Contact {
    Index below, above;
    double nx, ny;
  };
  const Index discs = columns * layers;
  const auto x = [&](Index disc) {
    return static_cast<double>(disc % columns) + 0.5 * static_cast<double>(disc / columns % 2);
  };
  const auto y = [&](Index disc) { return 0.87 * static_cast<double>(disc / columns); };
  std::vector<Contact> contacts;
  for (Index a = 0; a < discs; ++a) {
    if (a < columns) contacts.push_back({-1, a, 0, 1});
    for (Index b = a + 1; b < discs; ++b) {
      const double distance = std::hypot(x(b) - x(a), y(b) - y(a));
      if (distance < 1.05)
        contacts.push_back({a, b, (x(b) - x(a)) / distance, (y(b) - y(a)) / distance});
    }
  }
  const Index n = static_cast<Index>(contacts.size());
  MatrixXd H = MatrixXd::Zero(2 * n, 3 * discs);
  for (Index i = 0; i < n; ++i) {
    const Contact& c = contacts[static_cast<std::size_t>(i)];
    for (const auto& [disc, sign] : {std::pair(c.above, 1.0), std::pair(c.below, -1.0)}) {
      if (disc < 0) continue;
      H.row(i).segment(3 * disc, 2) << sign * c.nx, sign * c.ny;
      H.row(n + i).segment(3 * disc, 3) << -sign * c.ny, sign * c.nx, -0.5;
    }
  }
  VectorXd mobility(3 * discs);
  VectorXd velocity(3 * discs);
  for (Index d = 0; d < discs; ++d) {
    const double mass = random.uniform(0.5, 1.5);
    mobility.segment(3 * d, 3) << 1 / mass, 1 / mass, 8 / mass;
    velocity.segment(3 * d, 3) << random.uniform(-0.3, 0.3), random.uniform(-1.3, -0.7),
        random.uniform(-0.3, 0.3);
  }
  ContactProblem problem;
  const MatrixXd half = H * mobility.cwiseSqrt().asDiagonal();
  problem.compliance = gram(half.transpose());
  problem.free_gap = (H * velocity).head(n);
  problem.free_slip = (H * velocity).tail(n);
  problem.law = law_of_all(VectorXd::Constant(n, mu), VectorXd::Zero(n));
  return problem;
}

}  // namespace

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

TEST_CASE("few entries or all of them: the same closure", "[friction][soft]") {
  ScaledProblem dense = equilibrate_any(pile(6, 6, 0.5));
  REQUIRE(dense.sparse.size() == 0);
  const Index rows = dense.free.size();
  const auto sparse = [&] {
    ScaledProblem problem = dense;
    problem.sparse = dense.compliance.sparseView(0, 0);
    return problem;
  };
  CHECK(force_scale(sparse()) == Approx(force_scale(dense)).epsilon(1e-15));

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

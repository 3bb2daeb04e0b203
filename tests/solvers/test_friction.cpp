#include <cmath>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/goldfarb_idnani.hpp"
#include "support/friction.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

ContactState solved(const ContactProblem& problem) {
  ContactState state = solve_with_proofs(problem, friction_solvers().front());
  CAPTURE(state.reason);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(certify(problem, state).holds());
  return state;
}

}  // namespace

TEST_CASE("an open pair carries no cohesion, except in the equations as printed",
          "[friction][LinEtAl-29][erratum]") {
  const Matrix2d F = Eigen::Vector2d(2, 4).asDiagonal();
  const ContactProblem lifted = one_pair(F, 1, 8, 0.5, 1);
  const ContactState state = solved(lifted);
  CHECK(state.contact_status[0] == ContactStatus::Open);
  CHECK(state.friction(0) == 0);
  CHECK(state.slip(0) == 8);
  const ContactState printed = find_solver("friction_split_literal").solve(lifted, {});
  CHECK(printed.report.status == SolveStatus::Breakdown);
  CHECK(printed.friction(0) == Approx(-1));  // across a gap of 1
  CHECK(certify(lifted, printed).cone >= 0.1);
}

TEST_CASE("without friction and cohesion it is the frictionless problem", "[friction][identity]") {
  Random random(11);
  for (int trial = 0; trial < 40; ++trial) {
    ContactProblem problem = random_friction(random, 1 + trial % 8, 0);
    const Index n = problem.free_gap.size();
    const ContactState state = solved(problem);
    const ContactState plain =
        goldfarb_idnani(ContactProblem{problem.compliance.topLeftCorner(n, n), problem.free_gap});
    CHECK((state.force - plain.force).norm() <= 1e-12 * (1 + plain.force.norm()));
    CHECK(state.friction.isZero(0));
    CHECK(state.uniqueness == Uniqueness::Proved);
  }
}

TEST_CASE("with endless cohesion every closed pair sticks", "[friction][identity]") {
  Random random(12);
  for (int trial = 0; trial < 40; ++trial) {
    ContactProblem problem = random_friction(random, 1 + trial % 8, 0.5);
    problem.free_gap = -problem.free_gap.cwiseAbs();
    problem.compliance.topRightCorner(problem.free_gap.size(), problem.free_gap.size()).setZero();
    problem.compliance.bottomLeftCorner(problem.free_gap.size(), problem.free_gap.size()).setZero();
    problem.law.cohesion.setConstant(1e6);
    const ContactState state = solved(problem);
    for (const ContactStatus contact_status : state.contact_status)
      CHECK(friction_sign(contact_status) == 0);
  }
}

TEST_CASE("other units change forces by rounding only", "[friction][identity]") {
  Random random(13);
  for (int trial = 0; trial < 20; ++trial) {
    const ContactProblem problem = random_friction(random, 1 + trial % 8, 0.6);
    const VectorXd before = forces(solved(problem));
    for (const double length : {1e-6, 1.0, 1e6})
      for (const double force : {1e-6, 1.0, 1e6}) {
        ContactProblem other = problem;
        other.compliance *= length / force;
        other.free_gap *= length;
        other.free_slip *= length;
        other.law.cohesion *= force;
        CHECK((forces(solved(other)) / force - before).norm() <= 1e-12 * before.norm());
      }
  }
}

TEST_CASE("the order of the pairs changes nothing", "[friction][identity]") {
  Random random(14);
  for (int trial = 0; trial < 20; ++trial) {
    const ContactProblem problem = random_friction(random, 2 + trial % 7, 0.6);
    const Index n = problem.free_gap.size();
    std::vector<Index> order;
    for (Index i = n; i > 0; --i) order.push_back(i - 1);
    std::vector<Index> rows = order;
    for (const Index i : order) rows.push_back(n + i);
    const ContactProblem turned{
        problem.compliance(rows, rows), problem.free_gap(order), problem.free_slip(order),
        law_of_all(problem.law.coefficient(order), problem.law.cohesion(order))};
    const VectorXd before = forces(solved(problem));
    CHECK((forces(solved(turned)) - before(rows)).norm() <= 1e-12 * before.norm());
  }
}

TEST_CASE("each figure of the certificate sees its own forgery", "[friction][certificate]") {
  const ContactProblem problem = one_pair(Eigen::Vector2d(2, 4).asDiagonal(), -6, 8, 0.5, 0.25);
  const ContactState good = solved(problem);  // lambda 3, tau -1.75, slip 1
  CHECK(certify(problem, good).worst() <= 1e-15);
  const auto forged = [&](double force, double friction) {
    ContactState state = good;
    state.force(0) = force;
    state.friction(0) = friction;
    state.gap(0) = -6 + 2 * force;
    state.slip(0) = 8 + 4 * friction;
    return certify(problem, state);
  };
  CHECK(forged(2.9, -1.7).penetration > 1e-3);
  CHECK(forged(-0.1, 0).tension > 1e-3);
  CHECK(forged(3.1, -1.8).complementarity > 1e-3);
  CHECK(forged(3, -1.85).cone > 1e-3);
  CHECK(forged(3, -1.65).sliding > 1e-3);
  CHECK(forged(3, 1.75).sliding > 1e-1);
  ContactState moved = good;
  moved.slip(0) += 0.1;
  CHECK(certify(problem, moved).equilibrium > 1e-3);
  moved.slip(0) = std::nan("");
  CHECK_FALSE(certify(problem, moved).holds());
}

TEST_CASE("problems that do not fit are refused with their sizes", "[friction][errors]") {
  ContactProblem problem = one_pair(Matrix2d::Identity(), -1, 0, 0.5);
  problem.law.coefficient(0) = -0.1;
  CHECK_THROWS_AS(friction_solvers().front().solve(problem, {}), std::invalid_argument);
  problem.law.coefficient(0) = 0.1;
  problem.compliance(0, 1) = 0.5;  // not symmetric
  CHECK_THROWS_AS(find_solver("friction_split").solve(problem, {}), std::invalid_argument);
  problem.rigid = Eigen::Vector2d(1, 0);
  problem.resultant = Eigen::VectorXd::Ones(1);
  for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister"})
    CHECK_THROWS_AS(find_solver(name).solve(problem, {}), std::invalid_argument);
  problem.rigid.resize(0, 0);
  problem.resultant.resize(0);
  problem.compliance = MatrixXd::Identity(3, 3);
  CHECK_THROWS_AS(friction_solvers().front().solve(problem, {}), std::invalid_argument);
}

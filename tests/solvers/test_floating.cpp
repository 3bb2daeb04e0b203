#include <cmath>

#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/floating.hpp"
#include "support/problems.hpp"

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("a body far above its obstacle falls onto it in few steps", "[floating]") {
  // Springs of compliance 1e-6 under gaps of 1e3 that differ by 10: nine orders of magnitude.
  const ContactProblem problem =
      bar(Vector2d(0, 1), Vector2d(1e-6, 1e-6), Vector2d(1000, 1010), 1, 0.5);
  const ContactState state = solve_with_proofs(problem, find_solver("primal_dual_active_set"));
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Vector2d(0.5, 0.5)).norm() <= 1e-10);
  CHECK(state.report.iterations <= 10);
  const ContactState held = solve_with_proofs(problem, find_solver("enumerate"));  // by springs
  REQUIRE(held.report.status == SolveStatus::Solved);
  CHECK((held.force - state.force).norm() <= 1e-10);
  CHECK(held.report.factorisations <=
        200);  // rho doubles: about log2 of the 1e7 from spring to slope
  CHECK(certify(problem, state).worst() <= 1e-12);
}

TEST_CASE("a load right above the last support is still carried", "[floating][closed-form]") {
  const ContactProblem problem = bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(0, 1), 1, 0);
  const ContactState state = solve_with_proofs(problem, find_solver("primal_dual_active_set"));
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Vector2d(1, 0)).norm() <= 1e-14);
  CHECK(certify(problem, state).worst() <= 1e-14);
}

TEST_CASE("a load along a motion that no pair notices pulls the body away", "[floating]") {
  ContactProblem problem = bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(1, 1), 2, 1);
  problem.rigid = (MatrixXd(2, 3) << problem.rigid, VectorXd::Zero(2)).finished();
  problem.resultant = Vector3d(2, 2, 0.5);
  const ContactState away = solve_with_proofs(problem, find_solver("enumerate"));
  REQUIRE(away.report.status == SolveStatus::Infeasible);
  CHECK(problem.resultant.dot(away.unbounded_direction) < 0);
  problem.resultant(2) = 0;  // without that load the motion is free, and stays at zero
  const ContactState state = solve_with_proofs(problem, find_solver("enumerate"));
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.amplitude(2) == 0);
}

TEST_CASE("gaps that contradict each other are proved to, with rigid modes too", "[floating]") {
  // Two rigid walls closer to each other than the rigid block between them.
  const ContactProblem problem{MatrixXd::Zero(2, 2), Vector2d(-1, -1), {}, {},
                               Vector2d(1, -1),      VectorXd::Zero(1)};
  const ContactState state = solve_with_proofs(problem, find_solver("linear_programme"));
  REQUIRE(state.farkas_certificate.size() == 2);
  CHECK((problem.rigid.transpose() * state.farkas_certificate).norm() <= 1e-15);
}

TEST_CASE("without rigid modes it is the contact problem", "[floating]") {
  Random random(3);
  const ContactProblem contact = random_problem(random, 6);
  const Solver& solver = find_solver("primal_dual_active_set");
  const ContactState state = solve_with_proofs(contact, solver);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - solver.solve(contact, {}).force).norm() <= 1e-14);
}

TEST_CASE("the certificate finds out each forged part of a floating solution", "[floating]") {
  const ContactProblem problem =
      bar(Vector3d(0, 1, 2), Vector3d(1, 1, 1), Vector3d(0, 0, 5), 2, 0.5);
  ContactState state;
  state.force = Vector3d(1, 1, 0);
  state.gap = Vector3d(0, 0, 4);
  state.amplitude = Vector2d(-1, 0);
  CHECK(certify(problem, state).worst() == 0);
  ContactState forged = state;
  forged.amplitude(0) = -1.5;  // pushed into the springs
  CHECK(certify(problem, forged).penetration == Approx(0.5 / 1.5));
  forged = state;
  forged.gap(2) = 3;
  CHECK(certify(problem, forged).equilibrium == Approx(0.25));
  forged.force =
      Vector3d::Zero();  // everything open and every gap right, but nothing carries the load
  forged.gap = Vector3d(1, 1, 6);
  forged.amplitude = Vector2d(1, 0);
  CHECK(certify(problem, forged).penetration == 0);
  CHECK(certify(problem, forged).equilibrium == 1);
  forged.force = Vector3d(2, 0, 0);  // the right sum in the wrong place: the bar turns
  forged.amplitude = Vector2d(-2, 2);
  forged.gap = Vector3d(0, 0, 7);
  CHECK(certify(problem, forged).equilibrium ==
        0.25);  // moment 0 where 1 is due, and 2 on the lever 2 makes 4
  forged.amplitude(1) = std::nan("");
  CHECK(certify(problem, forged).worst() > 1e300);
}

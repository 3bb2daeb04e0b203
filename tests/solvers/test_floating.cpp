#include <cmath>

#include "catch_compat.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/springs.hpp"
#include "support/problems.hpp"

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// A rigid bar over springs: its point x moves up by a_1 + a_2 x, spring i at x_i has compliance c_i, and
/// the weight w acts at x_w. gap_i = d_i + c_i lambda_i + a_1 + a_2 x_i, sum lambda = w, sum x lambda = x_w w.
ContactProblem bar(const VectorXd& x, const VectorXd& compliance, const VectorXd& gap, double w,
                   double at) {
  ContactProblem problem{compliance.asDiagonal(), gap, {}, {}, MatrixXd(x.size(), 2),
                         Vector2d(w, at * w)};
  problem.rigid << VectorXd::Ones(x.size()), x;
  return problem;
}

/// Whether a member promises the answer to plain problems of several pairs.
bool reliable(const Solver& solver) {
  return !may_fail(solver, Trait::Ordinary) && !may_fail(solver, Trait::Several);
}

}  // namespace

TEST_CASE("a rigid bar on two springs: the law of the lever", "[floating][closed-form]") {
  // Weight 6 a third of the way: forces 4 and 2; each end sinks until its spring carries its part.
  const ContactProblem problem = bar(Vector2d(0, 3), Vector2d(0.5, 0.25), Vector2d(1, 2), 6, 1);
  for (const Solver& solver : solvers()) {
    const ContactState state = solve(problem, solver);
    CAPTURE(solver.name);
    if (!reliable(solver) && state.report.status != Status::Solved) continue;
    REQUIRE(state.report.status == Status::Solved);
    CHECK((state.force - Vector2d(4, 2)).norm() <= 1e-14);
    CHECK(state.amplitude(0) == Approx(-3).epsilon(1e-14));       // -(1 + 0.5 * 4)
    CHECK(state.amplitude(1) == Approx(0.5 / 3).epsilon(1e-14));  // from -3 to -(2 + 0.25 * 2)
    CHECK(certify(problem, state).worst() <= 1e-14);
  }
}

TEST_CASE("a rigid bar over three springs lifts off one", "[floating][closed-form]") {
  // The weight stands on the left half and the right spring lies deep: only the left two carry.
  const ContactProblem problem =
      bar(Vector3d(0, 1, 2), Vector3d(1, 1, 1), Vector3d(0, 0, 5), 2, 0.5);
  for (const Solver& solver : solvers()) {
    const ContactState state = solve(problem, solver);
    CAPTURE(solver.name);
    if (!reliable(solver) && state.report.status != Status::Solved) continue;
    REQUIRE(state.report.status == Status::Solved);
    CHECK((state.force - Vector3d(1, 1, 0)).norm() <= 1e-14);
    CHECK((state.gap - Vector3d(0, 0, 4)).norm() <= 1e-14);
    CHECK(state.amplitude(0) == Approx(-1).epsilon(1e-14));
    CHECK(std::abs(state.amplitude(1)) <= 1e-14);
  }
}

TEST_CASE("a body far above its obstacle falls onto it in few steps", "[floating]") {
  // Springs of compliance 1e-6 under gaps of 1e3 that differ by 10: nine orders of magnitude.
  const ContactProblem problem =
      bar(Vector2d(0, 1), Vector2d(1e-6, 1e-6), Vector2d(1000, 1010), 1, 0.5);
  const ContactState state = solve(problem, find_solver("primal_dual_active_set"));
  REQUIRE(state.report.status == Status::Solved);
  CHECK((state.force - Vector2d(0.5, 0.5)).norm() <= 1e-10);
  CHECK(state.report.iterations <= 10);
  const ContactState held = solve(problem, find_solver("enumerate"));  // by springs
  REQUIRE(held.report.status == Status::Solved);
  CHECK((held.force - state.force).norm() <= 1e-10);
  CHECK(held.report.factorisations <=
        200);  // rho doubles: about log2 of the 1e7 from spring to slope
  CHECK(certify(problem, state).worst() <= 1e-12);
}

TEST_CASE("a body that its load pulls away is found out, with the way it goes",
          "[floating][closed-form]") {
  struct Case {
    double weight, at;
  };
  // Upwards; and beyond each end, where the bar tips over.
  for (const Case load : {Case{-1, 1.5}, Case{1, -0.1}, Case{1, 3.1}})
    for (const Solver& solver : solvers()) {
      const ContactProblem problem =
          bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(1, 1), load.weight, load.at);
      const ContactState state = solve(problem, solver);
      CAPTURE(solver.name, load.weight, load.at);
      REQUIRE(state.report.status == Status::Infeasible);
      REQUIRE(state.escape.size() == 2);
      CHECK((problem.rigid * state.escape).minCoeff() >= -1e-15 * state.escape.norm());
      CHECK(problem.resultant.dot(state.escape) < 0);
    }
}

TEST_CASE("a load right above the last support is still carried", "[floating][closed-form]") {
  const ContactProblem problem = bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(0, 1), 1, 0);
  const ContactState state = solve(problem, find_solver("primal_dual_active_set"));
  REQUIRE(state.report.status == Status::Solved);
  CHECK((state.force - Vector2d(1, 0)).norm() <= 1e-14);
  CHECK(certify(problem, state).worst() <= 1e-14);
}

TEST_CASE("a load along a motion that no pair notices pulls the body away", "[floating]") {
  ContactProblem problem = bar(Vector2d(0, 3), Vector2d(1, 1), Vector2d(1, 1), 2, 1);
  problem.rigid = (MatrixXd(2, 3) << problem.rigid, VectorXd::Zero(2)).finished();
  problem.resultant = Vector3d(2, 2, 0.5);
  const ContactState away = solve(problem, find_solver("enumerate"));
  REQUIRE(away.report.status == Status::Infeasible);
  CHECK(problem.resultant.dot(away.escape) < 0);
  problem.resultant(2) = 0;  // without that load the motion is free, and stays at zero
  const ContactState state = solve(problem, find_solver("enumerate"));
  REQUIRE(state.report.status == Status::Solved);
  CHECK(state.amplitude(2) == 0);
}

TEST_CASE("gaps that contradict each other are proved to, with rigid modes too", "[floating]") {
  // Two rigid walls closer to each other than the rigid block between them.
  const ContactProblem problem{MatrixXd::Zero(2, 2), Vector2d(-1, -1), {}, {},
                               Vector2d(1, -1),      VectorXd::Zero(1)};
  for (const Solver& solver : solvers())
    CHECK(solve(problem, solver).report.status != Status::Solved);
  const ContactState state = solve(problem, find_solver("linear_programme"));
  REQUIRE(state.infeasibility.size() == 2);
  CHECK((problem.rigid.transpose() * state.infeasibility).norm() <= 1e-15);
}

TEST_CASE("pairs that touch without force and forces that cancel are solved and certified",
          "[floating]") {
  Eigen::Matrix3d G;
  G << 1, 1, -1, 1, 1, -1, -1, -1, 1;
  const ContactProblem cancelling{G,  Vector3d(0, 1, 0),  {},
                                  {}, Vector3d(0, 1, -1), VectorXd::Constant(1, -2)};
  const ContactProblem touching{
      Eigen::Matrix2d::Identity(), Vector2d(-2, 0), {}, {}, Vector2d(-1, 1),
      VectorXd::Constant(1, -2)};
  for (const char* name : {"quasi_active_set", "goldfarb_idnani", "lemke"})
    for (const ContactProblem& problem : {cancelling, touching}) {
      const ContactState state = solve(problem, find_solver(name));
      CAPTURE(name);
      CHECK(state.report.status == Status::Solved);
      CHECK(certify(problem, state).holds());
    }
}

TEST_CASE("without rigid modes it is the contact problem", "[floating]") {
  Random random(3);
  const ContactProblem contact = random_problem(random, 6);
  const Solver& solver = find_solver("primal_dual_active_set");
  const ContactState state = solve(contact, solver);
  REQUIRE(state.report.status == Status::Solved);
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

// What counts as a proof that nothing solves a problem, and as equations that hold, by hand.
#include <algorithm>
#include <cmath>
#include <vector>

#include "addons/certified/proofs.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/lemke.hpp"
#include "support/problems.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

TEST_CASE("overlaps that a rigid motion opens prove nothing", "[active_set][floating]") {
  const Matrix2d G = (Matrix2d() << 1, -1, -1, 1).finished();  // pressing both pairs moves nothing
  const Vector2d both(1, 1);
  ContactProblem problem{G, Vector2d(-1, -1)};
  CHECK(verify_farkas(problem, both));
  problem.resultant = Eigen::VectorXd::Constant(1, 2);
  problem.rigid = both;
  CHECK_FALSE(verify_farkas(problem, both));  // a = 1 opens both pairs, and forces of 1 balance r
  problem.resultant.setZero();
  problem.rigid = Vector2d(1, -1);
  CHECK(verify_farkas(problem, both));  // what opens one pair closes the other
}

TEST_CASE("gaps that no forces open are refuted for asymmetric matrices, and no others",
          "[active_set][proof]") {
  Random random(3);
  const auto whole = [&](Index rows, Index columns, int low, int high) {
    return MatrixXd(MatrixXd::NullaryExpr(
        rows, columns, [&] { return static_cast<double>(random.whole(low, high)); }));
  };
  for (int sample = 0; sample < 300; ++sample) {
    const Index n = random.whole(2, 8);
    CAPTURE(sample, n);
    MatrixXd M = whole(n, n, -3, 3);
    // Whatever M is, forces and gaps of their own make a problem whose gaps can be opened.
    const Eigen::VectorXd open = whole(n, 1, 0, 2) - M * whole(n, 1, 0, 2);
    CHECK(farkas_certificate(equilibrate_any({M, open})).size() == 0);
    // The weighted sum of the gaps is below 0, and no force lifts it.
    const Eigen::VectorXd y = whole(n, 1, 0, 2);
    Index last = 0;
    if (y.maxCoeff(&last) == 0) continue;
    Eigen::VectorXd d = whole(n, 1, -3, 3);
    for (Index j = 0; j < n; ++j) M(last, j) -= std::max(0.0, std::ceil(y.dot(M.col(j)) / y(last)));
    d(last) -= std::max(0.0, std::ceil((y.dot(d) + 1) / y(last)));
    const ContactProblem never{M, d};
    if (is_symmetric(never)) continue;
    CHECK(verify_farkas(never, farkas_certificate(equilibrate_any(never))));
    CHECK(solve_with_proofs(never, find_solver("enumerate")).report.status ==
          SolveStatus::Infeasible);
    const ContactState path = solve_with_proofs(never, lemke());
    CHECK(path.report.status == SolveStatus::Infeasible);
    CHECK(verify_farkas(never, path.farkas_certificate));
  }
}

TEST_CASE("closed pairs that cannot balance the load are no solution of their equations",
          "[active_set][floating]") {
  // A load of 2 along the only mode presses both pairs alike.
  ContactProblem problem{Matrix2d::Identity(), Vector2d(1, 2)};
  problem.rigid = Vector2d(1, 1);
  problem.resultant = Eigen::VectorXd::Constant(1, 2);
  const ScaledProblem scaled = equilibrate(problem);
  CHECK_FALSE(solve_active_set(scaled, ActiveSet{}).solvable);
  const ActiveSetSolution one = solve_active_set(scaled, ActiveSet{{0}});
  CHECK(one.solvable);
  CHECK(one.force(0) == Approx(2));
  CHECK(one.movement(1) == Approx(-1));  // 2 + a with 1 + 2 + a = 0
  const ActiveSetSolution both = solve_active_set(scaled, ActiveSet{{0, 1}});
  CHECK(both.solvable);
  CHECK((both.force - Vector2d(1.5, 0.5)).norm() < 1e-14);
}

TEST_CASE("a load along two slips is held as far as the cohesion of each reaches, and no farther",
          "[active_set][friction][floating]") {
  // Two pairs without friction coefficient; the modes are their slips.
  ContactProblem problem{MatrixXd::Identity(4, 4), Vector2d::Zero(), Vector2d::Zero(),
                         law_of_all(Vector2d::Zero(), Vector2d::Ones())};
  problem.rigid = MatrixXd::Zero(4, 2);
  problem.rigid.bottomRows(2).setIdentity();
  for (const double first : {0.0, 0.9, -0.9})
    for (const double second : {1.05, -1.05}) {
      problem.resultant = Vector2d(first, second);  // the first is held, the second is not
      const Eigen::VectorXd way = unbounded_direction(equilibrate(problem));
      REQUIRE(way.size() == 2);
      CHECK(std::abs(way(0)) <= 1e-15 * std::abs(way(1)));
      CHECK(way(1) * second < 0);
      problem.resultant(1) /= 1.1;
      CHECK(unbounded_direction(equilibrate(problem)).size() == 0);
    }
}

TEST_CASE("a determinant of the wrong sign warns of other solutions", "[active_set][friction]") {
  // The slip of each pair moves the gap of the other; both open and both sliding forward solve it.
  MatrixXd F = MatrixXd::Identity(4, 4);
  F(0, 3) = F(3, 0) = F(1, 2) = F(2, 1) = 2;
  F(2, 2) = F(3, 3) = 5;
  const ContactProblem problem{F, Vector2d::Ones(), Vector2d::Constant(4),
                               law_of_all(Vector2d::Ones(), Vector2d::Zero())};
  const ScaledProblem scaled = equilibrate(problem);
  for (const ContactStatus contact_status : {ContactStatus::Open, ContactStatus::SlipForward}) {
    const std::vector<ContactStatus> both(2, contact_status);
    const ActiveSetSolution end = solve_active_set(scaled, both);
    CHECK(solves(scaled, both, end));
    CHECK(end.reversed == (contact_status == ContactStatus::SlipForward));
    CHECK(uniqueness(scaled, both, end) == (contact_status == ContactStatus::SlipForward
                                                ? Uniqueness::Doubtful
                                                : Uniqueness::Unknown));
    if (contact_status != ContactStatus::SlipForward) continue;
    // det [1 -2 mu; -2 1] = 1 - 4 mu with mu the friction of the first alone: -3, and none from mu = 1/4 down.
    const UniquenessWarning found = uniqueness_warning(scaled, both, end);
    CHECK(found.pair == 0);
    CHECK(found.determinant == Approx(-3).epsilon(1e-14).margin(0));
  }
}

TEST_CASE("what cohesion can carry is no proof that a body moves away, whatever rounding leaves",
          "[active_set][friction][floating]") {
  Random random(5);
  for (int sample = 0; sample < 200; ++sample) {
    ContactProblem problem{MatrixXd::Identity(6, 6), Eigen::Vector3d::Zero(),
                           Eigen::Vector3d::Zero(),
                           law_of_all(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones())};
    problem.rigid = MatrixXd::Zero(6, 2);
    Eigen::Vector3d friction;
    for (Index i = 0; i < 3; ++i) {
      problem.rigid.row(3 + i) << random.uniform(-1, 1), random.uniform(-1, 1);
      friction(i) = random.uniform(-0.9, 0.9);
    }
    problem.resultant = problem.rigid.bottomRows(3).transpose() * friction;
    CAPTURE(sample);
    CHECK(unbounded_direction(equilibrate(problem)).size() == 0);
  }
}

TEST_CASE("one solution is proved only if the pairs that press leave no body free to move",
          "[active_set][floating]") {
  const auto verdict = [](const Vector2d& mode, double free_gap, double load) {
    ContactProblem problem{Matrix2d::Identity(), Eigen::VectorXd::Constant(1, free_gap)};
    problem.free_slip = Eigen::VectorXd::Zero(1);
    problem.law = law_of_all(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Zero(1));
    problem.rigid = mode;
    problem.resultant = Eigen::VectorXd::Constant(1, load);
    const ScaledProblem scaled = equilibrate(problem);
    const std::vector<ContactStatus> statuses = {load > 0 ? ContactStatus::SlipForward
                                                          : ContactStatus::Open};
    const ActiveSetSolution solution = solve_active_set(scaled, statuses);
    CHECK(solution.solvable);
    return uniqueness(scaled, statuses, solution);
  };
  CHECK(verdict({1, 0}, 1, 1.5) == Uniqueness::Proved);
  CHECK(verdict({1, 0}, 1, 0) == Uniqueness::Unknown);  // it hovers, how high nothing says
  CHECK(verdict({0, 1}, 1, 0) == Uniqueness::Unknown);  // it slides along the wall
  CHECK(verdict({0, 0}, 1, 0) == Uniqueness::Unknown);  // no pair notices how it moves
}

TEST_CASE("units of rows decide about no escape, not even where modes are dependent",
          "[proofs][units]") {
  Random random(5);
  int away = 0;
  for (int sample = 0; sample < 6000; ++sample) {
    const Index pairs = random.whole(1, 4);
    ContactProblem problem = random_problem(random, pairs);
    problem.rigid = Eigen::MatrixXd::NullaryExpr(
        pairs, 3, [&] { return random.whole(0, 3) > 0 ? random.uniform(-1, 1) : 0; });
    const Eigen::VectorXd force =
        Eigen::VectorXd::NullaryExpr(pairs, [&] { return random.uniform(0, 1); });
    problem.resultant = problem.rigid.transpose() * force;
    if (random.whole(0, 2) == 0)
      problem.resultant = Eigen::Vector3d::NullaryExpr([&] { return random.uniform(-1, 1); });
    const Eigen::VectorXd row = Eigen::VectorXd::NullaryExpr(
        pairs, [&] { return std::ldexp(1.0, static_cast<int>(random.whole(-40, 40))); });
    const ContactProblem other = with_rows(problem, row);
    const bool one = infeasible_resultant(problem, equilibrate(problem)).has_value();
    CAPTURE(sample, pairs);
    CHECK(one == infeasible_resultant(other, equilibrate(other)).has_value());
    away += one ? 1 : 0;
  }
  CHECK(away > 1000);
  CHECK(away < 5000);
}

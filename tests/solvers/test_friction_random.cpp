#include <cmath>

#include "addons/certified/proofs.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/friction.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Whether forces are among the solutions that trying all motions gives.
bool among(const VectorXd& force, const std::vector<VectorXd>& solutions) {
  for (const VectorXd& other : solutions)
    if ((force - other).norm() <= 1e-10 * other.norm()) return true;
  return false;
}

}  // namespace

TEST_CASE("moderate friction: few iterations of every kind of method", "[friction]") {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const ContactProblem problem = random_friction(random, 1 + trial % 8, 0.5);
    for (const auto& [name, most] :
         {std::pair("primal_dual_active_set", 12), {"fischer_burmeister", 12}, {"lemke", 60}}) {
      CAPTURE(trial, name);
      CHECK(solve_with_proofs(problem, find_solver(name)).report.iterations <= most);
    }
  }
}

TEST_CASE("of the tests with friction some have several solutions, some none", "[friction]") {
  // What the classes of the conformance suite ask of all members is not empty.
  const auto count = [](std::uint64_t seed, int trials, auto make, bool several) {
    Random random(seed);
    int found = 0;
    for (int trial = 0; trial < trials; ++trial) {
      const std::size_t n = all_solutions(make(random, trial)).size();
      found += (several ? n > 1 : n == 0) ? 1 : 0;
    }
    return found;
  };
  CHECK(count(
            22, 200,
            [](Random& random, int trial) {
              return random_friction(random, 1 + trial % 4, trial % 2 == 0 ? 3 : 1e4);
            },
            true) >= 10);
  CHECK(count(
            23, 150,
            [](Random& random, int trial) {
              return random_friction(random, 1 + trial % 4, 0.5, 0.3);
            },
            false) >= 1);
  const int none = count(
      24, 200,
      [](Random& random, int trial) { return random_floating(random, 1 + trial % 4, 0.5); }, false);
  CHECK(none >= 1);
  CHECK(none <= 20);
}

TEST_CASE("one node with several solutions: one is found, with the warning", "[friction][hard]") {
  // tests/data/generated/coulomb_one_node_nonunique.txt
  Matrix2d F;
  F << 1, 2, 2, 9;
  for (const char* name : {"primal_dual_active_set", "lemke", "fischer_burmeister",
                           "friction_split", "friction_split_literal"}) {
    const Solver& solver = find_solver(name);
    const ContactState unique = solve_with_proofs(one_pair(F, 0.1, 3, 0.3), solver);
    const ContactState state = solve_with_proofs(one_pair(F, 0.1, 3, 0.6), solver);
    CAPTURE(solver.name);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(certify(one_pair(F, 0.1, 3, 0.6), state).worst() <= 1e-15);
    if (std::string(solver.name) == "friction_split_literal") continue;
    CHECK(state.uniqueness == Uniqueness::Doubtful);
    CHECK(unique.uniqueness == Uniqueness::Proved);
  }
  const std::vector<VectorXd> solutions = all_solutions(one_pair(F, 0.1, 3, 0.6));
  CHECK(solutions.size() == 3);
  CHECK(among(Eigen::Vector2d(0, 0), solutions));
  CHECK(among(Eigen::Vector2d(1.02, -0.56), solutions));
  CHECK(among(Eigen::Vector2d(0.5, -0.3), solutions));
}

TEST_CASE("the warning starts where one node has other solutions", "[friction][closed-form]") {
  // Stiffness [1 0.6; 0.6 1]: for some loads several solutions exist from mu = 1 / 0.6 on, the proof ends at 1.6. A load
  // (-f, 2 f) that leaves a gap is held where mu > 2, or pushed off while it slides.
  Matrix2d F;
  F << 1 / 0.64, -0.6 / 0.64, -0.6 / 0.64, 1 / 0.64;
  const auto verdict = [&](double gap, double slip, double mu) {
    return solve_with_proofs(one_pair(F, gap, slip, mu), friction_solvers().front()).uniqueness;
  };
  CHECK(verdict(-1, 0.3, 1.59) == Uniqueness::Proved);
  for (const double mu : {1.61, 1.66, 1.67, 3.0})
    CHECK(verdict(-1, 0.3, mu) == Uniqueness::Unknown);
  const Eigen::Vector2d free = F * Eigen::Vector2d(-1, -2);
  CHECK(verdict(free(0), free(1), 1.99) == Uniqueness::Unknown);
  CHECK(verdict(free(0), free(1), 2.01) == Uniqueness::Doubtful);
}

TEST_CASE("the warning names the pair, its determinant and the friction from which on it can be",
          "[friction][closed-form]") {
  // Stiffness [1 -k; -k 1]: the determinant is 1 - mu k. A load (-0.2, 0.5) leaves a gap, but is held if mu > 2.5.
  for (const double k : {0.6, 0.8})
    for (const double mu : {0.9, 2.49, 2.51, 3.0, 1e3}) {
      CAPTURE(k, mu);
      Matrix2d F;
      F << 1, k, k, 1;
      F /= 1 - k * k;
      // K u = f - r with f = (-0.2, 0.5) would be u = F f without contact.
      const Eigen::Vector2d free = F * Eigen::Vector2d(-0.2, 0.5);
      const ContactState state =
          solve_with_proofs(one_pair(F, free(0), free(1), mu), friction_solvers().front());
      REQUIRE(state.report.status == SolveStatus::Solved);
      const bool several = mu > 2.5;
      CHECK((state.uniqueness == Uniqueness::Doubtful) == several);
      CHECK(state.uniqueness_warning.pair.has_value() == several);
      CHECK(state.uniqueness_warning.pair.value_or(0) == 0);
      CHECK(state.uniqueness_warning.determinant ==
            Approx(several ? 1 - mu * k : 1).epsilon(1e-13).margin(0));
      if (several)
        CHECK(mu / (1 - state.uniqueness_warning.determinant) == Approx(1 / k).epsilon(1e-13));
    }
}

TEST_CASE("without the friction of the pair that is named, beyond its share, the sign is right",
          "[friction][active_set]") {
  Random random(77);
  int named = 0;
  for (int sample = 0; sample < 1500; ++sample) {
    ContactProblem problem = random_friction(random, 2 + sample % 4, 8);
    const ContactState solution = solve_with_proofs(problem, friction_solvers().front());
    if (solution.report.status != SolveStatus::Solved || !solution.uniqueness_warning.pair)
      continue;
    const std::vector<ContactStatus> statuses = solution.contact_status;
    if (!solve_active_set(equilibrate(problem), statuses).reversed) continue;
    ++named;
    double& mu = problem.law.coefficient(*solution.uniqueness_warning.pair);
    const double critical = mu / (1 - solution.uniqueness_warning.determinant);
    CAPTURE(sample, mu, critical);
    mu = 1.000001 * critical;
    CHECK(solve_active_set(equilibrate(problem), statuses).reversed);
    mu = 0.999999 * critical;
    CHECK_FALSE(solve_active_set(equilibrate(problem), statuses).reversed);
  }
  CHECK(named > 5);
}

TEST_CASE("where cohesion leaves open what a sign means, the warning still rests on the set",
          "[friction][closed-form]") {
  // tau = -(0.6 lambda + 0.01) closes both gaps with (0.5, 0.04): the matrix [1 - 2 mu, 0.5; 0.5, 1] has the determinant -0.45,
  // and 0.75 without friction of the first pair, whose own one is 1 - 2 mu = -0.2.
  MatrixXd F = MatrixXd::Identity(4, 4);
  F(0, 1) = F(1, 0) = 0.5;
  F(0, 2) = F(2, 0) = 2;
  F(2, 2) = 9;
  const ContactProblem problem{
      F, Eigen::Vector2d(0.1, -0.29), Eigen::Vector2d(3, 1),
      law_of_all(Eigen::Vector2d::Constant(0.6), Eigen::Vector2d::Constant(0.01))};
  Solver forward = friction_solvers().front();
  forward.solve = [](const ContactProblem& posed, const SolverOptions&) {
    const ScaledProblem scaled = equilibrate(posed);
    const std::vector<ContactStatus> statuses(2, ContactStatus::SlipForward);
    Report report;
    report.status = SolveStatus::Solved;
    return finished(posed, scaled, solve_active_set(scaled, statuses), statuses, report);
  };
  const ContactState state = solve_with_proofs(problem, forward);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK((state.force - Eigen::Vector2d(0.5, 0.04)).norm() <= 1e-14);
  CHECK(state.uniqueness == Uniqueness::Doubtful);  // the first pair open is another
  CHECK(state.uniqueness_warning.pair == 0);
  CHECK(state.uniqueness_warning.determinant == Approx(-0.45 / 0.75).epsilon(1e-14));
}

TEST_CASE("a solution on the turned branch warns of the others", "[friction][hard]") {
  Matrix2d F;
  F << 1, 2, 2, 9;
  const ContactProblem problem = one_pair(F, 0.1, 3, 0.6);
  const ScaledProblem scaled = equilibrate(problem);
  const auto reversed = [&](ContactStatus contact_status) {
    const std::vector<ContactStatus> statuses = {contact_status};
    const ActiveSetSolution end = solve_active_set(scaled, statuses);
    CHECK(solves(scaled, statuses, end));
    return end.reversed;
  };
  CHECK_FALSE(reversed(ContactStatus::Open));
  CHECK_FALSE(reversed(ContactStatus::Stick));
  CHECK(reversed(ContactStatus::SlipForward));  // 1 - 2 mu < 0
}

TEST_CASE("one solution is proved by the largest eigenvalue of T, not by the answer to equal forces",
          "[friction][hard]") {
  // The eigenvalues of T are 20, of opposite friction forces, and 0.5, of equal ones. With 0.5 the bound would exclude others for
  // each of these coefficients.
  MatrixXd F = MatrixXd::Identity(4, 4);
  F(0, 2) = F(2, 0) = 2;
  F(0, 3) = F(3, 0) = -2;
  F.bottomRightCorner(2, 2) << 10.25, -9.75, -9.75, 10.25;
  const auto verdict = [&](double mu, std::size_t answers) {
    const ContactProblem problem{
        F, Eigen::Vector2d(0.1, 100), Eigen::Vector2d(3, 0),
        law_of_all(Eigen::Vector2d::Constant(mu), Eigen::Vector2d::Zero())};
    CHECK(all_solutions(problem).size() == answers);
    const ContactState state = solve_with_proofs(problem, friction_solvers().front());
    REQUIRE(state.report.status == SolveStatus::Solved);
    return state.uniqueness;
  };
  CHECK(verdict(0.6, 3) == Uniqueness::Doubtful);  // 1 - 2 mu < 0
  CHECK(verdict(0.45, 1) == Uniqueness::Unknown);
  CHECK(verdict(0.2, 1) == Uniqueness::Proved);  // 0.6 - 5 mu^2 > 0
}

TEST_CASE("others are said to exist where they do", "[friction][hard]") {
  Random random(78);
  int several = 0, told = 0;
  for (int trial = 0; trial < 900; ++trial) {
    const ContactProblem problem =
        random_friction(random, 1 + trial % 3, std::vector<double>{3, 30, 1e4}[trial / 300]);
    const ContactState state = solve_with_proofs(problem, friction_solvers().front());
    if (state.report.status != SolveStatus::Solved) continue;
    const bool more = all_solutions(problem).size() > 1;
    CAPTURE(trial);
    if (state.uniqueness == Uniqueness::Doubtful) CHECK(more);
    if (state.uniqueness == Uniqueness::Proved) CHECK_FALSE(more);
    several += more ? 1 : 0;
    told += state.uniqueness == Uniqueness::Doubtful ? 1 : 0;
  }
  CHECK(several >= 50);
  CHECK(10 * told >= 8 * several);
}

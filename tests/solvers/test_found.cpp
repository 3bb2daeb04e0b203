// Condensed problems on which a solver once failed or was wrong, in tests/data/found.
#include <Eigen/Core>
#include <string>
#include <variant>

#include "addons/certified/proofs.hpp"
#include "addons/certified/solve_with_proofs.hpp"
#include "addons/files/problem_file.hpp"
#include "catch_compat.hpp"
#include "papers/projected_gauss_seidel.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "signorini/solvers/fischer_burmeister.hpp"
#include "signorini/solvers/lemke.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/quasi_active_set.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

using Method = ContactState (*)(const ContactProblem&, const SolverOptions&);

ContactProblem read(const std::string& name) {
  const ProblemFile file = read_problem(std::string(SIGNORINI_TEST_DATA) + "/" + name);
  return std::get<std::vector<FiledProblem>>(file).front().problem;
}

}  // namespace

TEST_CASE("two equal rows are one pair for the exchange of sets", "[found][active_set]") {
  const ContactProblem problem = read("found/dup.txt");
  const ContactState state = primal_dual_active_set(problem);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.report.iterations == 1);  // without a second method
  CHECK(state.active().size() == 1);
  CHECK(state.force.sum() == Approx(1).epsilon(1e-15));
  // The deeper one of two equal rows is the one that closes.
  const ContactState deeper = primal_dual_active_set({problem.compliance, Vector2d(-1, -2)});
  REQUIRE(deeper.report.status == SolveStatus::Solved);
  CHECK(deeper.active() == std::vector<Index>{1});
  CHECK(deeper.gap(0) == Approx(1).epsilon(1e-15));
}

TEST_CASE("what can be solved but for rounding is not called infeasible", "[found][enumerate]") {
  const ContactProblem problem = read("found/lcp_311.txt");
  const ContactState sure = enumerate(problem);
  CHECK(sure.report.status != SolveStatus::Infeasible);
  CHECK(sure.farkas_certificate.size() == 0);
  for (const Method method : {Method(quasi_active_set), Method(primal_dual_active_set)}) {
    const ContactState state = method(problem, {});
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(certify(problem, state).worst() <= 1e-14);
  }
}

TEST_CASE("rows that are nearly equal do not change places for ever", "[found][quasi_active_set]") {
  const ContactProblem problem = read("found/lcp_2669.txt");
  const ContactState state = quasi_active_set(problem);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(state.report.iterations <= problem.free_gap.size());
  const ContactState sure = enumerate(problem);
  CHECK((state.gap - sure.gap).norm() <= 1e-12 * problem.free_gap.norm());
  CHECK(certify(problem, state).worst() <= 1e-13);
}

TEST_CASE("Lemke's method leaves a path that grows too long", "[found][lemke]") {
  const ContactProblem problem = read("siconos_lcp/lcp_tobenna.dat");
  const Index n = problem.free_gap.size();
  const Index first = n * n + 100 * n;
  const ContactState state = lemke(problem);
  REQUIRE(state.report.status == SolveStatus::Solved);
  CHECK(certify(problem, state).worst() <= 1e-14);
  CHECK(state.report.iterations <= first + 10 * n);
  // The covering vector of a caller is the only one: its path goes on.
  CHECK(lemke(problem, VectorXd::Ones(n), {first + 10 * n}).report.status ==
        SolveStatus::IterationLimit);
  // The limit of a caller holds for all paths together.
  CHECK(lemke(problem, {first + 10}).report.iterations == first + 10);
}

TEST_CASE("a pair without a diagonal entry has one scale for every method",
          "[found][fischer_burmeister]") {
  Matrix2d M;
  M << 1, -2, 3, 0;
  const Vector2d force(0.5, 0.75);
  const Vector2d q = -M * force;
  const ContactState plain = fischer_burmeister({M, q});
  REQUIRE(plain.report.status == SolveStatus::Solved);
  const ContactState other = fischer_burmeister(with_rows({M, q}, Vector2d(1, 1e-6)));
  REQUIRE(other.report.status == SolveStatus::Solved);
  CHECK(other.report.iterations == plain.report.iterations);
  CHECK((other.force - Vector2d(0.5, 0.75e6)).norm() <= 1e-12 * 0.75e6);
}

TEST_CASE("a singular matrix without symmetry never ends in numbers that are none",
          "[found][fischer_burmeister][projected_gauss_seidel]") {
  const ContactProblem problem = read("siconos_lcp/lcp_tobenna.dat");
  for (const Method method : {Method(fischer_burmeister), Method(projected_gauss_seidel)})
    for (const Index limit : {1, 5, 50}) {
      const ContactState state = method(problem, {limit});
      CHECK(state.force.allFinite());
      CHECK(state.gap.allFinite());
    }
}

TEST_CASE("a proof that nothing solves a problem is checked on its own data", "[found][proof]") {
  Matrix2d G;
  G << 1, -1, -1, 1;
  const Vector2d y(1, 1);
  const ContactProblem wedged{G, Vector2d(-1, 0.5)};
  CHECK(verify_farkas(wedged, y));
  CHECK_FALSE(verify_farkas(wedged, VectorXd()));
  CHECK_FALSE(verify_farkas(wedged, Vector2d(1, -1)));                        // a negative weight
  CHECK_FALSE(verify_farkas(wedged, Vector2d(1, 0.999)));                     // G y is not 0
  CHECK_FALSE(verify_farkas(ContactProblem{G, Vector2d(-1, 1)}, y));          // the gaps sum to 0
  CHECK_FALSE(verify_farkas(ContactProblem{G, Vector2d(-1, 1 - 1e-15)}, y));  // but for rounding
  CHECK_FALSE(verify_farkas(ContactProblem{Matrix2d(-G), Vector2d(1, -0.5)},
                            Vector2d(0, 0)));  // nothing is summed
  // Rows that are not quite opposite: a force of 1e5 opens both.
  G(0, 0) += 1e-5;
  CHECK_FALSE(verify_farkas(ContactProblem{G, Vector2d(-1, 0.5)}, y));
  // Forces that only close gaps cannot lift their sum; from the other side they could.
  const Matrix2d closing = (Matrix2d() << 0, -1, 1, 0).finished();
  CHECK(verify_farkas(ContactProblem{closing, Vector2d(-1, 5)}, Vector2d(1, 0)));
  CHECK_FALSE(verify_farkas(ContactProblem{closing.transpose(), Vector2d(-1, 5)}, Vector2d(1, 0)));
  // Neither units nor the scale of a row matter.
  G(0, 0) = 1;
  const Vector2d row(1e-8, 1e8);
  CHECK(verify_farkas(with_rows({G, Vector2d(-1, 0.5)}, row), y.cwiseQuotient(row)));
}

TEST_CASE("a claim without a proof that holds is withdrawn", "[found][proof]") {
  Matrix2d G;
  G << 1, -1, -1, 1;
  const ContactProblem wedged{G, Vector2d(-1, 0.5)};
  const auto claimed = [&](const VectorXd& proof) {
    const ScaledProblem scaled = equilibrate(wedged);
    Report report;
    report.status = SolveStatus::Infeasible;
    return finished(wedged, scaled, solve_active_set(scaled, ActiveSet{}), statuses_of({}, 2),
                    report, proof);
  };
  CHECK(claimed({}).report.status == SolveStatus::Breakdown);
  CHECK(claimed(Vector2d(1, 0.5)).report.status == SolveStatus::Breakdown);
  CHECK(claimed(Vector2d(1, 0.5)).farkas_certificate.size() == 0);
  CHECK(claimed(Vector2d(2, 2)).report.status == SolveStatus::Infeasible);
}

namespace {

ContactProblem floating(const MatrixXd& F, const VectorXd& d, const MatrixXd& R,
                        const VectorXd& r) {
  return {F, d, {}, {}, R, r};
}

}  // namespace

TEST_CASE("an amplitude of any size moves no pair that its mode does not move",
          "[found][floating]") {
  MatrixXd R(3, 3);
  R << -1, 2, 2, 0, 0, 0, -2, -2, -2;
  const ContactProblem problem =
      floating(MatrixXd::Identity(3, 3), VectorXd::Constant(3, -1), R, VectorXd::Zero(3));
  for (const char* name : {"primal_dual_active_set", "fischer_burmeister"}) {
    const ContactState state = solve_with_proofs(problem, find_solver(name));
    CAPTURE(name);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.force(1) == Approx(1));  // pair 2 overlaps by 1 and has the compliance 1
    CHECK(state.amplitude.cwiseAbs().maxCoeff() < 10);
  }
}

TEST_CASE("rounding of a load that contact can balance is no proof that it cannot",
          "[found][floating]") {
  MatrixXd R(3, 2);
  R << -1, 1, -2, 2, 2, 2;
  const ContactProblem problem =
      floating(MatrixXd::Identity(3, 3), VectorXd::Ones(3), R, Vector2d(-2, 2));
  for (const char* name : {"primal_dual_active_set", "quasi_active_set", "lemke"}) {
    const ContactState state = solve_with_proofs(problem, find_solver(name));
    CAPTURE(name);
    CHECK(state.unbounded_direction.size() == 0);
    REQUIRE(state.report.status == SolveStatus::Solved);  // by pair 2 alone
    CHECK(state.force(1) == Approx(1));
  }
}

TEST_CASE("huge forces that cancel do not make every gap small", "[found][certificate]") {
  MatrixXd F(4, 4);
  F << 9, 3, -6, -6, 3, 10, -11, 1, -6, -11, 13, 1, -6, 1, 1, 5;
  ContactProblem problem{F, VectorXd(3), VectorXd::Constant(1, -1),
                         law_of_all(VectorXd::Ones(1), VectorXd::Zero(1))};
  problem.free_gap << -3, 1, -1;
  problem.rigid.resize(4, 1);
  problem.rigid << 1, 2, -2, -1;
  problem.resultant = VectorXd::Constant(1, 4);
  for (const char* name : {"primal_dual_active_set", "fischer_burmeister", "lemke"})
    CHECK(find_solver(name).solve(problem, {}).report.status != SolveStatus::Solved);
}

TEST_CASE("a mode that moves no pair is no mode to hold", "[found][floating]") {
  MatrixXd F(2, 2);
  F << 1, -2, -2, 4;
  const ContactProblem problem =
      floating(F, Vector2d(-4, -2), MatrixXd::Zero(2, 1), VectorXd::Zero(1));
  CHECK_NOTHROW(solve_with_proofs(problem, find_solver("primal_dual_active_set")));
}

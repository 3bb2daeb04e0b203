#include <cmath>
#include <limits>
#include <string>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/message.hpp"
#include "support/problems.hpp"

using Eigen::Matrix2d;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::argument_message;

namespace {

std::string complaint(const Eigen::MatrixXd& G, const Eigen::VectorXd& d) {
  return argument_message([&] { check_problem({G, d}); });
}

Matrix2d matrix(double a, double b, double c, double d) {
  Matrix2d m;
  m << a, b, c, d;
  return m;
}

}  // namespace

TEST_CASE("every status has its word", "[problem]") {
  CHECK(std::string(to_string(SolveStatus::Solved)) == "solved");
  CHECK(std::string(to_string(SolveStatus::Infeasible)) == "infeasible");
  CHECK(std::string(to_string(SolveStatus::Ray)) == "ray");
  CHECK(std::string(to_string(SolveStatus::Jump)) == "jump");
  CHECK(std::string(to_string(SolveStatus::IterationLimit)) == "iteration limit");
  CHECK(std::string(to_string(SolveStatus::Breakdown)) == "breakdown");
}

TEST_CASE("a report that nobody filled in does not say solved", "[problem]") {
  CHECK(ContactState{}.report.status != SolveStatus::Solved);
}

TEST_CASE("a problem that is not one is refused", "[problem]") {
  CHECK(complaint(matrix(2, 1, 1, 2), Vector2d(0, 1)).empty());
  CHECK(complaint(Eigen::MatrixXd(0, 0), Eigen::VectorXd(0)).empty());
  CHECK_THAT(complaint(matrix(2, 1, 1, 2), Eigen::Vector3d(0, 1, 2)),
             ContainsSubstring("must be 3 x 3 (one row per gap, then one per slip), got 2 x 2"));
  CHECK_THAT(complaint(matrix(2, 1, 0.5, 2), Vector2d(0, 1)),
             ContainsSubstring("symmetric") && ContainsSubstring("0.25 of its diagonal"));
  CHECK_THAT(complaint(matrix(2, 1, 1, -3), Vector2d(0, 1)),
             ContainsSubstring("diagonal entry -3"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(complaint(matrix(2, nan, nan, 2), Vector2d(0, 1)), ContainsSubstring("finite"));
  CHECK_THAT(complaint(matrix(2, 1, 1, 2), Vector2d(0, nan)), ContainsSubstring("finite"));
}

TEST_CASE("numbers near overflow or underflow are refused, except small ones beside the diagonal",
          "[problem]") {
  const std::string wanted = "numbers beyond 1e102 or below 1e-102 in magnitude";
  CHECK(complaint(matrix(1e102, 0, 0, 1e-102), Vector2d(1e102, -1e-102)).empty());
  CHECK(complaint(matrix(1, 1e-200, 1e-200, 1), Vector2d(0, 1)).empty());
  CHECK(complaint(matrix(0, 0, 0, 1), Vector2d(0, 1)).empty());
  CHECK_THAT(complaint(matrix(1, 0, 0, 1e103), Vector2d(0, 1)),
             ContainsSubstring(wanted) && ContainsSubstring("pair 2"));
  CHECK_THAT(complaint(matrix(1e-103, 0, 0, 1), Vector2d(0, 1)), ContainsSubstring("pair 1"));
  CHECK_THAT(complaint(matrix(1, 1e103, 1e103, 1), Vector2d(0, 1)), ContainsSubstring(wanted));
  CHECK_THAT(complaint(matrix(1, 0, 0, 1), Vector2d(0, -5e-324)), ContainsSubstring(wanted));
  CHECK_THAT(complaint(matrix(1, 0, 0, 1), Vector2d(-1e300, 0)), ContainsSubstring(wanted));
  CHECK(complaint(matrix(1, 0, 0, 1), Vector2d(1, -1e-200)).empty());  // beside a larger gap
}

TEST_CASE("numbers of laws and of rigid modes near overflow or underflow are refused",
          "[problem]") {
  const auto of = [](double mu, double cohesion, double column, double load, double slip = 1) {
    ContactProblem problem{matrix(1, 0, 0, slip), Eigen::VectorXd::Zero(1)};
    problem.free_slip = Eigen::VectorXd::Zero(1);
    problem.law =
        law_of_all(Eigen::VectorXd::Constant(1, mu), Eigen::VectorXd::Constant(1, cohesion));
    problem.rigid = Vector2d(column, 1e-200 * column);
    problem.resultant = Eigen::VectorXd::Constant(1, load);
    return argument_message([&] { check_problem(problem); });
  };
  CHECK(of(0, 0, 0, 0).empty());
  CHECK(of(1e-102, 1e102, 1e51, 1e-51).empty());
  CHECK(of(1e102, 1e-102, 1e-51, 1e51).empty());
  CHECK_THAT(of(0.3, 0, 1, 1, 0),
             ContainsSubstring("rigid mode 1"));  // the slip is scaled by 1e-200
  for (const double far : {1e103, 1e-103}) {
    CHECK_THAT(of(far, 0, 1, 1), ContainsSubstring("slip 1 has numbers beyond 1e102"));
    CHECK_THAT(of(0.3, far, 1, 1), ContainsSubstring("slip 1 has numbers beyond 1e102"));
  }
  for (const double far : {1e52, 1e-52}) {
    CHECK_THAT(of(0.3, 0, far, 1), ContainsSubstring("rigid mode 1"));
    CHECK_THAT(of(0.3, 0, 1, -far), ContainsSubstring("rigid mode 1") && ContainsSubstring("1e51"));
  }
}

TEST_CASE("a complementarity problem without symmetry has a certificate too", "[certificate]") {
  // Murty's matrix: z = (0, 1), w = (1, 0) solves it, z = (1, 0), w = (0, 1) only its transpose.
  const ContactProblem problem{matrix(1, 2, 0, 1), Vector2d(-1, -1)};
  CHECK(certify(problem, {Vector2d(0, 1), Vector2d(1, 0), {}, {}}).worst() == 0);
  CHECK_FALSE(certify(problem, {Vector2d(1, 0), Vector2d(0, 1), {}, {}}).holds(0.1));
  // With a negative entry on the diagonal.
  const ContactProblem odd{matrix(-1, 0, 2, 1), Vector2d(3, -1)};
  CHECK(certify(odd, {Vector2d(0, 1), Vector2d(3, 0), {}, {}}).worst() == 0);
}

TEST_CASE("a difference of rounding size between the triangles is accepted", "[problem]") {
  CHECK(complaint(matrix(2, 1 + 1e-15, 1, 2), Vector2d(0, 1)).empty());
}

TEST_CASE("a solver is found by its name, an unknown one is answered with the family",
          "[solvers]") {
  CHECK(std::string(find_solver("enumerate").name) == "enumerate");
  CHECK_THAT(signorini_test::problem_message([] { static_cast<void>(find_solver("guess")); }),
             ContainsSubstring("unknown solver 'guess'") &&
                 ContainsSubstring("primal_dual_active_set, enumerate"));
}

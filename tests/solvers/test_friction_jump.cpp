// Cohesion that ends with contact: where a pair closes only without it and opens only with it, nothing solves the
// problem, and the end says so.
#include "addons/certified/solve_with_proofs.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/friction.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Sliding against its cohesion opens the gap by 0.5 c, the overlap is 0.1: from c = 0.2 on the pair cannot be closed,
/// and without cohesion it cannot be open.
Matrix2d pulling() {
  Matrix2d F;
  F << 1, -0.5, -0.5, 1;
  return F;
}

}  // namespace

TEST_CASE("a pair that only its own cohesion opens is named", "[friction][cohesion][closed-form]") {
  for (const char* name : {"primal_dual_active_set", "lemke"})
    for (const double cohesion : {0.1, 0.19, 0.21, 1.0}) {
      CAPTURE(name, cohesion);
      const ContactProblem problem = one_pair(pulling(), -0.1, 2, 0, cohesion);
      const ContactState state = solve_with_proofs(problem, find_solver(name));
      const bool solvable = cohesion < 0.2;
      CHECK(all_solutions(problem).empty() == !solvable);
      CHECK(state.report.status == (solvable ? SolveStatus::Solved : SolveStatus::Jump));
      if (!solvable)
        CHECK_THAT(
            state.reason,
            ContainsSubstring("pair 0 closes only without its cohesion and opens only with"));
    }
}

TEST_CASE("among pairs that can be solved, the one that jumps is named", "[friction][cohesion]") {
  const double gaps[] = {-1, -0.1, 0.5};
  MatrixXd F = MatrixXd::Zero(6, 6);
  for (Index i = 0; i < 3; ++i)
    for (const Index j : {i, i + 3}) {
      F(j, j) = pulling()(0, 0);
      F(i, i + 3) = F(i + 3, i) = pulling()(0, 1);
    }
  F += 0.01 * MatrixXd::Ones(6, 6);
  ContactProblem problem{F, Eigen::Map<const Eigen::Vector3d>(gaps), VectorXd::Constant(3, 2),
                         law_of_all(VectorXd::Zero(3), VectorXd::Constant(3, 1))};
  REQUIRE(all_solutions(problem).empty());
  const ContactState state = solve_with_proofs(problem, find_solver("primal_dual_active_set"));
  CHECK(state.report.status == SolveStatus::Jump);
  CHECK_THAT(state.reason, ContainsSubstring("pair 1 closes only without"));
  problem.law.cohesion(1) = 0.05;
  CHECK(solve_with_proofs(problem, find_solver("primal_dual_active_set")).report.status ==
        SolveStatus::Solved);
}

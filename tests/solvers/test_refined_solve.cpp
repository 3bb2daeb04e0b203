// Claims that refinement cannot make anything of.
#include <cmath>
#include <limits>

#include "catch_compat.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"
#include "signorini/solvers/refined_solve.hpp"

using namespace signorini;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A spring that is pressed on a support by 1: the claim is right, and what solves with K is not.
TEST_CASE("a claim whose first set has no finite certificate ends as a breakdown, with what was read",
          "[refined_solve]") {
  QuadraticProgramme programme;
  programme.stiffness = MatrixXd::Identity(1, 1).sparseView();
  programme.load = VectorXd::Ones(1);
  programme.A = MatrixXd::Identity(1, 1).sparseView();
  programme.initial_gap = VectorXd::Zero(1);
  const ContactProblem problem{MatrixXd::Identity(1, 1), -VectorXd::Ones(1)};
  const VectorXd free = VectorXd::Ones(1);
  const auto end_with = [&](double factor) {
    const CondensedProgramme condensed{
        problem, free, [factor](const VectorXd& v) { return VectorXd(factor * v); }};
    Ledger ledger;
    return refined_solve(programme, condensed, MatrixXd(1, 0), primal_dual_active_set(), {}, ledger);
  };
  CHECK(end_with(1).state.report.status == SolveStatus::Solved);
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    CAPTURE(wrong);
    const RefinedEnd end = end_with(wrong);
    CHECK(end.state.report.status == SolveStatus::Breakdown);
    CHECK(!end.certificate.holds());
    CHECK(end.state.gap.size() == 1);
    CHECK(end.state.active() == std::vector<Eigen::Index>{0});
  }
}

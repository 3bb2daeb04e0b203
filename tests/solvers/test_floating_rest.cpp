// Bodies that only contact stops, and that nothing pushes: no forces at all, at a place where nothing overlaps.
#include "addons/certified/solve_with_proofs.hpp"
#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/problem/certificate.hpp"
#include "support/random.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("a body that nothing pushes rests without forces, however many pairs just touch",
          "[floating][degenerate]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    signorini_test::Random random(seed);
    const Index pairs = 12;
    const auto draw = [&](Index rows, Index columns) {
      MatrixXd M(rows, columns);
      for (Index i = 0; i < rows; ++i)
        for (Index j = 0; j < columns; ++j) M(i, j) = random.uniform(-1, 1);
      return M;
    };
    const MatrixXd half = draw(pairs, pairs);
    ContactProblem problem{gram(half), VectorXd(pairs), {}, {}, draw(pairs, 3), VectorXd::Zero(3)};
    problem.rigid.col(0).setOnes();
    // Ten pairs touch after the motion (1, 0.1, -0.1), the others stay open.
    problem.free_gap = -problem.rigid * Eigen::Vector3d(1, 0.1, -0.1);
    problem.free_gap.tail(2).array() += 0.5;
    const ContactState state = solve_with_proofs(problem, find_solver("primal_dual_active_set"));
    CAPTURE(seed, state.reason, state.report.iterations);
    REQUIRE(state.report.status == SolveStatus::Solved);
    CHECK(state.force.cwiseAbs().maxCoeff() <= 1e-14);
    CHECK(state.gap.minCoeff() >= 0);
    CHECK(certify(problem, state).holds(1e-13));
  }
}

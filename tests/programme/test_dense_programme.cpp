// Dense programmes: condensation by hand, recovery of u, from K, p, A, g to a certificate.
#include <limits>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// u* = (1, -1, 2), lambda = (2, 3, 0), least energy -7.5.
DenseProgramme small_programme() {
  DenseProgramme programme{MatrixXd(3, 3), VectorXd(3), MatrixXd(3, 3), VectorXd(3)};
  programme.stiffness << 4, 1, 0, 1, 3, 1, 0, 1, 2;
  programme.load << 5, 5, 6;
  programme.A << 1, 1, 0, 0, 1, 1, 1, 0, -1;
  programme.initial_gap << 0, 1, 3;
  return programme;
}

}  // namespace

TEST_CASE("condensation eliminates the displacements of a small programme",
          "[dense_programme][closed-form][XuanLi2002-20]") {
  const DenseProgramme programme = small_programme();
  const DenseCondensed condensed = condense(programme);
  const Eigen::Vector3d u0 = Eigen::Vector3d(21, 6, 51) / 18.0;  // Cramer, det K = 18
  CHECK((programme.stiffness * u0 - programme.load).norm() < 1e-14);
  CHECK((condensed.free_displacement - u0).norm() < 1e-14);
  const MatrixXd G = condensed.problem.compliance;
  const MatrixXd exact =
      programme.A * LuFactor(programme.stiffness).solve_columns(programme.A.transpose());
  CHECK((G - exact).norm() < 1e-14);
  CHECK(G == G.transpose());
  CHECK((condensed.problem.free_gap - (programme.initial_gap - programme.A * u0)).norm() < 1e-14);
}

TEST_CASE("the small programme comes to its known solution",
          "[dense_programme][closed-form][XuanLi2002-22]") {
  for (const char* name : {"quasi_active_set", "primal_dual_active_set", "goldfarb_idnani"}) {
    const DenseSolution solution = solve(small_programme(), find_solver(name));
    CAPTURE(name);
    REQUIRE(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds());
    const VectorXd u = LuFactor(small_programme().stiffness)
                           .solve(small_programme().load -
                                  small_programme().A.transpose() * solution.refined.force);
    CHECK((u - Eigen::Vector3d(1, -1, 2)).norm() < 1e-13);
    CHECK((solution.refined.displacement - Eigen::Vector3d(1, -1, 2)).norm() < 1e-13);
    CHECK((solution.refined.force - Eigen::Vector3d(2, 3, 0)).norm() < 1e-12);
    CHECK((solution.gap - Eigen::Vector3d(0, 0, 4)).norm() < 1e-13);
  }
}

TEST_CASE("the programme of Rosen and Suzuki is known to rounding", "[dense_programme]") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const KnownProgramme known = rosen_suzuki(10, 20, seed);
    CHECK(certify(known.programme, {known.displacement, {}, known.force}).worst() < 1e-14);
    CHECK((known.force.array() > 0).count() == 5);
    const VectorXd u = known.displacement;
    CHECK(known.energy ==
          Approx(0.5 * u.dot(known.programme.stiffness * u) - known.programme.load.dot(u))
              .epsilon(1e-14)
              .margin(0));
  }
  // A seed names one problem on every machine.
  CHECK(rosen_suzuki(10, 20, 1).displacement == rosen_suzuki(10, 20, 1).displacement);
  CHECK(rosen_suzuki(10, 20, 1).displacement != rosen_suzuki(10, 20, 2).displacement);
  CHECK_THROWS_AS(rosen_suzuki(0, 3, 1), std::invalid_argument);
}

TEST_CASE("what is no programme is refused and says what was expected", "[dense_programme]") {
  DenseProgramme programme = small_programme();
  programme.A.resize(2, 3);
  CHECK_THROWS_AS(condense(programme), std::invalid_argument);
  programme = small_programme();
  programme.load(1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(condense(programme), std::invalid_argument);
  programme = small_programme();
  programme.equations = 4;
  CHECK_THROWS_AS(condense(programme), std::invalid_argument);
  programme = small_programme();
  programme.stiffness(2, 2) = -1;
  CHECK_THROWS_AS(condense(programme), ProblemError);
}

TEST_CASE("neither a solution nor a proof that a solver claims is believed unseen",
          "[dense_programme]") {
  // u <= -1 and -u <= -1; the sum of both is 0 <= -2.
  const DenseProgramme impossible{MatrixXd::Ones(1, 1), VectorXd::Zero(1), Eigen::Vector2d(1, -1),
                                  Eigen::Vector2d(-1, -1)};
  static ContactState claim;
  const Solver recites = {
      "recital", "says what it was told to",
      [](const ContactProblem& /*problem*/, const SolverOptions& /*options*/) { return claim; }};
  claim.force = claim.gap = Eigen::Vector2d::Zero();
  claim.report.status = SolveStatus::Infeasible;
  claim.farkas_certificate = Eigen::Vector2d(1, 1);
  CHECK(solve(impossible, recites).report.status == SolveStatus::Infeasible);
  for (const Eigen::Vector2d& wrong : {Eigen::Vector2d(-1, -1), Eigen::Vector2d(0, 0)}) {
    claim.farkas_certificate = wrong;
    CHECK(solve(impossible, recites).report.status == SolveStatus::Breakdown);
    CHECK(solve(impossible, recites).farkas_certificate.size() == 0);
  }
  claim.report.status = SolveStatus::Solved;
  CHECK(solve(impossible, recites).report.status == SolveStatus::Breakdown);
  DenseProgramme possible = impossible;
  possible.initial_gap.setZero();
  CHECK(solve(possible, recites).report.status == SolveStatus::Solved);  // u = 0
}

TEST_CASE("a chain beside one that is loaded 1e14 times more is solved", "[dense_programme]") {
  for (const double weak : {0.0, 1e-30}) {
    DenseProgramme both{MatrixXd::Zero(12, 12), VectorXd::Ones(12), MatrixXd::Zero(6, 12),
                        VectorXd(6)};
    both.stiffness.diagonal().setConstant(2);
    for (Index i = 0; i < 11; ++i)
      if (i != 5) both.stiffness(i, i + 1) = both.stiffness(i + 1, i) = -1;
    both.stiffness(0, 6) = both.stiffness(6, 0) = weak;
    both.load.tail(6) << 1e-14, 1.1e-14, 1.2e-14, 1.3e-14, 1.4e-14, 1.5e-14;
    both.A(0, 1) = both.A(1, 7) = both.A(2, 3) = both.A(3, 9) = both.A(4, 4) = both.A(5, 10) = 1;
    both.initial_gap << 2.3, 2.3e-14, 2.9, 2.9e-14, 3.2, 3.2e-14;
    const DenseSolution solution = solve(both, find_solver("quasi_active_set"));
    CAPTURE(weak);
    REQUIRE(solution.report.status == SolveStatus::Solved);
    CHECK(solution.refined.displacement(10) <= 3.2e-14 * (1 + 1e-12));
  }
}

// Programmes whose K is only semidefinite where the equations hold: solved where one place alone has the least
// energy, else refused.
#include <cmath>
#include <vector>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using signorini_test::problem_message;

namespace {

/// x^2 / 2 - x - y - z / 2 with x + z = 1 and y <= 2, in units of which y has one of its own: x = z = 1/2, y = 2.
DenseProgramme half(double unit) {
  DenseProgramme programme;
  programme.stiffness = Vector3d(1, 0, 0).asDiagonal();
  programme.load = Vector3d(1, unit, 0.5);
  programme.A.setZero(2, 3);
  programme.A << 1, 0, 1, 0, unit, 0;
  programme.initial_gap = Eigen::Vector2d(1, 2);
  programme.equations = 1;
  return programme;
}

}  // namespace

TEST_CASE("a direction that only an inequality ends is found its end", "[dense_programme]") {
  for (const char* solver :
       {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set", "lemke"})
    for (const double unit : {1.0, 0x1p-30, 0x1p30}) {
      CAPTURE(solver, unit);
      const DenseSolution solution = solve(half(unit), find_solver(solver));
      REQUIRE(solution.report.status == SolveStatus::Solved);
      CHECK(solution.certificate.worst() <= 1e-15);
      const VectorXd& u = solution.refined.displacement;
      CHECK(u(0) == Approx(0.5).epsilon(1e-15));
      CHECK(u(1) * unit == Approx(2).epsilon(1e-15));
      CHECK(u(2) == Approx(0.5).epsilon(1e-15));
      CHECK(solution.refined.force(0) == Approx(0.5).epsilon(1e-15));
      CHECK(solution.refined.force(1) == Approx(1).epsilon(1e-15));
      CHECK(solution.active == std::vector<Index>{1});
      CHECK(solution.gap(1) == 0);
    }
}

TEST_CASE("a linear programme is one whose K is nothing", "[dense_programme]") {
  // The most of 3 x + 2 y with x + y <= 4, x + 3 y <= 6, x <= 3, x >= 0 and y >= 0: 11 at (3, 1).
  DenseProgramme programme;
  programme.stiffness = MatrixXd::Zero(2, 2);
  programme.load = Eigen::Vector2d(3, 2);
  programme.A.resize(5, 2);
  programme.A << 1, 1, 1, 3, 1, 0, -1, 0, 0, -1;
  programme.initial_gap.resize(5);
  programme.initial_gap << 4, 6, 3, 0, 0;
  const DenseSolution solution = solve(programme, find_solver("primal_dual_active_set"));
  REQUIRE(solution.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.worst() <= 1e-15);
  CHECK(solution.refined.displacement(0) == Approx(3).epsilon(1e-15));
  CHECK(solution.refined.displacement(1) == Approx(1).epsilon(1e-15));
  CHECK(solution.refined.force(0) == Approx(2).epsilon(1e-15));
  CHECK(solution.refined.force(2) == Approx(1).epsilon(1e-15));
}

TEST_CASE("forces that are small beside stiffness times displacement keep their digits",
          "[dense_programme][certificate]") {
  // Springs of 1 in a row between two ends near 1000: K feels only differences, which are small.
  const Index n = 17;
  DenseProgramme chain;
  chain.stiffness.setZero(n, n);
  for (Index i = 0; i + 1 < n; ++i)
    chain.stiffness.block(i, i, 2, 2) += (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
  chain.load.setZero(n);
  chain.A.setZero(2, n);
  for (const Index equations : {0, 1})  // a pressed row or an equation holds what K leaves free
    for (const double step : {0x1p-20, 0x1p-12, 0x1p-4})
      for (const char* name : {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set"}) {
        CAPTURE(name, equations, step);
        chain.equations = equations;
        const double a = 0.7;
        chain.A(0, 0) = a;
        chain.A(1, n - 1) = -1;
        chain.initial_gap = Eigen::Vector2d(1000 * a, -1000 - 16 * step);
        const DenseSolution solution = solve(chain, find_solver(name));
        REQUIRE(solution.report.status == SolveStatus::Solved);
        CHECK(solution.certificate.worst() <= 1e-15);
        // The first end is where a times it is the gap, which is a rounded number.
        const double off = std::fma(a, 1000.0, -chain.initial_gap(0)) / a;
        CHECK(solution.refined.force(1) == Approx(step + off / 16).epsilon(1e-14));
        CHECK(solution.refined.force(0) == Approx(solution.refined.force(1) / a).epsilon(1e-15));
        CHECK(solution.active ==
              (equations == 0 ? std::vector<Index>{0, 1} : std::vector<Index>{1}));
      }
}

TEST_CASE("energies without an end or with many places are refused", "[dense_programme]") {
  const auto refused = [](const DenseProgramme& programme) {
    return problem_message(
        [&] { static_cast<void>(solve(programme, find_solver("quasi_active_set"))); });
  };
  DenseProgramme endless = half(1);
  endless.load(1) = -1;
  CHECK_THAT(refused(endless), ContainsSubstring("not positive definite"));
  DenseProgramme many = half(1);
  many.load(1) = 0;
  CHECK_THAT(refused(many), ContainsSubstring("many places"));
  DenseProgramme saddle = half(1);
  saddle.stiffness(1, 1) = -1;
  CHECK_THAT(refused(saddle), ContainsSubstring("not positive definite"));
}

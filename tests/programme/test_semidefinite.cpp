// Programmes whose K is only semidefinite where the equations hold: proximal points end in a solution, or in a way along
// which energy falls for ever.
#include <cmath>
#include <random>
#include <vector>

#include "addons/programme/active_set_programme.hpp"
#include "addons/programme/dense_programme.hpp"
#include "addons/programme/proximal_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/rounding.hpp"
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

TEST_CASE("a K that only its rounding makes definite does not hide that the energy falls for ever",
          "[dense_programme]") {
  DenseProgramme programme;
  programme.stiffness.resize(5, 5);
  programme.stiffness << 6, -6, -5, 3, 4, -6, 8, 8, -2, -4, -5, 8, 9, -2, -2, 3, -2, -2, 5, -2, 4,
      -4, -2, -2, 8;
  programme.load = (VectorXd(5) << 3, 3, 1, 2, 0).finished();
  programme.A = (Eigen::RowVectorXd(5) << 1, -1, -1, -1, 0).finished();
  programme.initial_gap = VectorXd::Constant(1, -1);
  programme.equations = 1;
  const VectorXd falls = (VectorXd(5) << 2, 6, -4, 0, 1).finished();
  REQUIRE((programme.stiffness * falls).isZero(0));
  REQUIRE((programme.A * falls).isZero(0));
  REQUIRE(programme.load.dot(falls) == 20);
  for (const char* solver : {"quasi_active_set", "goldfarb_idnani"})
    CHECK_THAT(
        problem_message([&] { static_cast<void>(solve(programme, find_solver(solver))); }),
        ContainsSubstring("the energy has no least value") && ContainsSubstring("unknown 2 grows"));
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

TEST_CASE("energies without an end are refused by the unknown that runs away",
          "[dense_programme]") {
  const auto refused = [](const DenseProgramme& programme) {
    return problem_message(
        [&] { static_cast<void>(solve(programme, find_solver("quasi_active_set"))); });
  };
  for (const double unit : {1.0, 0x1p-30, 0x1p30}) {
    CAPTURE(unit);
    DenseProgramme endless = half(unit);
    endless.load(1) = -unit;
    CHECK_THAT(refused(endless),
               ContainsSubstring("no least value") && ContainsSubstring("unknown 2 falls most"));
  }
  // x - y falls along (1, 1) where x = y alone counts in the energy; a row far away ends the way all the same.
  DenseProgramme along{(Eigen::Matrix2d() << 1, -1, -1, 1).finished(), Eigen::Vector2d(1, 1),
                       MatrixXd::Zero(1, 2), VectorXd::Constant(1, 1e6)};
  CHECK_THAT(refused(along), ContainsSubstring("grows most"));
  along.A << 1, 0;
  const DenseSolution solution = solve(along, find_solver("quasi_active_set"));
  REQUIRE(solution.report.status == SolveStatus::Solved);
  CHECK(solution.refined.displacement(0) == Approx(1e6).epsilon(1e-15));
  CHECK(solution.refined.force(0) == Approx(2).epsilon(1e-12));
  DenseProgramme saddle = half(1);
  saddle.stiffness(1, 1) = -1;
  CHECK_THAT(refused(saddle), ContainsSubstring("not positive definite"));
}

TEST_CASE("of many places with the least energy one is found", "[dense_programme]") {
  DenseProgramme many = half(1);
  many.load(1) = 0;  // y may be anything up to 2
  for (const char* solver : {"quasi_active_set", "goldfarb_idnani", "lemke"}) {
    CAPTURE(solver);
    const DenseSolution solution = solve(many, find_solver(solver));
    REQUIRE(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.worst() <= 1e-15);
    CHECK(solution.refined.displacement(0) == Approx(0.5).epsilon(1e-15));
    CHECK(solution.refined.displacement(1) <= 2);
    CHECK(solution.refined.force(1) == 0);
  }
}

// K = B B^T of low rank, rows of which some are closed with a force: p = K x + A^T lambda makes x a solution, whatever the rank,
// so the least energy is known.
TEST_CASE("random programmes of any rank reach their least energy", "[dense_programme]") {
  std::mt19937 random(20);
  const auto number = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
  for (int run = 0; run < 400; ++run) {
    CAPTURE(run);
    const Index n = 2 + static_cast<Index>(random() % 14);
    const Index m = n + static_cast<Index>(random() % 20);
    const Index equations = static_cast<Index>(random()) % (n / 2 + 1);
    const MatrixXd B =
        MatrixXd::NullaryExpr(n, static_cast<Index>(random()) % (n - equations), number);
    const VectorXd x = VectorXd::NullaryExpr(n, number);
    VectorXd force = VectorXd::NullaryExpr(m, number);
    DenseProgramme programme;
    programme.stiffness = B * B.transpose();
    programme.A = MatrixXd::NullaryExpr(m, n, number);
    programme.equations = equations;
    programme.initial_gap = programme.A * x;
    for (Index i = programme.equations; i < m; ++i) {
      programme.initial_gap(i) += i % 3 == 0 ? 0 : std::abs(number());
      force(i) = i % 3 == 0 ? std::max(0.0, force(i)) : 0;  // some touch without a force
    }
    programme.load = programme.stiffness * x + programme.A.transpose() * force;
    const auto energy = [&](const VectorXd& u) {
      return 0.5 * u.dot(programme.stiffness * u) - programme.load.dot(u);
    };
    const DenseSolution solution = solve(programme, find_solver("goldfarb_idnani"));
    CHECK(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds());
    // The sums of an energy have up to n^2 terms of size n.
    CHECK(energy(solution.refined.displacement) ==
          Approx(energy(x)).margin(1e-12 * static_cast<double>(n * n * n)));
  }
}

TEST_CASE("an unknown that is 0 beside others without energy has no size of its own",
          "[dense_programme]") {
  // x^2 / 2 with 0.3 x + 0.7 y = 0.1 z and y >= s, of any s: x = 0, and all forces are.
  for (const double size : {1.0, 1e-13}) {
    CAPTURE(size);
    DenseProgramme programme;
    programme.stiffness = Vector3d(1, 0, 0).asDiagonal();
    programme.load.setZero(3);
    programme.A.resize(2, 3);
    programme.A << 0.3, 0.7, -0.1, 0, -1, 0;
    programme.initial_gap = Eigen::Vector2d(0, -size);
    programme.equations = 1;
    const DenseSolution solution = solve(programme, find_solver("goldfarb_idnani"));
    REQUIRE(solution.report.status == SolveStatus::Solved);
    CHECK(solution.refined.displacement(0) == 0);
    CHECK(solution.refined.force.isZero(0));
  }
}

TEST_CASE("equations that hold all unknowns at 0 leave nothing but 0", "[dense_programme]") {
  const Index n = 9;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    DenseProgramme programme;
    programme.stiffness.setZero(n, n);
    programme.load = VectorXd::NullaryExpr(n, [&] { return uniform(random); });
    programme.A.setZero(2 * n, n);
    programme.A.topRows(n) = MatrixXd::NullaryExpr(n, n, [&] { return uniform(random); });
    programme.A.bottomRows(n).setIdentity();
    programme.initial_gap = VectorXd::Zero(2 * n);
    programme.initial_gap.tail(n).setConstant(75);
    programme.equations = n;
    for (const char* solver : {"quasi_active_set", "goldfarb_idnani"}) {
      CAPTURE(seed, solver);
      const DenseSolution solution = solve(programme, find_solver(solver));
      REQUIRE(solution.report.status == SolveStatus::Solved);
      CHECK(largest(solution.refined.displacement) <= 1e-15);
      CHECK(solution.certificate.holds());
    }
  }
}

// d = (-2, 3, 0, 0, -1, 1, 3, 1) is felt by neither K nor the equations, of which the first four have the rank 3, and the last row grows
// along it. Multipliers of such equations may be of any size, beside which no load is seen.
TEST_CASE("a place without displacements is no solution where the energy falls for ever", "[dense_programme]") {
  DenseProgramme programme;
  const VectorXd d = (VectorXd(8) << -2, 3, 0, 0, -1, 1, 3, 1).finished();
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> whole(-4, 4);
    const MatrixXd off = MatrixXd::Identity(8, 8) - d * d.transpose() / d.squaredNorm();
    const auto rows = [&](Index count) -> MatrixXd {
      return MatrixXd::NullaryExpr(count, 8, [&] { return double(whole(random)); }) * off;
    };
    const MatrixXd root = rows(3);
    programme.stiffness = root.transpose() * root;
    programme.load = rows(1).transpose() + d;
    programme.A.resize(7, 8);
    programme.A.topRows(4) = rows(4);
    programme.A.row(3) = programme.A.row(0) + programme.A.row(1);
    programme.A.middleRows(4, 2) = rows(2);
    programme.A.row(6) = -d.transpose();
    programme.initial_gap = (VectorXd(7) << 0, 0, 0, 0, 5, 4, 1).finished();
    programme.equations = 4;
    CAPTURE(seed);
    try {
      CHECK(solve(programme, find_solver("quasi_active_set")).report.status != SolveStatus::Solved);
    } catch (const ProblemError& error) {
      CHECK(std::string(error.what()).find("no least value") != std::string::npos);
    }
  }
}

// A linear programme of which the equations leave nothing but 0, though one of them follows from others.
TEST_CASE("a programme without a choice is solved, whatever its load", "[dense_programme]") {
  DenseProgramme programme;
  programme.stiffness.setZero(4, 4);
  programme.load = (VectorXd(4) << 0, 0, -3, 5).finished();
  programme.A.resize(8, 4);
  programme.A << 4, -4, 3, -4, -3, -4, -1, -2, 4, -1, -1, -1, 3, -4, 3, -4, 4, 2, -1, -3, -3, -3, -4, 1,
      4, -4, -3, 2, -2, -3, -2, -4;
  programme.initial_gap = VectorXd::Zero(8);
  programme.equations = 7;
  for (const char* solver : {"quasi_active_set", "goldfarb_idnani"}) {
    CAPTURE(solver);
    const DenseSolution solution = solve(programme, find_solver(solver));
    CHECK(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds());
  }
}

// Five equations of the rank 4, whose right sides are 0: nothing but 0 satisfies them. Of the last one elimination leaves rounding.
TEST_CASE("equations whose right sides are 0 do not contradict each other", "[dense_programme]") {
  DenseProgramme programme;
  programme.stiffness.resize(4, 4);
  programme.stiffness << 13, -20, -2, 2, -20, 32, 4, 0, -2, 4, 1, 2, 2, 0, 2, 8;
  programme.load = (VectorXd(4) << -6, -9, 17, 3).finished();
  programme.A.resize(7, 4);
  programme.A << 3, 2, -3, 0, -2, 1, -4, -1, -2, -1, 2, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 2, 2, 0, 0, 0, -1;
  programme.initial_gap = (VectorXd(7) << 0, 0, 0, 0, 0, 0, 1).finished();
  programme.equations = 5;
  const DenseSolution solution = solve(programme, find_solver("quasi_active_set"));
  REQUIRE(solution.report.status == SolveStatus::Solved);
  CHECK(largest(solution.refined.displacement) <= 1e-15);
  programme.initial_gap(3) = 1;  // twice the first and three times the third make the fourth
  CHECK(solve(programme, find_solver("quasi_active_set")).report.status == SolveStatus::Infeasible);
}

// Neither K nor a load: whatever the rows allow is a solution, and nothing but a place is asked for.
TEST_CASE("rows alone are a programme whose solutions are all that they allow", "[dense_programme]") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> small(-2, 2);
  for (int run = 0; run < 200; ++run) {
    CAPTURE(run);
    const Index n = 1 + run % 5, m = 1 + run % 7;
    DenseProgramme programme;
    programme.stiffness.setZero(n, n);
    programme.load.setZero(n);
    programme.A = MatrixXd::NullaryExpr(m, n, [&] { return double(small(random)); });
    const VectorXd place = VectorXd::NullaryExpr(n, [&] { return double(small(random)); });
    programme.initial_gap = programme.A * place;
    programme.equations = std::min<Index>(run % 3, m);
    programme.initial_gap.tail(m - programme.equations).array() += run % 2;
    const DenseSolution solution = solve(programme, find_solver("quasi_active_set"));
    CHECK(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds());
    CHECK(solution.refined.force.isZero(0));
  }
}

// Linear programmes; the method says that it has solved what it was started with, but has no numbers.
TEST_CASE("a proximal point that the last rows do not lead to is looked for from none",
          "[dense_programme]") {
  const Index n = 6, m = 14;
  int lost = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    DenseProgramme programme;
    programme.stiffness.setZero(n, n);
    programme.A.resize(m, n);
    programme.A.topRows(m - n) = MatrixXd::NullaryExpr(m - n, n, [&] { return uniform(random); });
    programme.A.bottomRows(n).setIdentity();
    programme.initial_gap = VectorXd::NullaryExpr(m, [&] { return 1e9 * (2 + uniform(random)); });
    programme.load = programme.A.transpose() * VectorXd::NullaryExpr(m, [&] { return 1 + uniform(random); });
    const DenseSolution solution =
        proximal_solution(programme, [&](const DenseProgramme& near, SolverOptions from) {
          DenseSolution point = goldfarb_idnani(near, from);
          if (from.start.empty()) return point;
          ++lost;
          point.refined.force.setConstant(std::nan(""));
          return point;
        });
    CHECK(solution.certificate.holds());
  }
  CHECK(lost > 0);
}

TEST_CASE("where nothing satisfies the rows a semidefinite programme has its proof",
          "[dense_programme]") {
  DenseProgramme narrow = half(1);
  narrow.A.conservativeResize(3, 3);
  narrow.A.row(2) << 0, -1, 0;
  narrow.initial_gap = Vector3d(1, 2, -3);  // y <= 2 and y >= 3
  for (const char* solver : {"quasi_active_set", "goldfarb_idnani", "lemke"}) {
    CAPTURE(solver);
    const DenseSolution solution = solve(narrow, find_solver(solver));
    REQUIRE(solution.report.status == SolveStatus::Infeasible);
    CHECK(proves_infeasible(narrow, solution.farkas_certificate, solution.refined.displacement));
  }
}

// Unknowns without stiffness and load that equations define by others, z = a x: their equations carry no force but that of
// rounding, which is no yardstick.
#include <cmath>
#include <cstdint>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// Least energy of x with bounds on x and z = D x, which are unknowns of their own or written out.
struct Defined {
  DenseProgramme unknowns;  ///< of x, then z
  DenseProgramme written;   ///< of x alone
};

/// Three digits behind the point.
double short_number(Random& random, double size) {
  return std::round(1000 * random.uniform(-size, size)) / 1000;
}

MatrixXd short_numbers(Random& random, Index rows, Index columns, double size) {
  return MatrixXd::NullaryExpr(rows, columns, [&] { return short_number(random, size); });
}

/// Some of the bounds hold x off its least energy. \param chained  z of earlier z
Defined draw(Random& random, bool chained) {
  const Index n = random.whole(1, 6);
  const Index m = random.whole(1, 3);
  Defined made;
  DenseProgramme& written = made.written;
  const MatrixXd B = short_numbers(random, n, n, 1.5);
  written.stiffness = B.transpose() * B + MatrixXd::Identity(n, n);
  written.load = short_numbers(random, n, 1, 2);
  const MatrixXd C = short_numbers(random, m, n, 2.5);
  MatrixXd L = MatrixXd::Identity(m, m);  // L z = C x
  for (Index i = 1; i < m && chained; ++i) L.row(i).head(i) = short_numbers(random, 1, i, 2);
  const MatrixXd D = L.triangularView<Eigen::UnitLower>().solve(C);
  const Index count = n + m;
  written.A.resize(2 * count, n);
  written.A << MatrixXd::Identity(n, n), D, -MatrixXd::Identity(n, n), -D;
  written.initial_gap.resize(2 * count);
  for (Index i = 0; i < 2 * count; ++i)
    written.initial_gap(i) = random.whole(0, 3) == 0 ? 0.25 : 10;
  DenseProgramme& all = made.unknowns;
  all.equations = m;
  all.stiffness.setZero(count, count);
  all.stiffness.topLeftCorner(n, n) = written.stiffness;
  all.load.setZero(count);
  all.load.head(n) = written.load;
  all.A.setZero(m + 2 * count, count);
  all.A.topRows(m) << C, -L;
  all.A.middleRows(m, count).setIdentity();
  all.A.bottomRows(count) = -MatrixXd::Identity(count, count);
  all.initial_gap.setZero(m + 2 * count);
  all.initial_gap.tail(2 * count) = written.initial_gap;
  return made;
}

/// The same with another unit of each unknown and of each row.
DenseProgramme in_units(DenseProgramme programme, const VectorXd& unknown, const VectorXd& row) {
  programme.stiffness = unknown.asDiagonal() * programme.stiffness * unknown.asDiagonal();
  programme.load = unknown.cwiseProduct(programme.load);
  programme.A = row.asDiagonal() * programme.A * unknown.asDiagonal();
  programme.initial_gap = row.cwiseProduct(programme.initial_gap);
  return programme;
}

VectorXd powers_of_two(Random& random, Index count) {
  return VectorXd::NullaryExpr(count, [&] { return std::ldexp(1, random.whole(-20, 20)); });
}

/// 3/2 x^2 - x with z = 0.7 x and |z| <= 10: x = 1/3.
DenseProgramme simple() {
  DenseProgramme programme;
  programme.stiffness = Eigen::Vector2d(3, 0).asDiagonal();
  programme.load = Eigen::Vector2d(1, 0);
  programme.A.resize(3, 2);
  programme.A << 0.7, -1, 0, 1, 0, -1;
  programme.initial_gap = Eigen::Vector3d(0, 10, 10);
  programme.equations = 1;
  return programme;
}

}  // namespace

TEST_CASE("an unknown that an equation defines is measured by what defines it",
          "[dense_programme][certificate]") {
  const DenseProgramme programme = simple();
  for (const char* name :
       {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set", "lemke", "enumerate"}) {
    CAPTURE(name);
    const DenseSolution solution = solve(programme, find_solver(name));
    REQUIRE(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.worst() <= 4 * epsilon);
    CHECK(solution.refined.displacement(0) == Approx(1 / 3.0).epsilon(1e-15));
    CHECK(solution.refined.displacement(1) == Approx(0.7 / 3).epsilon(1e-15));
  }
}

TEST_CASE("60 programmes with defined unknowns are those with the definitions written out",
          "[dense_programme][certificate]") {
  for (const char* name : {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set"})
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Random random(seed);
      const Defined made = draw(random, seed % 2 == 1);
      const Index n = made.written.load.size();
      const Index count = made.unknowns.load.size();
      const bool units = seed % 3 == 2;
      const VectorXd unknown =
          units ? powers_of_two(random, count) : VectorXd(VectorXd::Ones(count));
      const Index rows = made.unknowns.initial_gap.size();
      const VectorXd row = units ? powers_of_two(random, rows) : VectorXd(VectorXd::Ones(rows));
      CAPTURE(name, seed, n, count);
      const DenseSolution written = solve(made.written, find_solver(name));
      const DenseSolution solution =
          solve(in_units(made.unknowns, unknown, row), find_solver(name));
      REQUIRE(written.report.status == SolveStatus::Solved);
      CHECK(solution.report.status == SolveStatus::Solved);
      CHECK(solution.certificate.worst() <= 1e-13);
      const VectorXd u = unknown.cwiseProduct(solution.refined.displacement);
      CHECK((u.head(n) - written.refined.displacement).norm() <=
            1e-12 * written.refined.displacement.norm());
    }
}

TEST_CASE("forged: what an equation hands on is measured by whom it reaches", "[certificate]") {
  // x on a spring of 2^-40, z = x loaded by 2^-50, and y, which bears a load of 1: z pulls x by 2^-10.
  DenseProgramme programme;
  programme.stiffness = Eigen::Vector3d(0x1p-40, 0, 1).asDiagonal();
  programme.load = Eigen::Vector3d(0, 0x1p-50, 1);
  programme.A.resize(2, 3);
  programme.A << 1, -1, 0, 1, 0, 1;
  programme.initial_gap = Eigen::Vector2d(0, 2);
  programme.equations = 1;
  const double moved = 0x1p-10;
  const PrimalDual right{Eigen::Vector3d(moved, moved, 1), {}, Eigen::Vector2d(-0x1p-50, 0)};
  CHECK(certify(programme, right).worst() == 0);
  const PrimalDual still{Eigen::Vector3d(0, 0, 1), {}, Eigen::Vector2d::Zero()};
  CHECK(certify(programme, still).equilibrium > 1e-10);
  // A force of the equation that is off by rounding of what x has is none.
  const PrimalDual rounded{right.displacement, {}, right.force * (1 + 0x1p-30)};
  CHECK(certify(programme, rounded).holds());
}

TEST_CASE("forged: only equations hand on, not rows that bear one way", "[certificate]") {
  // z has no stiffness, and a load of 2^-45 moves it until z - x = 1.
  QuadraticProgramme programme;
  programme.stiffness = MatrixXd(Eigen::Vector2d(1, 0).asDiagonal()).sparseView();
  programme.load = Eigen::Vector2d(1, 0x1p-45);
  programme.A = MatrixXd(Eigen::RowVector2d(-1, 1)).sparseView();
  programme.initial_gap = VectorXd::Ones(1);
  const PrimalDual still{Eigen::Vector2d(1, 0), {}, VectorXd::Zero(1)};
  CHECK(certify(programme, still).equilibrium == 1);
  const double x = 1 + 0x1p-45;
  CHECK(
      certify(programme, {Eigen::Vector2d(x, x + 1), {}, VectorXd::Constant(1, 0x1p-45)}).worst() ==
      0);
}

TEST_CASE("forged: a stiff unknown that only an equation joins hides nothing of a soft one",
          "[certificate]") {
  DenseProgramme programme;
  programme.stiffness = Eigen::Vector3d(0x1p-30, 0x1p30, 0).asDiagonal();
  programme.load = Eigen::Vector3d(0x1p-29, -0x3p30, 0);
  programme.A = Eigen::RowVector3d(-2, -1, -1);
  programme.initial_gap = VectorXd::Zero(1);
  programme.equations = 1;
  CHECK(certify(programme, {Eigen::Vector3d(2, -3, -1), {}, VectorXd::Zero(1)}).worst() == 0);
  const double off =
      0x1p-10;  // a residual of 2^-40, which is 2^-40 of the root of the product of both stiffnesses
  const Eigen::Vector3d moved(2 + off, -3, -1 - 2 * off);
  CHECK(certify(programme, {moved, {}, VectorXd::Zero(1)}).equilibrium > 1e-4);
}

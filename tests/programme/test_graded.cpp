// Programmes with stiffnesses and forces of very different size, whose exact solution is known: nothing wrong is certified.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "addons/programme/active_set_programme.hpp"
#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/rounding.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;

namespace {

/// A programme and its only solution, both without rounding.
struct Graded {
  DenseProgramme programme;
  VectorXd u;
  VectorXd force;
};

/// p = K u + A^T lambda. \return whether all sums are doubles
bool balance(Graded& graded) {
  DenseProgramme& programme = graded.programme;
  programme.load.resize(graded.u.size());
  for (Index j = 0; j < graded.u.size(); ++j) {
    ExactSum sum;
    sum.add_product(programme.stiffness(j, j), graded.u(j));
    for (Index i = 0; i < graded.force.size(); ++i)
      sum.add_product(programme.A(i, j), graded.force(i));
    programme.load(j) = sum.high();
    if (sum.low() != 0) return false;
  }
  return true;
}

/// K diagonal with powers of two; rows of whole numbers, the first n of them independent and some of them closed, with
/// powers of two as forces; u of whole numbers, or 0.
Graded draw(std::uint64_t seed) {
  for (Random random(seed);;) {
    const int n = random.whole(2, 6);
    const int m = random.whole(1, n + 2);
    const int span = random.whole(4, 30);
    const bool even = random.whole(0, 1) == 0;
    const bool chained = random.whole(0, 1) == 0;
    const int most = random.whole(0, span);
    const int size = random.whole(0, 5) == 0 ? 0 : 3;
    Graded graded;
    MatrixXd& A = graded.programme.A;
    graded.programme.stiffness.setZero(n, n);
    A.setZero(m, n);
    graded.u.resize(n);
    graded.force.setZero(m);
    for (int j = 0; j < n; ++j) {
      const int power = even ? 2 * span * j / (n - 1) : random.whole(0, 2 * span);
      graded.programme.stiffness(j, j) = std::ldexp(1, power - span);
      graded.u(j) = random.whole(-size, size);
    }
    for (int i = 0; i < m; ++i)
      for (int j = 0; j <= std::min(i, n - 1); ++j)
        A(i, j) = i >= n ? random.whole(-2, 2) : chained || i == j ? 1 : random.whole(-1, 1);
    graded.programme.initial_gap = A * graded.u;
    for (int i = 0; i < m; ++i) {
      if (i < n && random.whole(0, 1) == 0)
        graded.force(i) = std::ldexp(1, random.whole(-most / 2, most));
      else if (i >= n || random.whole(0, 1) == 0)
        graded.programme.initial_gap(i) += std::ldexp(1, random.whole(-8, 3));
    }
    if (balance(graded)) return graded;
  }
}

/// The same with unknowns that equations define by the others; open rows feel them, too. Mostly they have no stiffness, and
/// half of their equations no force.
Graded draw_defined(std::uint64_t seed) {
  for (Random random(seed);; ++seed) {
    const Graded plain = draw(seed);
    const Index n = plain.u.size();
    const Index rows = plain.force.size();
    const Index defined = random.whole(1, 3);
    Graded graded;
    DenseProgramme& programme = graded.programme;
    programme.equations = defined;
    programme.stiffness.setZero(n + defined, n + defined);
    programme.stiffness.topLeftCorner(n, n) = plain.programme.stiffness;
    programme.A.setZero(defined + rows, n + defined);
    programme.A.topRightCorner(defined, defined) = -MatrixXd::Identity(defined, defined);
    programme.A.bottomLeftCorner(rows, n) = plain.programme.A;
    graded.u.setZero(n + defined);
    graded.u.head(n) = plain.u;
    graded.force.setZero(defined + rows);
    graded.force.tail(rows) = plain.force;
    for (Index k = 0; k < defined; ++k) {
      for (Index j = 0; j < n; ++j) programme.A(k, j) = random.whole(-2, 2);
      graded.u(n + k) = programme.A.row(k).head(n).dot(plain.u);
      if (random.whole(0, 3) == 0)
        programme.stiffness(n + k, n + k) = std::ldexp(1, random.whole(-30, 30));
      if (random.whole(0, 1) == 0)
        graded.force(k) = (random.whole(0, 1) - 0.5) * std::ldexp(1, random.whole(-40, 20));
    }
    const VectorXd open = plain.programme.initial_gap - plain.programme.A * plain.u;
    for (Index i = 0; i < rows; ++i)
      for (Index k = 0; k < defined && open(i) > 0; ++k)
        programme.A(defined + i, n + k) = random.whole(-1, 1);
    programme.initial_gap = programme.A * graded.u;
    programme.initial_gap.tail(rows) += open;
    if (balance(graded)) return graded;
  }
}

/// The three stiffnesses 2^-22, 1, 2^22 behind chained rows.
Graded three_chained() {
  Graded graded;
  graded.programme.stiffness = Eigen::Vector3d(0x1p-22, 1, 0x1p22).asDiagonal();
  graded.programme.A = MatrixXd(MatrixXd::Ones(3, 3).triangularView<Eigen::Lower>());
  graded.programme.initial_gap = Eigen::Vector3d(1, 2, 3);
  graded.u.setOnes(3);
  graded.force = Eigen::Vector3d(1, 1, 0x1p20);
  REQUIRE(balance(graded));
  return graded;
}

/// How far a solution is from the exact one: of the gaps, and of the forces.
double error(const Graded& exact, const DenseSolution& found) {
  const DenseProgramme& programme = exact.programme;
  const VectorXd moved = programme.A * (found.refined.displacement - exact.u);
  const double length = largest(programme.A.cwiseAbs() * exact.u.cwiseAbs());
  return std::max(largest(moved) / (length > 0 ? length : 1),
                  ratio(largest(found.refined.force - exact.force), largest(programme.load)));
}

}  // namespace

TEST_CASE("a soft unknown that contact holds dwarfs no overlap", "[dense_programme][certificate]") {
  const Graded exact = three_chained();
  // The second pair open: it overlaps by 2.4e-7, and what it carried is a millionth of the third one's force.
  const PrimalDual other{Eigen::Vector3d(1, 1 + 0x1p-22, 1 - 0x1p-22),
                         {},
                         Eigen::Vector3d(1 + 0x1p-22, 0, 0x1p20 + 1)};
  CHECK(certify(exact.programme, other).equilibrium < 1e-12);
  CHECK(certify(exact.programme, other).penetration > 1e-8);
  CHECK(certify(exact.programme, {exact.u, {}, exact.force}).worst() == 0);
  for (const char* name : {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set"}) {
    CAPTURE(name);
    const DenseSolution found = solve(exact.programme, find_solver(name));
    REQUIRE(found.report.status == SolveStatus::Solved);
    CHECK(found.active == std::vector<Index>{0, 1, 2});
    CHECK(error(exact, found) < 1e-15);
  }
}

TEST_CASE("no force on other unknowns hides what an unknown lacks itself",
          "[dense_programme][certificate]") {
  Graded exact;
  exact.programme.stiffness = Eigen::Vector4d(0x1p-14, 0x1p24, 0x1p30, 0x1p-27).asDiagonal();
  exact.programme.A = MatrixXd(5, 4);
  exact.programme.A << MatrixXd(MatrixXd::Ones(4, 4).triangularView<Eigen::Lower>()),
      Eigen::RowVector4d(-2, -2, -2, 1);
  exact.programme.initial_gap.resize(5);
  exact.programme.initial_gap << 3, 3, 12, 8, -4;
  exact.u = Eigen::Vector4d(3, 0, 1, 3);
  exact.force.setZero(5);
  exact.force.head(2) << 0x1p30, 0x1p-11;
  REQUIRE(balance(exact));
  CHECK(certify(exact.programme, {exact.u, {}, exact.force}).worst() == 0);
  // The fourth pair touched: its force of -2^-27 is rounding beside 2^30.
  const Certificate touched =
      certify(exact.programme, {Eigen::Vector4d(3, 0, 1, 4), {}, exact.force});
  CHECK(touched.penetration == 0);
  CHECK(touched.duality_gap < 1e-12);
  CHECK(touched.equilibrium > 1e-10);
  for (const Solver& solver : solvers()) {
    CAPTURE(solver.name);
    const DenseSolution found = solve(exact.programme, solver);
    if (found.report.status == SolveStatus::Solved)
      CHECK(largest(found.refined.displacement - exact.u) < 1e-12);
  }
}

TEST_CASE("a load that contact holds dwarfs no overlap", "[dense_programme][certificate]") {
  // Forces of 2^19 on stiffnesses of 2^-17: what is left for the body to carry moves it by 3.
  DenseProgramme programme;
  programme.stiffness = MatrixXd(3, 3);
  programme.stiffness << 1, 1, 0, 1, 5, 4, 0, 4, 4 + 0x1p-8;
  programme.stiffness *= 0x1p-19;
  programme.A = MatrixXd(Eigen::Matrix3d::Ones().triangularView<Eigen::Lower>());
  programme.initial_gap = Eigen::Vector3d(-3, 0, 0);
  const Eigen::Vector3d u(-3, 3, 0);
  const Eigen::Vector3d force(0x1p7, 0x1p19, 0x1p18);
  programme.load = programme.stiffness * u + programme.A.transpose() * force;
  CHECK(certify(programme, {u, {}, force}).worst() == 0);
  const double overlap = 0x1p-5;
  const Certificate inside =
      certify(programme, {Eigen::Vector3d(-3 + overlap, 3 - overlap, 0), {}, force});
  CHECK(inside.equilibrium < 1e-10);
  CHECK(inside.penetration > 1e-3);
}

TEST_CASE("displacements that are zero are refined until none is rounding of the free ones",
          "[dense_programme][certificate]") {
  DenseProgramme programme;
  programme.stiffness = MatrixXd(2, 2);
  programme.stiffness << 0x1p-11, 0x1p-11, 0x1p-11, 0x1p11 + 0x1p-11;
  programme.load = Eigen::Vector2d(128, 0);
  programme.A = MatrixXd(Eigen::Matrix2d::Ones().triangularView<Eigen::Lower>());
  programme.initial_gap = Eigen::Vector2d(0, 2);
  const PrimalDual rounded{Eigen::Vector2d(0, 0x1p-57), {}, Eigen::Vector2d(128, 0)};
  CHECK(certify(programme, rounded).equilibrium > 1e-6);
  for (const char* name : {"quasi_active_set", "goldfarb_idnani", "primal_dual_active_set"}) {
    CAPTURE(name);
    const DenseSolution found = solve(programme, find_solver(name));
    REQUIRE(found.report.status == SolveStatus::Solved);
    CHECK(largest(found.refined.displacement) < 1e-28);
    CHECK(found.refined.force == Eigen::Vector2d(128, 0));
  }
}

TEST_CASE("of graded programmes with an exact solution none is certified and wrong",
          "[dense_programme][certificate]") {
  for (const Solver& solver : solvers()) {
    const bool exact_rows = on_programmes(solver) != nullptr;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const Graded exact = draw(seed);
      const DenseSolution found = solve(exact.programme, solver);
      const bool solved = found.report.status == SolveStatus::Solved;
      CAPTURE(solver.name, seed, to_string(found.report.status));
      if (exact_rows) CHECK(solved);
      if (solved) CHECK(error(exact, found) < 1e-9);  // 1e-12, and what rows do to each other
    }
  }
}

TEST_CASE("of graded programmes with defined unknowns none is certified and wrong",
          "[dense_programme][certificate]") {
  for (const Solver& solver : solvers()) {
    int solved = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const Graded exact = draw_defined(seed);
      CAPTURE(solver.name, seed);
      REQUIRE(certify(exact.programme, {exact.u, {}, exact.force}).worst() == 0);
      DenseSolution found;
      try {
        found = solve(exact.programme, solver);
      } catch (const ProblemError&) {  // K is definite, but not to rounding
        continue;
      }
      if (found.report.status == SolveStatus::Solved) CHECK(error(exact, found) < 1e-9);
      solved += found.report.status == SolveStatus::Solved ? 1 : 0;
    }
    if (on_programmes(solver) != nullptr) CHECK(solved == 200);
  }
}

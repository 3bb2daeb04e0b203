// From two-sided rows to one-sided ones and back, against published optima.
#include <filesystem>

#include "addons/files/problem_file.hpp"
#include "addons/files/two_sided.hpp"
#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/message.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace signorini;
using signorini_test::problem_message;

namespace {

TwoSidedProgramme from_file(const std::string& name, const char* folder = "maros_meszaros") {
  return std::get<TwoSidedProgramme>(read_problem(std::filesystem::path(SIGNORINI_TEST_DATA) /
                                                  folder / (name + ".txt")));
}

/// Two unknowns, P = diag(2, 4), and the rows: x1 free, 1 <= x1 <= 3, x1 + x2 = 2, x2 <= 5, x2 >= -7.
TwoSidedProgramme small() {
  TwoSidedProgramme programme;
  programme.P = Eigen::Vector2d(2, 4).asDiagonal();
  programme.q = Eigen::Vector2d(-1, 1);
  programme.r = 10;
  programme.A.resize(5, 2);
  programme.A << 1, 0, 1, 0, 1, 1, 0, 1, 0, 1;
  programme.lower.resize(5);
  programme.lower << -1e20, 1, 2, -1e30, -7;
  programme.upper.resize(5);
  programme.upper << 1e20, 3, 2, 5, 1e20;
  return programme;
}

}  // namespace

TEST_CASE("equations come first, then one row for each finite bound", "[two_sided]") {
  const OneSided form = one_sided(small());
  CHECK(form.programme.equations == 1);
  MatrixXd A(5, 2);
  A << 1, 1, 1, 0, -1, 0, 0, 1, 0, -1;
  VectorXd g(5);
  g << 2, 3, -1, 5, 7;
  CHECK(form.programme.A == A);
  CHECK(form.programme.initial_gap == g);
  CHECK(form.programme.load == Eigen::Vector2d(1, -1));
  VectorXd force(5);
  force << -0.5, 2, 0, 0, 3;
  VectorXd y(5);
  y << 0, 2, -0.5, 0, -3;
  CHECK(multipliers(form, force, 5) == y);
  CHECK_THROWS_AS(multipliers(form, VectorXd::Zero(4), 5), std::invalid_argument);
}

TEST_CASE("the objective is that of the file", "[two_sided]") {
  const TwoSidedProgramme programme = small();
  // 1/2 (2 * 9 + 4 * 1) - 3 - 1 + 10
  CHECK(objective(programme, {Eigen::Vector2d(3, -1), {}, {}}) == 17);
  // A low part of 1e-18 shifts it by the slope, here P x + q = (5, -3), and not at all after rounding.
  CHECK(objective(programme, {Eigen::Vector2d(3, -1), Eigen::Vector2d(1e-18, 0), {}}) == 17);
  CHECK(objective(programme, {Eigen::Vector2d(3, -1), Eigen::Vector2d(1e-3, 0), {}}) ==
        Approx(17 + 5e-3).epsilon(1e-15));
  CHECK_THROWS_AS(objective(programme, {Eigen::Vector3d(1, 2, 3), {}, {}}), std::invalid_argument);
}

TEST_CASE("collected programmes reach their published optimum with every sign right",
          "[two_sided][closed-form]") {
  for (const char* name :
       {"DUALC1", "GENHS28", "HS21", "HS268", "HS35", "HS52", "QPTEST", "TAME", "ZECEVIC2"}) {
    CAPTURE(name);
    const TwoSidedProgramme programme = from_file(name);
    const OneSided form = one_sided(programme);
    const DenseSolution solution = solve(form.programme, find_solver("quasi_active_set"));
    REQUIRE(solution.report.status == SolveStatus::Solved);
    CHECK(solution.certificate.holds());
    const VectorXd x = solution.refined.displacement;
    REQUIRE(programme.published_optimum);
    // The optima are printed with nine digits; HS268 is published as 5.7e-7, exactly it is 0.
    CHECK(objective(programme, solution.refined) ==
          Approx(*programme.published_optimum).epsilon(1e-8).margin(1e-6));
    const VectorXd y = multipliers(form, solution.refined.force, programme.lower.size());
    const VectorXd slope = programme.P * x + programme.q + programme.A.transpose() * y;
    const double scale = 1 + programme.P.cwiseAbs().maxCoeff() * x.cwiseAbs().maxCoeff();
    CHECK(slope.cwiseAbs().maxCoeff() < 1e-13 * scale * static_cast<double>(x.size()));
    const VectorXd row = programme.A * x;
    for (Index i = 0; i < row.size(); ++i) {
      const double size = programme.A.row(i).cwiseAbs() * x.cwiseAbs() + 1;
      CHECK(row(i) >= programme.lower(i) - 1e-14 * size);
      CHECK(row(i) <= programme.upper(i) + 1e-14 * size);
      if (programme.lower(i) == programme.upper(i)) continue;
      if (y(i) > 0) CHECK(std::abs(row(i) - programme.upper(i)) < 1e-13 * size);
      if (y(i) < 0) CHECK(std::abs(row(i) - programme.lower(i)) < 1e-13 * size);
    }
  }
}

// Rounded, g g^T has eigenvalues of either sign beside n.
TEST_CASE("a programme of rank one is convex, whatever rounding says", "[two_sided][random]") {
  signorini_test::Random random(5);
  for (int round = 0; round < 40; ++round) {
    const Index n = 3 + round;
    const Eigen::VectorXd g = Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(-1, 1); });
    TwoSidedProgramme programme;
    programme.P = g * g.transpose();
    programme.q = Eigen::VectorXd::Zero(n);
    programme.A = Eigen::MatrixXd::Identity(n, n);
    programme.lower = Eigen::VectorXd::Constant(n, -1);
    programme.upper = Eigen::VectorXd::Constant(n, 1);
    CAPTURE(n);
    CHECK(problem_message([&] { static_cast<void>(one_sided(programme)); }).empty());
    programme.P -= 1e-9 * Eigen::MatrixXd::Identity(n, n);
    CHECK_THAT(problem_message([&] { static_cast<void>(one_sided(programme)); }), ContainsSubstring("convex"));
  }
}

TEST_CASE("a programme that is not convex is refused, whatever its units", "[two_sided]") {
  const auto said = [](const TwoSidedProgramme& programme) {
    return problem_message([&] { static_cast<void>(one_sided(programme)); });
  };
  CHECK_FALSE(one_sided(from_file("ZECEVIC2")).definite);
  TwoSidedProgramme programme = small();
  for (const double unit : {1e-12, 1.0, 1e12}) {  // of the second unknown
    programme.P << 2, unit, unit, unit * unit;
    programme.A.col(1) = Eigen::VectorXd::Ones(5) * unit;
    CHECK(said(programme).empty());  // positive definite
    programme.P << 2, 2 * unit, 2 * unit,
        unit * unit;  // 2 t^2 - 4 t^2 + t^2 < 0 along (1, -1/unit)
    CHECK_THAT(said(programme), ContainsSubstring("where the equations hold"));
    programme.P << 0, 0, 0, unit * unit;  // positive along x1 + unit x2 = 0 alone
    CHECK(one_sided(programme).definite);
    programme.lower(2) = 1;  // no equation any more
    CHECK_FALSE(one_sided(programme).definite);
    programme.lower(2) = 2;
  }
}

// Multipliers of equations that depend on each other may be of any size, and beside 1e300 no load is seen.
TEST_CASE("a programme whose energy falls for ever is not solved by large multipliers", "[two_sided]") {
  const OneSided form = one_sided(from_file("falls_for_ever", "found"));
  CHECK_THAT(problem_message([&] {
               static_cast<void>(solve(form.programme, find_solver("quasi_active_set")));
             }),
             ContainsSubstring("the energy has no least value"));
}

#include <cmath>
#include <vector>

#include "addons/programme/dense_programme.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/examples.hpp"
#include "papers/solver_table.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex9_2::Penalised;
using ex9_2::penalty;
using signorini::DenseProgramme;

namespace {

/// A string of n nodes with spacing 1 and tension 1, pulled by 1 onto obstacles at `height` below.
DenseProgramme string_over(Index n, double height) {
  DenseProgramme string;
  string.stiffness = 2 * MatrixXd::Identity(n, n);
  for (Index i = 0; i + 1 < n; ++i) string.stiffness(i, i + 1) = string.stiffness(i + 1, i) = -1;
  string.load = VectorXd::Ones(n);
  string.A = MatrixXd::Identity(n, n);
  string.initial_gap = VectorXd::Constant(n, height);
  return string;
}

}  // namespace

TEST_CASE("ex9.2 held out: forces push, equilibrium and the law of the springs hold", "[ex9.2]") {
  const DenseProgramme string = string_over(15, 5);
  const Penalised end = penalty(string, 50);
  REQUIRE(end.settled);
  CHECK(end.force.minCoeff() >= 0);
  CHECK((string.stiffness * end.displacement + string.A.transpose() * end.force - string.load)
            .norm() < 1e-10);
  const VectorXd gap = string.initial_gap - string.A * end.displacement;
  CHECK(equal_within(end.force, 50 * (-gap).cwiseMax(0), 1e-12));
  CHECK(std::abs(end.overlap + gap.minCoeff()) < 1e-15);
}

TEST_CASE("ex9.2 held out: a tenth of the overlap costs ten times the condition number",
          "[ex9.2]") {
  const DenseProgramme string = string_over(15, 5);
  const Penalised soft = penalty(string, 1e4), hard = penalty(string, 1e5);
  REQUIRE(soft.settled);
  REQUIRE(hard.settled);
  // Both laws hold up to terms of the size of K/k.
  CHECK(std::abs(hard.overlap / soft.overlap - 0.1) < 0.01);
  CHECK(std::abs(hard.condition / soft.condition - 10) < 0.1);
}

TEST_CASE("ex9.2 held out: the forces tend to those of contact", "[ex9.2]") {
  const DenseProgramme string = string_over(15, 5);
  const VectorXd exact =
      signorini::solve(string, signorini::find_solver("quasi_active_set")).refined.force;
  double last = 1e300;
  for (const double k : {1e2, 1e4, 1e6}) {
    const double error = (penalty(string, k).force - exact).norm();
    CAPTURE(k, error);
    CHECK(error < 0.05 * last);
    last = error;
  }
  CHECK(last < 1e-4);
}

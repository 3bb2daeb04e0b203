#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex9_2::Penalised;
using ex9_2::penalty;
using signorini::DenseProgramme;

namespace {

/// Four nodes in a row between springs of stiffness 1, the first one held by one; all pulled by 1, the
/// last one with an obstacle at 2: the exact force is 2, as node 4 would move by 10.
DenseProgramme chain() {
  DenseProgramme chain;
  chain.stiffness = 2 * MatrixXd::Identity(4, 4);
  chain.stiffness(3, 3) = 1;
  for (Eigen::Index i = 0; i < 3; ++i) chain.stiffness(i, i + 1) = chain.stiffness(i + 1, i) = -1;
  chain.load = VectorXd::Ones(4);
  chain.A = MatrixXd::Zero(1, 4);
  chain.A(0, 3) = 1;
  chain.initial_gap = VectorXd::Constant(1, 2);
  return chain;
}

DenseProgramme one_spring(double load) {
  return {MatrixXd::Ones(1, 1), VectorXd::Constant(1, load), MatrixXd::Ones(1, 1),
          VectorXd::Ones(1)};
}

}  // namespace

// (1 + k) u = 2 + k, so that u - 1 = 1/(1 + k).
TEST_CASE("ex9.2 one spring overlaps by 1/(1 + k)", "[ex9.2]") {
  for (const double k : {1.0, 10.0, 1000.0}) {
    const Penalised end = penalty(one_spring(2), k);
    CAPTURE(k);
    REQUIRE(end.settled);
    CHECK(std::abs(end.overlap - 1 / (1 + k)) < 1e-14);
    CHECK(std::abs(end.force(0) - k / (1 + k)) <
          1e-11);  // k times the overlap: loses log10 k digits
    CHECK(std::abs(end.condition - 1) < 1e-14);
  }
}

TEST_CASE("ex9.2 nothing pushes across an open gap, and nothing pulls", "[ex9.2]") {
  const Penalised end = penalty(one_spring(0.5), 100);
  REQUIRE(end.settled);
  CHECK(end.force(0) == 0);
  CHECK(end.overlap == 0);
  CHECK(std::abs(end.displacement(0) - 0.5) < 1e-15);
}

// Node 4 yields by 4 under a unit force: without obstacle it stands at 10, with it at (10 + 8 k)/(1 + 4 k).
TEST_CASE("ex9.2 a chain: overlap 8/(1 + 4 k), and a condition number that grows", "[ex9.2]") {
  double last = 0;
  for (const double k : {10.0, 1e3, 1e5}) {
    const Penalised end = penalty(chain(), k);
    CAPTURE(k);
    REQUIRE(end.settled);
    CHECK(std::abs(end.overlap - 8 / (1 + 4 * k)) < 1e-12);
    CHECK(end.condition > 10 * last);
    last = end.condition;
  }
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/random.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ex2_4::trade_groups;
using ex2_4::Traded;

namespace {

signorini::ContactProblem random_problem(signorini::Random& random, Index n) {
  MatrixXd B(n, n);
  VectorXd d(n);
  for (double& entry : B.reshaped()) entry = random.uniform(-1, 1);
  for (double& entry : d) entry = random.uniform(-1, 0.5);
  return {B * B.transpose() + 0.1 * MatrixXd::Identity(n, n), d};
}

}  // namespace

// Who splits a group can do what the whole group did, and more.
TEST_CASE("ex2.4 held out: from one group to all, the worth rises to that of the solution",
          "[ex2.4]") {
  signorini::Random random(24);
  for (int sample = 0; sample < 100; ++sample) {
    const Index n = random.whole(2, 8);
    const signorini::ContactProblem problem = random_problem(random, n);
    VectorXd weight(n);
    for (double& entry : weight) entry = random.uniform(0.1, 1);
    std::vector<Index> group(static_cast<std::size_t>(n), 0);
    CAPTURE(sample, n);
    Traded last = trade_groups(problem, weight, group);
    CHECK(last.energy ==
          Approx(signorini::surrogate_dual_value(problem, weight / weight.sum())).epsilon(1e-11));
    for (Index k = 1; k < n; ++k) {  // pair k leaves the first group
      group[static_cast<std::size_t>(k)] = k;
      const Traded now = trade_groups(problem, weight, group);
      CHECK(now.energy >= last.energy - 1e-12);
      CHECK(now.energy ==
            Approx(-now.force.dot(problem.free_gap + 0.5 * problem.compliance * now.force))
                .epsilon(1e-10)
                .margin(1e-13));
      last = now;
    }
    CHECK(equal_within(last.force, signorini::enumerate(problem).force, 1e-10));
  }
}

TEST_CASE("ex2.4 held out: a group presses or its weighted gap is open", "[ex2.4]") {
  signorini::Random random(25);
  for (int sample = 0; sample < 100; ++sample) {
    const signorini::ContactProblem problem = random_problem(random, 6);
    const VectorXd weight = VectorXd::LinSpaced(6, 0, 5);  // the first pair has none
    const Traded traded = trade_groups(problem, weight, {0, 1, 0, 1, 2, 2});
    const VectorXd gap = problem.free_gap + problem.compliance * traded.force;
    REQUIRE(traded.total.size() == 3);
    for (Index k = 0; k < 3; ++k) {
      const double weighted = k == 0   ? gap(2)
                              : k == 1 ? gap(1) + 3 * gap(3)
                                       : 4 * gap(4) + 5 * gap(5);
      CHECK(traded.total(k) >= 0);
      CHECK(weighted >= -1e-11);
      CHECK(std::abs(traded.total(k) * weighted) < 1e-11);
    }
  }
}

TEST_CASE("ex2.4 held out: shares as the forces of the solution lose nothing", "[ex2.4]") {
  signorini::Random random(26);
  for (int sample = 0; sample < 30; ++sample) {
    signorini::ContactProblem problem = random_problem(random, 6);
    problem.free_gap(0) = -2;
    const VectorXd force = signorini::enumerate(problem).force;
    const Traded traded = trade_groups(problem, force, std::vector<Index>(6, 0));
    CHECK(equal_within(traded.force, force, 1e-11));
    CHECK(traded.total(0) == Approx(force.sum()).epsilon(1e-11));
  }
}

TEST_CASE("ex2.4 held out: groups are counted from 0 without a hole", "[ex2.4]") {
  const signorini::ContactProblem two{Eigen::Matrix2d::Identity(), Eigen::Vector2d(-1, -1)};
  CHECK_THROWS_AS(trade_groups(two, Eigen::Vector2d(1, 1), {0, 2}), std::invalid_argument);
  CHECK_THROWS_AS(trade_groups(two, Eigen::Vector2d(1, 1), {0, -1}), std::invalid_argument);
}

// The condition eta >= 0 of the dual problem, which is one on the weights.
#include <algorithm>

#include "catch_compat.hpp"
#include "papers/surrogate_dual.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/solvers/enumerate.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Largest s of equation (24), with eta of either sign, among the weights that are stationary on a face
/// of the simplex.
struct Stationary {
  double pressing = 0;  ///< those with eta >= 0
  double pulling = 0;   ///< those with eta < 0
};

/// On a face the slope of s vanishes only where G lambda = b, lambda = eta xi: all of one sign.
Stationary stationary_values(const ContactProblem& problem) {
  Stationary found;
  const Index n = problem.free_gap.size();
  for (unsigned face = 1; face < (1U << static_cast<unsigned>(n)); ++face) {
    std::vector<Index> pairs;
    for (Index i = 0; i < n; ++i)
      if ((face >> static_cast<unsigned>(i) & 1U) != 0) pairs.push_back(i);
    const VectorXd b = -problem.free_gap(pairs);
    const VectorXd force = LuFactor(problem.compliance(pairs, pairs)).solve(b);
    const double s = 0.5 * b.dot(force);
    if (force.minCoeff() >= 0) found.pressing = std::max(found.pressing, s);
    if (force.maxCoeff() < 0) found.pulling = std::max(found.pulling, s);
  }
  return found;
}

}  // namespace

// s vanishes where the condition holds with equality, so that its maximum is stationary on a face.
TEST_CASE("the maximum over weights with eta >= 0 is that with the positive part, and the contact",
          "[surrogate_dual][closed-form][XuanLi2002-23][XuanLi2002-24]") {
  Random random(6);
  int pulling_wins = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const ContactProblem problem = random_problem(random, 5);
    const Stationary s = stationary_values(problem);
    const ContactState state = enumerate(problem);
    const double best =
        state.force.sum() > 0 ? surrogate_dual_value(problem, state.force / state.force.sum()) : 0;
    CHECK(s.pressing == Approx(best).epsilon(1e-10).margin(1e-14));
    CHECK(s.pressing ==
          Approx(-0.5 * state.force.dot(problem.free_gap)).epsilon(1e-10).margin(1e-14));
    for (Index i = 0; i < 5; ++i)  // the positive part makes no vertex better
      CHECK(surrogate_dual_value(problem, VectorXd::Unit(5, i)) <= s.pressing * (1 + 1e-12));
    pulling_wins += s.pulling > s.pressing * (1 + 1e-9) ? 1 : 0;
  }
  CHECK(pulling_wins > 0);  // without the condition the maximum is often another one
}

TEST_CASE("(27) asks every pair to overlap, not their mean",
          "[surrogate_dual][closed-form][XuanLi2002-26][XuanLi2002-27]") {
  const auto overlapping = [](double first, double second) {
    return all_overlap({Eigen::Matrix2d::Identity(), Eigen::Vector2d(-first, -second)});
  };
  CHECK(overlapping(2, 1));
  CHECK_FALSE(overlapping(2, -1));  // though the mean overlap is positive
  CHECK_FALSE(overlapping(2, 0));   // the sign of (27) is strict
  CHECK_FALSE(overlapping(-2, -1));
}

TEST_CASE("where all pairs overlap without contact, every eta is positive, and only there",
          "[surrogate_dual][XuanLi2002-26][XuanLi2002-27]") {
  Random random(7);
  for (int sample = 0; sample < 50; ++sample) {
    ContactProblem problem = random_problem(random, 5);
    problem.free_gap = -problem.free_gap.cwiseAbs();
    const Stationary s = stationary_values(problem);
    CHECK(s.pulling == 0);
    VectorXd weights(5);
    for (double& weight : weights) weight = random.uniform(0, 1);
    CHECK(all_overlap(problem));
    CHECK(total_contact_force(problem, weights) > 0);
    problem.free_gap(2) = 1;
    CHECK_FALSE(all_overlap(problem));
    CHECK(total_contact_force(problem, VectorXd::Unit(5, 2)) == 0);
  }
}

TEST_CASE("two pairs: without eta >= 0 the open one wins, with it the one that overlaps",
          "[surrogate_dual][closed-form][XuanLi2002-24]") {
  const ContactProblem problem{Eigen::Matrix2d::Identity(), Eigen::Vector2d(2, -1)};
  const Stationary s = stationary_values(problem);
  CHECK(s.pulling == 2);
  CHECK(s.pressing == 0.5);
}

TEST_CASE(
    "s is not concave, but where the weighted gap overlaps and s does not rise to first order, it does not rise",
    "[surrogate_dual]") {
  const ContactProblem apart{Eigen::Matrix2d::Identity(), Eigen::Vector2d(-1, 0)};
  const auto s = [&](double t) {
    return surrogate_dual_value(apart, Eigen::Vector2d(t, 1 - t));  // t^2 / (2 t^2 + 2 (1 - t)^2)
  };
  CHECK(s(0.1) < 0.5 * s(0.2));  // below the chord from t = 0, where s = 0
  // There the weighted gap does not overlap: the slope is zero, and s rises all the same.
  CHECK(surrogate_dual_gradient(apart, Eigen::Vector2d(0, 1)).norm() == 0);
  CHECK(s(1e-3) > 4e-7);
  Random random(8);
  int falls = 0;
  for (int sample = 0; sample < 400; ++sample) {
    const ContactProblem problem = random_problem(random, 4);
    VectorXd from(4), to(4);
    for (double& weight : from) weight = random.uniform(0, 1);
    for (double& weight : to) weight = random.uniform(0, 1);
    from /= from.sum();
    to /= to.sum();
    const double here = surrogate_dual_value(problem, from);
    if (here == 0 || surrogate_dual_gradient(problem, from).dot(to - from) > 0) continue;
    ++falls;
    for (int k = 1; k <= 50; ++k)
      CHECK(surrogate_dual_value(problem, from + k / 50.0 * (to - from)) <= here * (1 + 1e-12));
  }
  CHECK(falls > 50);
}

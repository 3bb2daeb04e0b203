#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using namespace ex8_5;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

Problem random_problem(signorini::Random& random, Index n) {
  Eigen::MatrixXd B(2 * n, 2 * n);
  for (double& b : B.reshaped()) b = random.uniform(-0.5, 0.5);
  Problem problem{B * B.transpose() + Eigen::MatrixXd::Identity(2 * n, 2 * n), VectorXd(n),
                  VectorXd(n), random.uniform(0.1, 0.4)};
  for (double& d : problem.free_gap) d = random.uniform(-2, 1);
  for (double& s : problem.free_slip) s = random.uniform(-1, 1);
  return problem;
}

// The worst violation of the laws of contact and friction.
double violation(const Problem& problem, const Answer& answer) {
  const Index n = problem.free_gap.size();
  VectorXd all(2 * n);
  all << answer.force, answer.friction;
  const VectorXd moved = problem.compliance * all;
  double worst = 0;
  for (Index i = 0; i < n; ++i) {
    const double gap = problem.free_gap(i) + moved(i), slip = problem.free_slip(i) + moved(n + i);
    const double bound = problem.mu * answer.force(i), tau = answer.friction(i);
    worst = std::max({worst, -gap, -answer.force(i), std::abs(gap * answer.force(i)),
                      std::abs(tau) - bound, slip * tau});
    if (answer.force(i) > 1e-9) worst = std::max(worst, std::abs(slip) * (bound - std::abs(tau)));
  }
  return worst;
}

}  // namespace

TEST_CASE("ex8.5 held out: the laws hold in random problems, and nearly all are solved",
          "[ex8.5]") {
  signorini::Random random(1);
  int solved = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const Problem problem = random_problem(random, 1 + sample % 5);
    const Answer answer = semismooth(problem, 1);
    CAPTURE(sample);
    if (!answer.solved) continue;
    ++solved;
    CHECK(violation(problem, answer) < 1e-12);
    CHECK(answer.steps <= 15);
  }
  CHECK(solved >= 285);
}

TEST_CASE("ex8.5 held out: a mirror, and other units", "[ex8.5]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 50; ++sample) {
    const Index n = 1 + sample % 4;
    const Problem problem = random_problem(random, n);
    const Answer answer = semismooth(problem, 1);
    if (!answer.solved) continue;
    Problem mirror = problem;  // the other way along the tangent
    mirror.free_slip *= -1;
    mirror.compliance.topRightCorner(n, n) *= -1;
    mirror.compliance.bottomLeftCorner(n, n) *= -1;
    const Answer image = semismooth(mirror, 1);
    REQUIRE(image.solved);
    CHECK(image.steps == answer.steps);
    CHECK(equal_within(image.force, answer.force, 1e-12));
    CHECK((image.friction + answer.friction).norm() < 1e-12);
    Problem metres = problem;  // lengths a thousandth, so c a thousand times as large
    metres.compliance /= 1024;
    metres.free_gap /= 1024;
    metres.free_slip /= 1024;
    const Answer same = semismooth(metres, 1024);
    CHECK(same.steps == answer.steps);
    CHECK(equal_within(same.force, answer.force, 1e-12));
  }
}

TEST_CASE("ex8.5 held out: equations that are singular are no solution", "[ex8.5]") {
  const Problem twice{Eigen::MatrixXd::Ones(4, 4), Eigen::Vector2d(-1, -2), Eigen::Vector2d(0, 0),
                      0.3};
  CHECK_FALSE(semismooth(twice, 1).solved);
}

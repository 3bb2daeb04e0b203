// How much of a load friction can balance, by hand: blocks, slopes and wedges, and random problems from both sides.
#include <cmath>

#include "addons/certified/proofs.hpp"
#include "catch_compat.hpp"
#include "support/message.hpp"
#include "support/random.hpp"

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// A point that rests on a rough plane with the normal n and is free to move both ways.
ContactProblem resting(const Vector2d& n, double mu, double c, const Vector2d& load) {
  ContactProblem problem{Matrix2d::Identity(), VectorXd::Zero(1), VectorXd::Zero(1),
                         law_of_all(VectorXd::Constant(1, mu), VectorXd::Constant(1, c))};
  problem.rigid = Matrix2d::Zero();
  problem.rigid << n.x(), n.y(), n.y(), -n.x();
  problem.resultant = -load;
  return problem;
}

}  // namespace

TEST_CASE("a block on an incline: the weight that cohesion holds, and none without",
          "[active_set][friction][closed-form]") {
  for (const double mu : {0.0, 0.2, 0.5})
    for (const double angle : {0.6, 1.0, 1.5}) {
      const double c = 3;
      CAPTURE(mu, angle);
      const double most = c / (std::sin(angle) - mu * std::cos(angle));
      const Vector2d n(0, 1);
      for (const double weight : {1.001 * most, 2 * most, 1e6 * most}) {
        const Vector2d load = weight * Vector2d(std::sin(angle), -std::cos(angle));
        const double share = balanced_share(resting(n, mu, c, load), Vector2d::Zero());
        CHECK(share * weight == Approx(most).epsilon(1e-13).margin(0));
        CHECK(balanced_share(resting(n, mu, 0, load), Vector2d::Zero()) == 0);
      }
      const Vector2d held = 0.999 * most * Vector2d(std::sin(angle), -std::cos(angle));
      CHECK(balanced_share(resting(n, mu, c, held), Vector2d::Zero()) == 1);
    }
}

TEST_CASE("a block pushed up a slope holds until F = G (tan a + mu) / (1 - mu tan a)",
          "[active_set][friction][closed-form]") {
  const double slope = 0.1;
  const Vector2d n = Vector2d(-slope, 1).normalized();
  for (const double mu : {0.1001, 0.2, 0.3, 5.0}) {
    CAPTURE(mu);
    const double weight = 7;
    const double most = weight * (slope + mu) / (1 - mu * slope);
    const double share =
        balanced_share(resting(n, mu, 0, {2 * most, -weight}), Vector2d(0, weight));
    CHECK(2 * share == Approx(1).epsilon(1e-13).margin(0));
  }
  // On a slope that is steeper than friction the weight alone slides.
  CHECK(balanced_share(resting(n, 0.09, 0, {-1, -7}), Vector2d(0, 7)) == 0);
}

TEST_CASE("a block on two feet slides or tips, whichever comes first",
          "[active_set][friction][closed-form]") {
  // Feet at x = -1 and 1, pushed along at the height h: tips at W / h, slides at mu W.
  const double weight = 4;
  for (const double mu : {0.1, 0.3, 0.7})
    for (const double height : {0.5, 2.0, 6.0}) {
      ContactProblem problem{MatrixXd::Identity(4, 4), Vector2d::Zero(), Vector2d::Zero(),
                             law_of_all(Vector2d::Constant(mu), Vector2d::Zero())};
      problem.rigid = MatrixXd::Zero(4, 3);  // x, y, and the turn about the middle of the feet
      problem.rigid << 0, 1, -1, 0, 1, 1, 1, 0, 0, 1, 0, 0;
      const double push = 100;
      problem.resultant = -Vector3d(push, -weight, -height * push);
      CAPTURE(mu, height);
      const double most = weight * std::min(mu, 1 / height);
      CHECK(push * balanced_share(problem, Vector3d(0, weight, 0)) ==
            Approx(most).epsilon(1e-12).margin(0));
    }
}

TEST_CASE("what is balanced at most: a proof beyond it and none below", "[active_set][friction]") {
  Random random(31);
  int limited = 0;
  for (int sample = 0; sample < 300; ++sample) {
    const Index n = 2 + sample % 6;
    ContactProblem problem{MatrixXd::Identity(2 * n, 2 * n), VectorXd::Zero(n), VectorXd::Zero(n),
                           law_of_all(VectorXd::Zero(n), VectorXd::Zero(n))};
    problem.rigid = MatrixXd::Zero(2 * n, 3);
    VectorXd held(2 * n);
    for (Index i = 0; i < n; ++i) {
      problem.law.coefficient(i) = random.uniform(0, 1);
      problem.law.cohesion(i) = sample % 2 == 0 ? 0 : random.uniform(0, 1);
      for (Index j = 0; j < 3; ++j) {
        problem.rigid(i, j) = random.uniform(-1, 1);
        problem.rigid(n + i, j) = random.uniform(-1, 1);
      }
      held(i) = random.uniform(0.1, 1);
      held(n + i) = random.uniform(-0.9, 0.9) * problem.law.coefficient(i) * held(i);
    }
    const Vector3d before = problem.rigid.transpose() * held;
    const Vector3d more(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    problem.resultant = before + more;
    const double share = balanced_share(problem, before);
    CAPTURE(sample, share);
    if (share == 1) continue;
    ++limited;
    CHECK(share > 0);
    problem.resultant = before + share * (1 + 1e-9) * more;
    CHECK(unbounded_direction(equilibrate(problem)).size() == 3);
    problem.resultant = before + share * (1 - 1e-9) * more;
    CHECK(unbounded_direction(equilibrate(problem)).size() == 0);
  }
  CHECK(limited > 60);
}

TEST_CASE("resultants of different sizes are refused", "[active_set][input]") {
  CHECK_THAT(argument_message([] {
               static_cast<void>(balanced_share(resting({0, 1}, 1, 0, {0, -1}), Vector3d::Zero()));
             }),
             ContainsSubstring("2 resultants") && ContainsSubstring("3"));
}

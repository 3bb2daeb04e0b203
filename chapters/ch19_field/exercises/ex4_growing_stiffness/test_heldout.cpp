#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using signorini::ContactProblem;

TEST_CASE("ex19.4 held out: the stiffness of every pass, by hand", "[ex19.4]") {
  const ContactProblem one{MatrixXd::Constant(1, 1, 1), VectorXd::Constant(1, -1)};
  double left = 1, stiffness = 0.5;
  for (Index passes = 1; passes <= 6; ++passes) {
    const double factor = 1 / (1 + stiffness);
    left *= factor;
    if (factor > 0.1) stiffness *= 10;
    CAPTURE(passes);
    const ex19_4::Ending end = ex19_4::augmented_lagrangian(one, 0.5, 1e-15, passes);
    CHECK(1 - end.force(0) == Approx(left).epsilon(1e-6).margin(1e-14));
  }
}

TEST_CASE("ex19.4 held out: random problems from any stiffness", "[ex19.4]") {
  signorini::Random random(7);
  for (int sample = 0; sample < 20; ++sample) {
    MatrixXd root(5, 5);
    for (Index i = 0; i < 25; ++i) root(i) = random.uniform(-1, 1);
    VectorXd d(5);
    for (Index i = 0; i < 5; ++i) d(i) = random.uniform(-1, 0.3);
    const ContactProblem problem{root * root.transpose() + 0.1 * MatrixXd::Identity(5, 5), d};
    const VectorXd right = signorini::enumerate(problem).force;
    for (const double stiffness : {1e-4, 1.0, 1e4}) {
      CAPTURE(sample, stiffness);
      const ex19_4::Ending end = ex19_4::augmented_lagrangian(problem, stiffness, 1e-11, 60);
      CHECK(end.ended);
      CHECK(equal_within(end.force, right, 1e-7 * (1 + right.norm())));
    }
  }
}

TEST_CASE("ex19.4 held out: nothing overlaps, and passes that run out", "[ex19.4]") {
  const ContactProblem open{MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 0)};
  CHECK(ex19_4::augmented_lagrangian(open, 1, 1e-12, 9).passes == 1);
  CHECK(ex19_4::augmented_lagrangian(open, 1, 1e-12, 9).ended);
  const ContactProblem one{MatrixXd::Constant(1, 1, 1), VectorXd::Constant(1, -1)};
  const ex19_4::Ending few = ex19_4::augmented_lagrangian(one, 1e-6, 1e-12, 3);
  CHECK(!few.ended);
  CHECK(few.passes == 3);
}

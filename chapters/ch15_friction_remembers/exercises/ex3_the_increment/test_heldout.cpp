#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"
#include "support/random.hpp"

using namespace ex15_3;
using Eigen::VectorXd;

namespace {

Sliders random_sliders(signorini_test::Random& random, Eigen::Index n) {
  Sliders sliders{VectorXd(n), VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    sliders.stiffness(i) = random.uniform(0.1, 10);
    sliders.bound(i) = random.uniform(0, 5);
  }
  return sliders;
}

}  // namespace

TEST_CASE("ex15.3 held out: without a turn, one step is as good as many", "[ex15.3]") {
  signorini_test::Random random(15);
  for (int trial = 0; trial < 50; ++trial) {
    const Sliders sliders = random_sliders(random, 8);
    State one{VectorXd::Zero(8)}, many = one;
    double from = 0;
    for (int leg = 0; leg < 6; ++leg) {
      const double to = random.uniform(-3, 3);
      const double pull = step(sliders, to, one);
      double last = 0;
      for (int k = 1; k <= 10; ++k) last = step(sliders, from + 0.1 * k * (to - from), many);
      CHECK(pull == Approx(last).margin(1e-12));
      CHECK(equal_within(one.place, many.place, 1e-12));
      CHECK(one.lost == Approx(many.lost).margin(1e-11));
      from = to;
    }
  }
}

// Work of the hand = stored + lost: each pull over a step without a turn is bent at most once per slider, so the
// area is summed with many small steps.
TEST_CASE("ex15.3 held out: a closed loop loses its area", "[ex15.3]") {
  signorini_test::Random random(16);
  const Sliders sliders = random_sliders(random, 5);
  State state{VectorXd::Zero(5)};
  double last = step(sliders, 2, state);
  const double before = state.lost;
  double area = 0;
  const int n = 20000;
  for (const int way : {-1, 1})
    for (int k = 1; k <= n; ++k) {
      const double pull = step(sliders, -2 * way + 4.0 * way * k / n, state);
      area += 0.5 * (pull + last) * 4.0 * way / n;
      last = pull;
    }
  CHECK(state.lost - before == Approx(area).epsilon(1e-6));
  CHECK(area > 0);
}

TEST_CASE("ex15.3 held out: a small loop inside is forgotten when it closes", "[ex15.3]") {
  signorini_test::Random random(17);
  const Sliders sliders = random_sliders(random, 20);
  State state{VectorXd::Zero(20)};
  (void)step(sliders, 3, state);
  const double pull = step(sliders, 1, state);
  const VectorXd place = state.place;
  (void)step(sliders, 1.7, state);
  CHECK(step(sliders, 1, state) == Approx(pull).margin(1e-12));
  CHECK(equal_within(state.place, place, 1e-13));
}

TEST_CASE("ex15.3 held out: what sticks keeps its place to the last bit, no friction bears nothing",
          "[ex15.3]") {
  const Sliders sliders{Eigen::Vector2d(3, 7), Eigen::Vector2d(1, 0)};
  State state{Eigen::Vector2d(0.1, 0.1)};
  CHECK(step(sliders, 0.3, state) == Approx(0.6).epsilon(1e-14));
  CHECK(state.place(0) == 0.1);
  CHECK(state.place(1) == Approx(0.3).epsilon(1e-14));
  CHECK(state.lost == 0);
}

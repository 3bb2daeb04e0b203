#include <cmath>

#include "../chapters/ch15_friction_remembers/slider.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex15_3;
using Eigen::VectorXd;

static VectorXd one(double value) { return VectorXd::Constant(1, value); }

TEST_CASE("ex15.3 a load that only grows", "[ex15.3]") {
  const Sliders sliders{one(20), one(5)};
  State state{one(0)};
  CHECK(step(sliders, 0.1, state) == Approx(2).epsilon(1e-14));
  CHECK(step(sliders, 1, state) == Approx(5).epsilon(1e-14));
  CHECK(state.place(0) == Approx(0.75).epsilon(1e-14));
  CHECK(state.lost == Approx(5 * 0.75).epsilon(1e-13));
}

TEST_CASE("ex15.3 the loop of one slider, 4 B (U - B / k)", "[ex15.3]") {
  const Sliders sliders{one(20), one(5)};
  State state{one(0)};
  (void)step(sliders, 1, state);
  const double before = state.lost;
  CHECK(step(sliders, 0.75, state) == Approx(0).margin(1e-13));
  CHECK(step(sliders, 0, state) == Approx(-5).epsilon(1e-14));
  CHECK(step(sliders, -1, state) == Approx(-5).epsilon(1e-14));
  CHECK(step(sliders, 1, state) == Approx(5).epsilon(1e-14));
  CHECK(state.lost - before == Approx(15).epsilon(1e-13));
}

TEST_CASE("ex15.3 step by step as the library", "[ex15.3]") {
  const Sliders sliders{one(ch15::k), one(ch15::B)};
  State state{one(0)};
  using namespace signorini;
  ch15::remember(ch15::triangle(equal_steps(23, 5)), [&](const Model&, const Step& now) {
    const double pull = step(sliders, ch15::to_and_fro().at(now.state.time), state);
    CAPTURE(now.state.time);
    CHECK(-now.solution.contact.friction(0) == Approx(pull).margin(1e-12));
    CHECK(now.state.slip(0) == Approx(state.place(0)).margin(1e-13));
    CHECK(now.state.dissipation(0) == Approx(state.lost).margin(1e-12));
  });
}

TEST_CASE("ex15.3 Masing's rule: the way back is the first way, twice as large", "[ex15.3]") {
  const Sliders sliders{Eigen::Vector3d(1, 2, 5), Eigen::Vector3d(3, 1, 0.5)};
  const double far = 2.5;
  State first{VectorXd::Zero(3)}, back{VectorXd::Zero(3)};
  const double top = step(sliders, far, back);
  for (int i = 1; i <= 20; ++i) {
    const double way = 0.1 * i * far / 2;
    CAPTURE(way);
    const double up = step(sliders, way, first);
    const double down = step(sliders, far - 2 * way, back);
    if (way <= far) CHECK(top - down == Approx(2 * up).epsilon(1e-13));
  }
}

#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/shrink_fit.hpp"

using ex18_2::Change;
using ex18_2::changes;
using ex18_2::Fit;
using ex18_2::worth_switching_on;
using Names = std::vector<std::string>;

namespace {

// Steel, mm, N, t, s: 6.3 MPa between shaft and hub by the interference alone. A warm shaft, 60 turns per second,
// 1 bar outside, mu 0.15.
Fit steel() {
  Fit fit{10, 20, 40, 210e3, 0.3, 0.002};
  fit.density = 7.85e-9;
  fit.speed = 2 * std::acos(-1.0) * 60;
  fit.pressure = 0.1;
  fit.shaft_expansion = fit.hub_expansion = 1.2e-5;
  fit.shaft_warmer = 3;
  fit.hub_warmer = 1;
  fit.friction = 0.15;
  return fit;
}

double share_of(const Fit& fit, const std::string& effect) {
  for (const Change& change : changes(fit))
    if (change.effect == effect) return change.share;
  FAIL("there is no " << effect);
  return 0;
}

double pressure(const Fit& fit, const Names& on) {
  return signorini_test::mean_pressure(
      signorini::solved(signorini_test::fit_with(fit, on), "the fit"));
}

}  // namespace

TEST_CASE("ex18.2 heat counts against the interference", "[ex18.2]") {
  CHECK(share_of(steel(), "temperature") == Approx(0.24).epsilon(1e-12));
  Fit same = steel();
  same.shaft_warmer = same.hub_warmer;  // both grow alike
  CHECK(share_of(same, "temperature") == Approx(0).margin(1e-15));
}

TEST_CASE("ex18.2 the largest comes first", "[ex18.2]") {
  const std::vector<Change> all = changes(steel());
  REQUIRE(all.size() == 4);
  CHECK(all[0].effect == "temperature");
  CHECK(all[1].effect == "body force");
  CHECK(all[2].effect == "edge loads");
  CHECK(all[3].effect == "friction");
  CHECK(all[1].share == Approx(-0.0657442).epsilon(1e-5));
  CHECK(all[2].share == Approx(0.0126984).epsilon(1e-5));
  CHECK(all[3].share == 0);
}

// Each alone, solved: 1e-3 is what the mesh may be wrong by.
TEST_CASE("ex18.2 switched on alone, each effect does what was said", "[ex18.2]") {
  const Fit fit = steel();
  const double p0 = pressure(fit, {});
  for (const char* effect : {"body force", "edge loads", "temperature", "friction"}) {
    CAPTURE(effect);
    CHECK(pressure(fit, {effect}) / p0 - 1 ==
          Approx(share_of(fit, effect)).epsilon(1e-3).margin(1e-5));
  }
}

TEST_CASE("ex18.2 what is left out adds up to no more than the accuracy", "[ex18.2]") {
  CHECK(worth_switching_on(steel(), 0.5) == decltype(worth_switching_on(steel(), 0.5)){});
  CHECK(worth_switching_on(steel(), 0.3) == Names{"temperature"});
  CHECK(worth_switching_on(steel(), 0.1) == Names{"temperature"});
  CHECK(worth_switching_on(steel(), 0.07) == Names{"temperature", "body force"});  // 0.066 + 0.013
  CHECK(worth_switching_on(steel(), 0.001) == Names{"temperature", "body force", "edge loads"});
}

TEST_CASE("ex18.2 the largest comes first, also if it takes from the pressure", "[ex18.2]") {
  Fit fast = steel();
  fast.speed *= 3;
  CHECK(changes(fast)[0].effect == "body force");
  CHECK(changes(fast)[0].share < 0);
}

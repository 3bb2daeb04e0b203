#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/rings.hpp"
#include "exercise.hpp"
#include "support/random.hpp"
#include "support/shrink_fit.hpp"

using ex18_2::Change;
using ex18_2::changes;
using ex18_2::Fit;
using ex18_2::worth_switching_on;
using Names = std::vector<std::string>;

namespace {

double pressure(const Fit& fit, const Names& on) {
  return signorini_test::mean_pressure(
      signorini::solved(signorini_test::fit_with(fit, on), "the fit"));
}

double share_of(const Fit& fit, const std::string& effect) {
  for (const Change& change : changes(fit))
    if (change.effect == effect) return change.share;
  FAIL("there is no " << effect);
  return 0;
}

const Names all_effects = {"body force", "edge loads", "temperature", "friction"};

/// Shares to 0.3 either way, on radii and materials of any kind.
Fit random_fit(std::uint64_t seed) {
  signorini_test::Random random(seed);
  const double b = random.uniform(0.5, 50), E = random.uniform(1e3, 3e5);
  Fit fit{b * random.uniform(0.4, 0.8), b,
          b * random.uniform(1.3, 2.5), E,
          random.uniform(0, 0.45),      b * random.uniform(1e-4, 1e-3)};
  const double strain = fit.interference / b;
  const double square = fit.outside * fit.outside - fit.bore * fit.bore;
  fit.density = 1e-9;
  fit.speed = std::sqrt(random.uniform(0, 0.3) * E * strain / (fit.density * square));
  fit.pressure = random.uniform(-0.1, 0.1) * E * strain;
  fit.shaft_expansion = 1e-5;
  fit.hub_expansion = 2e-5;
  fit.shaft_warmer = random.uniform(-0.15, 0.15) * strain / fit.shaft_expansion;
  fit.hub_warmer = random.uniform(-0.15, 0.15) * strain / fit.hub_expansion;
  fit.friction = random.uniform(0.1, 1);
  return fit;
}

}  // namespace

// 2e-3 of p0 is what the mesh may be wrong by.
TEST_CASE("ex18.2 held out: what is left out matters less than asked, what is in matters more",
          "[ex18.2]") {
  const double mesh = 2e-3;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Fit fit = random_fit(seed);
    const double accuracy = signorini_test::Random(seed + 100).uniform(0.02, 0.2);
    const Names on = worth_switching_on(fit, accuracy);
    CAPTURE(seed, accuracy, on.size());
    const double p0 = pressure(fit, {});
    CHECK(std::abs(pressure(fit, on) - pressure(fit, all_effects)) <= (accuracy + mesh) * p0);
    double left = 0, smallest = 2;
    for (const std::string& effect : all_effects) {
      const double change = pressure(fit, {effect}) / p0 - 1;
      CAPTURE(effect);
      CHECK(share_of(fit, effect) == Approx(change).epsilon(0).margin(mesh));
      if (std::find(on.begin(), on.end(), effect) == on.end())
        left += std::abs(change);
      else
        smallest = std::min(smallest, std::abs(change));
    }
    CHECK(left <= accuracy + mesh);
    if (!on.empty()) CHECK(left + smallest > accuracy - mesh);
  }
}

TEST_CASE("ex18.2 held out: p0 and the pressure outside, against the library", "[ex18.2]") {
  const Fit fit = random_fit(7);
  // Two rings of the radius b, and what the interference does to them: b times the strain.
  const auto moved = [&](double p) {
    using signorini::Ring;
    const double b = fit.radius;
    return ring_displacement(Ring{b, fit.outside, fit.modulus, fit.ratio}, {p, fit.pressure}, b) -
           ring_displacement(Ring{fit.bore, b, fit.modulus, fit.ratio}, {0, p}, b);
  };
  const double slope = moved(1) - moved(0);
  const double p0 = fit.interference / slope;
  const double p = (fit.interference - moved(0)) / slope;
  CHECK(share_of(fit, "edge loads") == Approx(p / p0 - 1).epsilon(1e-10).margin(1e-12));
}

TEST_CASE("ex18.2 held out: a fit that spins loose has nothing left", "[ex18.2]") {
  Fit fit = random_fit(3);
  fit.speed *= std::sqrt(1.5 / -share_of(fit, "body force"));
  CHECK(share_of(fit, "body force") == -1);
  CHECK(changes(fit).front().effect == "body force");
  CHECK(pressure(fit, {"body force"}) == 0);
  Fit slower = fit;
  slower.speed *= std::sqrt(0.98 / 1.5);
  CHECK(share_of(slower, "body force") == Approx(-0.98).epsilon(1e-12));
}

TEST_CASE("ex18.2 held out: many small ones may not be left out together", "[ex18.2]") {
  Fit fit = random_fit(4);
  const double strain = fit.interference / fit.radius;
  fit.speed *= std::sqrt(0.008 / -share_of(fit, "body force"));
  fit.pressure *= 0.007 / share_of(fit, "edge loads");
  fit.hub_warmer = 0;
  fit.shaft_warmer = 0.006 * strain / fit.shaft_expansion;
  CHECK(worth_switching_on(fit, 0.022) == decltype(worth_switching_on(fit, 0.022)){});
  CHECK(worth_switching_on(fit, 0.02) == Names{"body force"});
  CHECK(worth_switching_on(fit, 0.01) == Names{"body force", "edge loads"});
  CHECK(worth_switching_on(fit, 0.005) == Names{"body force", "edge loads", "temperature"});
}

TEST_CASE("ex18.2 held out: equal ones in the order of the plan, absent ones never", "[ex18.2]") {
  Fit fit = random_fit(5);
  fit.speed = fit.pressure = fit.shaft_warmer = fit.hub_warmer = 0;
  const std::vector<Change> all = changes(fit);
  REQUIRE(all.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) CHECK(all[k].effect == all_effects[k]);
  CHECK(worth_switching_on(fit, 1e-300) == decltype(worth_switching_on(fit, 1e-300)){});
}

TEST_CASE("ex18.2 held out: what is no fit is refused", "[ex18.2]") {
  const Fit fit = random_fit(6);
  const auto broken = [&fit](double Fit::*number, double value) {
    Fit other = fit;
    other.*number = value;
    return other;
  };
  CHECK_THROWS_AS(changes(broken(&Fit::bore, 0)), std::invalid_argument);
  CHECK_THROWS_AS(changes(broken(&Fit::bore, fit.radius)), std::invalid_argument);
  CHECK_THROWS_AS(changes(broken(&Fit::outside, fit.radius)), std::invalid_argument);
  CHECK_THROWS_AS(changes(broken(&Fit::modulus, 0)), std::invalid_argument);
  CHECK_THROWS_AS(changes(broken(&Fit::interference, -1)), std::invalid_argument);
  CHECK_THROWS_AS(worth_switching_on(broken(&Fit::bore, 0), 0.1), std::invalid_argument);
  CHECK_THROWS_AS(worth_switching_on(fit, 0), std::invalid_argument);
}

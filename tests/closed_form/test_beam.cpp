#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/beam.hpp"
#include "reference/cantilever.hpp"

using namespace signorini;

namespace {

/// The beam of the paper under the pressure q.
BeamOnFoundation beam(double q) { return {50, 5, 1, 2.1e4, 0.29, 1, q}; }

}  // namespace

// All reference numbers carry six digits.
TEST_CASE("both beam theories give the reference touch-down and force", "[beam][closed-form]") {
  CHECK(euler_bernoulli(beam(3.6)).touchdown ==
        Approx(reference::euler_touchdown).epsilon(2e-6).margin(0));
  CHECK(euler_bernoulli(beam(3.6)).total_force ==
        Approx(reference::euler_force).epsilon(2e-6).margin(0));
  CHECK(timoshenko(beam(3.6)).touchdown ==
        Approx(reference::timoshenko_touchdown).epsilon(2e-6).margin(0));
  CHECK(timoshenko(beam(3.6)).total_force ==
        Approx(reference::timoshenko_force).epsilon(2e-6).margin(0));
}

TEST_CASE("contact of the tip alone has the reference force", "[beam][closed-form]") {
  CHECK(euler_bernoulli(beam(1)).total_force ==
        Approx(reference::euler_tip_force).epsilon(1e-12).margin(0));
  // q l^4 / 8 EI + q l^2 / 2 GA - F (l^3 / 3 EI + l / GA) = g; the reference has five digits of it.
  const double l = 50, EI = 2.1e4 * 125 / 12, GA = 5.0 / 6 * 2.1e4 / (2 * 1.29) * 5;
  const double force =
      (std::pow(l, 4) / (8 * EI) + l * l / (2 * GA) - 1) / (std::pow(l, 3) / (3 * EI) + l / GA);
  CHECK(timoshenko(beam(1)).total_force == Approx(force).epsilon(1e-12).margin(0));
  CHECK(std::abs(force - reference::timoshenko_tip_force) < 0.0005);
  CHECK(euler_bernoulli(beam(1)).touchdown == 50);
  CHECK(timoshenko(beam(1)).touchdown == 50);
}

TEST_CASE("contact begins and spreads at the closed-form loads", "[beam][closed-form]") {
  CHECK(tip_contact_pressure(beam(1)) == Approx(0.28).epsilon(1e-14).margin(0));
  CHECK(line_contact_pressure(beam(1)) == Approx(2.52).epsilon(1e-14).margin(0));
  CHECK(euler_bernoulli(beam(0.27999)).total_force == 0);
  CHECK(euler_bernoulli(beam(0.28001)).total_force > 0);
  CHECK(euler_bernoulli(beam(2.51999)).touchdown == 50);
  CHECK(euler_bernoulli(beam(2.52001)).touchdown < 50);
  CHECK(timoshenko(beam(0)).total_force == 0);
}

TEST_CASE("the total force is continuous in the load", "[beam]") {
  const double step = 1e-9;
  for (const double q : {0.28, 2.52}) {
    CAPTURE(q);
    const double below = euler_bernoulli(beam(q - step)).total_force;
    const double above = euler_bernoulli(beam(q + step)).total_force;
    CHECK(above - below == Approx(0).margin(50 * 2 * step));  // no faster than the load itself
  }
  // The thresholds of the Timoshenko beam are found by looking: no step anywhere.
  double before = timoshenko(beam(0.2)).total_force;
  for (double q = 0.201; q < 4; q += 0.001) {
    const double now = timoshenko(beam(q)).total_force;
    if (!(now >= before && now - before < 0.06)) FAIL("a jump at q = " << q);
    before = now;
  }
}

TEST_CASE("the pressure of the Timoshenko beam and its tip force sum to the total",
          "[beam][closed-form]") {
  const BeamContact contact = timoshenko(beam(3.6));
  const int n = 2000;  // Simpson's rule, error about 1e-10
  const double h = (50 - contact.touchdown) / n;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double x = k == 0 ? std::nextafter(contact.touchdown, 50) : contact.touchdown + k * h;
    sum += (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2) * timoshenko_pressure(beam(3.6), x) * h / 3;
  }
  CHECK(sum + reference::timoshenko_point_force ==
        Approx(contact.total_force).epsilon(2e-6).margin(0));
  CHECK(timoshenko_pressure(beam(3.6), 40) == 0);
  CHECK(timoshenko_pressure(beam(3.6), 50) == Approx(3.6).epsilon(1e-12).margin(0));
}

TEST_CASE("a slender Timoshenko beam becomes an Euler-Bernoulli beam", "[beam]") {
  // Same g E I / (q l^4) at a smaller and smaller height: the difference is of order (h / l)^2.
  double difference = 1;
  for (const double slim : {1.0, 7.0, 49.0}) {
    BeamOnFoundation thin = beam(3.6);
    thin.height /= slim;
    thin.youngs_modulus *= slim * slim * slim;
    const double now =
        std::abs(timoshenko(thin).total_force / euler_bernoulli(thin).total_force - 1);
    CHECK(now < difference / 40);  // 49 in the limit
    CHECK(now < 4 * std::pow(thin.height / thin.length, 2));
    difference = now;
  }
}

TEST_CASE("a very slender beam still has an answer", "[beam]") {
  BeamOnFoundation wire = beam(3.6);  // l / h = 10000: the zone of shear is 1e-4 of the length
  wire.height /= 1000;
  wire.youngs_modulus *= 1e9;
  // touch-down moves by about that zone, the force by its square
  const double slim = wire.height / wire.length;
  CHECK(timoshenko(wire).touchdown ==
        Approx(euler_bernoulli(wire).touchdown).epsilon(slim).margin(0));
  CHECK(timoshenko(wire).total_force ==
        Approx(euler_bernoulli(wire).total_force).epsilon(4 * slim * slim).margin(0));
}

TEST_CASE("units and width change the answer as they must", "[beam][units]") {
  // cm and kN to m and N; twice the width bears twice the force.
  const BeamOnFoundation si{0.5, 0.05, 0.01, 2.1e8 * 1e3, 0.29, 0.01, 3.6e4 * 1e3};
  CHECK(timoshenko(si).touchdown == Approx(timoshenko(beam(3.6)).touchdown / 100).epsilon(1e-12));
  CHECK(timoshenko(si).total_force ==
        Approx(timoshenko(beam(3.6)).total_force * 1000).epsilon(1e-12));
  BeamOnFoundation wide = beam(3.6);
  wide.width = 2;
  CHECK(euler_bernoulli(wide).total_force ==
        Approx(2 * euler_bernoulli(beam(3.6)).total_force).epsilon(1e-13));
  CHECK(timoshenko_pressure(wide, 47) == Approx(timoshenko_pressure(beam(3.6), 47)).epsilon(1e-10));
}

TEST_CASE("a beam that cannot be is refused", "[beam]") {
  BeamOnFoundation bad = beam(3.6);
  bad.gap = 0;
  CHECK_THROWS_AS(euler_bernoulli(bad), std::invalid_argument);
  bad = beam(-1);
  CHECK_THROWS_AS(timoshenko(bad), std::invalid_argument);
}

#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/beam.hpp"
#include "exercise.hpp"

using ex6_1::Cantilever;
using ex6_1::FoundationContact;
using ex6_1::touch_foundation;

// Newton and metre, a beam 0.2 m wide: the library's beam has the load as a pressure.
static Cantilever slice(const signorini::BeamOnFoundation& beam) {
  const double EI = beam.youngs_modulus * beam.width * std::pow(beam.height, 3) / 12;
  return {beam.length, EI, beam.gap, beam.pressure * beam.width};
}

TEST_CASE("ex6.1 held out: other units, against the library", "[ex6.1]") {
  const double factor = GENERATE(0.5, 0.999, 1.001, 3.0, 8.99, 9.01, 40.0, 1e4);
  signorini::BeamOnFoundation beam{2.5, 0.1, 0.2, 7e10, 0.33, 0.004, 0};
  beam.pressure = factor * signorini::tip_contact_pressure(beam);
  const FoundationContact contact = touch_foundation(slice(beam));
  const signorini::BeamContact expected = signorini::euler_bernoulli(beam);
  CAPTURE(factor);
  CHECK(contact.touchdown == Approx(expected.touchdown).epsilon(1e-12));
  CHECK(contact.total_force == Approx(expected.total_force).epsilon(1e-12));
}

// Seen from the clamp, the beam up to s is a cantilever with the load w and a force R at its end.
TEST_CASE("ex6.1 held out: at the touchdown the beam is where it must be", "[ex6.1]") {
  const double w = GENERATE(0.001, 0.0124, 0.0126, 0.05, 0.1124, 0.1126, 0.3, 20.0);
  const Cantilever beam{4, 20, 0.02, w};  // tip contact from 0.0125, line contact from 0.1125
  const FoundationContact contact = touch_foundation(beam);
  const double s = contact.touchdown;
  const double EI = beam.bending_stiffness;
  const double deflection =
      w * std::pow(s, 4) / (8 * EI) - contact.point_force * std::pow(s, 3) / (3 * EI);
  const double slope = w * s * s * s / (6 * EI) - contact.point_force * s * s / (2 * EI);
  CAPTURE(w);
  if (w < 0.0125) {
    CHECK(deflection < beam.gap);
    CHECK(contact.total_force == 0);
  } else {
    CHECK(deflection == Approx(beam.gap).epsilon(1e-11));
    CHECK(contact.total_force == Approx(contact.point_force + w * (4 - s)).epsilon(1e-12));
  }
  if (w > 0.1125) CHECK(slope == Approx(0).margin(1e-13));
  if (w < 0.1125) CHECK(slope > 0);
}

// Without a gap every load presses the whole beam flat; the clamp does not bear anything.
TEST_CASE("ex6.1 held out: no gap", "[ex6.1]") {
  const FoundationContact flat = touch_foundation({4, 20, 0, 3});
  CHECK(flat.touchdown == 0);
  CHECK(flat.point_force == 0);
  CHECK(flat.total_force == Approx(12).epsilon(1e-14));
}

TEST_CASE("ex6.1 held out: a load that lifts, and impossible beams", "[ex6.1]") {
  const FoundationContact lifted = touch_foundation({4, 20, 0.02, -1});
  CHECK(lifted.touchdown == 4);
  CHECK(lifted.point_force == 0);
  CHECK(lifted.total_force == 0);
  CHECK_THROWS_AS(touch_foundation({0, 20, 0.02, 1}), std::invalid_argument);
  CHECK_THROWS_AS(touch_foundation({4, 0, 0.02, 1}), std::invalid_argument);
  CHECK_THROWS_AS(touch_foundation({4, 20, -0.02, 1}), std::invalid_argument);
}

#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"

using namespace signorini;

namespace {

const double E = plane_strain_modulus(210e3, 0.3);
const double nu = plane_strain_ratio(0.3);
/// The recommended geometry of the lining [cm, MPa].
NestedRings lining(double pressure, Meeting meeting = Meeting::EqualPressure) {
  return {{60, 68, E, nu}, {68.15, 76.15, E, nu}, pressure, 0, meeting};
}

}  // namespace

TEST_CASE("ring: in equilibrium, strained as it moves, loaded at its rims", "[rings]") {
  const Ring ring{2, 3.5, 100, 0.4};
  const RingPressure load{7, 3};
  CHECK(ring_stress(ring, load, 2).radial == Approx(-7).epsilon(1e-14));
  CHECK(ring_stress(ring, load, 3.5).radial == Approx(-3).epsilon(1e-14));
  for (const double r : {2.1, 2.8, 3.4}) {
    CAPTURE(r);
    const double h = 1e-4;
    const auto u = [&](double at) { return ring_displacement(ring, load, at); };
    const RingStress s = ring_stress(ring, load, r);
    const double slope =
        (ring_stress(ring, load, r + h).radial - ring_stress(ring, load, r - h).radial) / (2 * h);
    CHECK(slope + (s.radial - s.hoop) / r == Approx(0).margin(1e-6));
    CHECK((u(r + h) - u(r - h)) / (2 * h) == Approx((s.radial - 0.4 * s.hoop) / 100).margin(1e-8));
    CHECK(u(r) / r == Approx((s.hoop - 0.4 * s.radial) / 100).margin(1e-14));
  }
  const Ring full{0, 3, 100, 0.4};  // a disc is pressed evenly
  CHECK(ring_stress(full, {0, 5}, 0).hoop == -5);
  CHECK(ring_displacement(full, {0, 5}, 3) == Approx(-0.6 * 5 * 3 / 100).epsilon(1e-14));
  CHECK_THROWS_WITH(ring_stress(ring, load, 4), ContainsSubstring("no radius 4"));
  CHECK_THROWS_WITH(ring_stress({2, 1, 1, 0}, load, 1), ContainsSubstring("inner < outer"));
}

TEST_CASE("rings: the lining of the paper in the recommended geometry", "[rings][closed-form]") {
  const NestedRings rings = lining(180);
  CHECK(ring_clearance(rings) == Approx(0.15).epsilon(1e-12));
  CHECK(closing_pressure(rings) == Approx(72.39819).epsilon(1e-7).margin(0));
  const NestedPressure p = nested_pressure(rings);
  CHECK(p.inner.outside == Approx(44.24773394).epsilon(1e-9).margin(0));
  CHECK(p.outer.inside == p.inner.outside);
  CHECK(ring_displacement(rings.inner, p.inner, 60) == Approx(0.29202043).epsilon(2e-8).margin(0));
  CHECK(ring_displacement(rings.inner, p.inner, 68) == Approx(0.27381125).epsilon(2e-8).margin(0));
  CHECK(ring_displacement(rings.outer, p.outer, 68.15) ==
        Approx(0.12381125).epsilon(5e-8).margin(0));
  CHECK(ring_displacement(rings.outer, p.outer, 76.15) ==
        Approx(0.11748663).epsilon(5e-8).margin(0));
  CHECK(ring_stress(rings.inner, p.inner, 60).hoop == Approx(1046.01265).epsilon(1e-8).margin(0));
  CHECK(ring_stress(rings.inner, p.inner, 68).hoop == Approx(910.26039).epsilon(1e-8).margin(0));
  CHECK(ring_stress(rings.outer, p.outer, 68.15).hoop == Approx(400.28580).epsilon(1e-8).margin(0));
  CHECK(ring_stress(rings.outer, p.outer, 76.15).hoop ==
        Approx(356.038065).epsilon(1e-9).margin(0));
}

TEST_CASE("rings: the gap closes at the closing pressure and not before", "[rings]") {
  const double closing = closing_pressure(lining(0));
  CHECK(nested_pressure(lining(closing * (1 - 1e-9))).inner.outside == 0);
  CHECK(nested_pressure(lining(closing * (1 + 1e-9))).inner.outside > 0);
  CHECK(nested_pressure(lining(72)).inner.outside == 0);
  CHECK(nested_pressure(lining(73)).inner.outside > 0);
}

TEST_CASE(
    "rings: equal forces balance, and differ from equal pressures by less than the gap's share",
    "[rings]") {
  const NestedRings rings = lining(180, Meeting::EqualForce);
  const NestedPressure p = nested_pressure(rings);
  CHECK(p.inner.outside * 68 == Approx(p.outer.inside * 68.15).epsilon(1e-14).margin(0));
  CHECK(ring_displacement(rings.inner, p.inner, 68) -
            ring_displacement(rings.outer, p.outer, 68.15) ==
        Approx(0.15).epsilon(1e-12).margin(0));
  const double books = nested_pressure(lining(180)).inner.outside;
  CHECK(p.inner.outside > books);
  CHECK(p.inner.outside < books * 68.15 / 68);
}

TEST_CASE("rings: without clearance two rings of one material are one ring", "[rings]") {
  for (const Meeting meeting : {Meeting::EqualForce, Meeting::EqualPressure}) {
    const double e = plane_strain_modulus(1e9, 0.2), n = plane_strain_ratio(0.2);
    const NestedRings rings{{0.2, 0.6, e, n}, {0.6, 1, e, n}, 0, 1e6, meeting};
    const NestedPressure p = nested_pressure(rings);
    const Ring whole{0.2, 1, e, n};
    CHECK(p.inner.outside ==
          Approx(-ring_stress(whole, {0, 1e6}, 0.6).radial).epsilon(1e-13).margin(0));
    CHECK(p.inner.outside ==
          Approx(9.259259e5).epsilon(1e-7).margin(0));  // Code_Aster SSNP167, a tenth
    for (const double r : {0.2, 0.4, 0.6})
      CHECK(ring_displacement(rings.inner, p.inner, r) ==
            Approx(ring_displacement(whole, {0, 1e6}, r)).epsilon(1e-12).margin(0));
    CHECK(ring_displacement(rings.outer, p.outer, 1) ==
          Approx(ring_displacement(whole, {0, 1e6}, 1)).epsilon(1e-12).margin(0));
  }
}

TEST_CASE("rings: a press fit presses by its interference", "[rings]") {
  // one material, no load: p = E' i / b (c^2 - b^2) (b^2 - a^2) / (2 b^2 (c^2 - a^2)), up to i / b
  const NestedRings fit{
      {10, 20.0025, 210e3, 0.3}, {20, 30, 210e3, 0.3}, 0, 0, Meeting::EqualPressure};
  CHECK(ring_clearance(fit) == Approx(-0.0025).epsilon(1e-11));
  const double thin = 210e3 * 0.0025 / 20 * 500 * 300 / (2 * 400 * 800);
  CHECK(nested_pressure(fit).inner.outside == Approx(thin).epsilon(5e-4).margin(0));
  CHECK(closing_pressure(fit) < 0);
  // CalculiX issue 98 quotes 5.74 MPa for these radii without the modulus; it follows from 196 GPa.
  CHECK(nested_pressure(fit).inner.outside * 196 / 210 == Approx(5.74).margin(5e-3));
  const NestedRings shaft{{0, 20.0025, 210e3, 0.3}, {20, 30, 210e3, 0.3}};  // on a shaft
  CHECK(nested_pressure(shaft).inner.outside ==
        Approx(210e3 * 0.0025 / 20 * 500 / (2 * 900)).epsilon(5e-4).margin(0));
  CHECK_THROWS_WITH(closing_pressure(shaft), ContainsSubstring("no inner rim"));
}

#include "closed_form/rings.hpp"

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

/// Lame's two constants: stresses are A -/+ B / r^2.
struct Lame {
  double A;
  double B;
};

Lame lame(const Ring& ring, const RingPressure& load, double r) {
  const double a = ring.inner_radius;
  const double b = ring.outer_radius;
  require_argument(a >= 0 && b > a && ring.modulus > 0,
                   "ring: need 0 <= inner < outer radius and a positive ", "modulus, got ", a, ", ",
                   b, ", ", ring.modulus);
  require_argument(r >= a * (1 - 1e-12) && r <= b * (1 + 1e-12) && (r > 0 || a == 0), "ring from ",
                   a, " to ", b, ": no radius ", r);
  const double area = (b - a) * (b + a);
  return {(load.inside * a * a - load.outside * b * b) / area,
          (load.inside - load.outside) * a * a * b * b / area};
}

}  // namespace

double ring_displacement(const Ring& ring, const RingPressure& load, double r) {
  const auto [A, B] = lame(ring, load, r);
  const double bulge = B == 0 ? 0 : (1 + ring.ratio) * B / r;
  return ((1 - ring.ratio) * A * r + bulge) / ring.modulus;
}

RingStress ring_stress(const Ring& ring, const RingPressure& load, double r) {
  const auto [A, B] = lame(ring, load, r);
  const double bulge = B == 0 ? 0 : B / (r * r);
  return {A - bulge, A + bulge};
}

double ring_clearance(const NestedRings& rings) {
  return rings.outer.inner_radius - rings.inner.outer_radius;
}

// [nested]
NestedPressure nested_pressure(const NestedRings& rings) {
  const double b = rings.inner.outer_radius;
  const double c = rings.outer.inner_radius;
  const double other = rings.meeting == Meeting::EqualForce ? b / c : 1;  // p'_c / p_c
  const double overlap = ring_displacement(rings.inner, {rings.pressure_inside, 0}, b) -
                         ring_displacement(rings.outer, {0, rings.pressure_outside}, c) -
                         ring_clearance(rings);
  const double softness =
      ring_displacement(rings.outer, {other, 0}, c) - ring_displacement(rings.inner, {0, 1}, b);
  const double contact = overlap > 0 ? overlap / softness : 0;
  return {{rings.pressure_inside, contact}, {other * contact, rings.pressure_outside}};
}
// [nested]

double closing_pressure(const NestedRings& rings) {
  require_argument(rings.inner.inner_radius > 0,
                   "closing pressure: the inner ring has no inner rim");
  const double wanted =
      ring_clearance(rings) +
      ring_displacement(rings.outer, {0, rings.pressure_outside}, rings.outer.inner_radius);
  return wanted / ring_displacement(rings.inner, {1, 0}, rings.inner.outer_radius);
}

}  // namespace signorini

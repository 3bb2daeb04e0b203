#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/moduli.hpp"
#include "closed_form/rings.hpp"
#include "exercise.hpp"

using ex14_1::Closure;
using ex14_1::press_lining;
using ex14_1::TwoRings;

// The library's rings, which write the same equation another way.
TEST_CASE("ex14.1 held out: other rings and units, against the library", "[ex14.1]") {
  const TwoRings rings =
      GENERATE(TwoRings{0.2, 0.5, 0.501, 3, 30e9, 0.2},
               TwoRings{600, 680, 681.5, 761.5, 210e3, 0.3}, TwoRings{1, 9, 9.1, 9.2, 2, 0.49});
  const double E = signorini::plane_strain_modulus(rings.youngs_modulus, rings.poisson_ratio);
  const double nu = signorini::plane_strain_ratio(rings.poisson_ratio);
  signorini::NestedRings expected{{rings.a, rings.b, E, nu}, {rings.c, rings.d, E, nu}};
  const double closing = closing_pressure(expected);
  for (const double factor : {0.0, 0.5, 0.999, 1.001, 2.0, 50.0}) {
    CAPTURE(rings.a, factor);
    expected.pressure_inside = factor * closing;
    const signorini::NestedPressure p = nested_pressure(expected);
    const Closure now = press_lining(rings, factor * closing);
    CHECK(now.closing_pressure == Approx(closing).epsilon(1e-12));
    CHECK(now.contact_pressure == Approx(p.inner.outside).epsilon(1e-9).margin(1e-12 * closing));
    CHECK(now.rim_displacement ==
          Approx(ring_displacement(expected.inner, p.inner, rings.a)).epsilon(1e-10).margin(0));
  }
}

// One material without a gap: the pressure at r = b in the one ring a < r < d.
TEST_CASE("ex14.1 held out: without a gap two rings are one", "[ex14.1]") {
  const Closure now = press_lining({2, 3, 3, 6, 100, 0.25}, 10);
  CHECK(now.closing_pressure == 0);
  CHECK(now.contact_pressure == Approx(10 * (36. / 9 - 1) / (36. / 4 - 1)).epsilon(1e-12));
}

TEST_CASE("ex14.1 held out: impossible rings", "[ex14.1]") {
  CHECK_THROWS_AS(press_lining({0, 3, 4, 5, 1, 0.3}, 1), std::invalid_argument);
  CHECK_THROWS_AS(press_lining({2, 3, 2.9, 5, 1, 0.3}, 1), std::invalid_argument);
  CHECK_THROWS_AS(press_lining({2, 3, 4, 4, 1, 0.3}, 1), std::invalid_argument);
  CHECK_THROWS_AS(press_lining({2, 3, 4, 5, 1, 0.3}, -1), std::invalid_argument);
}

#include "catch_compat.hpp"
#include "signorini/core/rounding.hpp"
#include "support/spheres.hpp"

using namespace signorini;
using namespace signorini_test;

TEST_CASE("hollow sphere: in equilibrium, strained as it moves, loaded at its surfaces",
          "[spheres]") {
  const HollowSphere sphere{2, 3.5, 100, 0.4};
  const RingPressure load{7, 3};
  CHECK(sphere_stress(sphere, load, 2).radial == Approx(-7).epsilon(1e-14));
  CHECK(sphere_stress(sphere, load, 3.5).radial == Approx(-3).epsilon(1e-14));
  for (const double r : {2.1, 2.8, 3.4}) {
    CAPTURE(r);
    const double h = 1e-4;  // truncation h^2, rounding 1e-16 / h
    const auto u = [&](double at) { return sphere_displacement(sphere, load, at); };
    const RingStress s = sphere_stress(sphere, load, r);
    const double slope =
        (sphere_stress(sphere, load, r + h).radial - sphere_stress(sphere, load, r - h).radial) /
        (2 * h);
    CHECK(slope + 2 * (s.radial - s.hoop) / r == Approx(0).margin(1e-6));
    CHECK((u(r + h) - u(r - h)) / (2 * h) ==
          Approx((s.radial - 2 * 0.4 * s.hoop) / 100).margin(1e-8));
  }
  const HollowSphere full{0, 3, 100, 0.4};  // is pressed evenly
  CHECK(sphere_stress(full, {0, 5}, 0).hoop == -5);
  CHECK(sphere_displacement(full, {0, 5}, 3) == Approx(-0.2 * 5 * 3 / 100).epsilon(1e-14));
  CHECK_THROWS_WITH(sphere_stress(sphere, load, 4), ContainsSubstring("no radius 4"));
  CHECK_THROWS_WITH(sphere_stress({2, 1, 1, 0}, load, 1), ContainsSubstring("inner < outer"));
}

// SSNV104 of Code_Aster: hemispheres of radius 50 mm that approach by 4 mm, E = 20000 MPa, nu = 0.3.
TEST_CASE("Hertz's spheres: 10 mm and 2798.3 MPa for an approach of 4 mm", "[spheres][hertz]") {
  const double modulus = 20000 / (1 - 0.09) / 2;
  const PointContact contact{25, modulus, 4 * modulus * 1000 / (3 * 25)};
  CHECK(hertz_radius(contact) == Approx(10).epsilon(1e-14));
  CHECK(hertz_approach(contact) == Approx(4).epsilon(1e-14));
  CHECK(hertz_peak_pressure(contact) == Approx(2798.3).epsilon(2e-5));
  CHECK_THROWS_WITH(hertz_radius({1, 1, 0}), ContainsSubstring("must be positive"));
}

TEST_CASE("Hertz's pressure adds up to the force", "[spheres][hertz]") {
  const PointContact contact{3, 7, 0.5};
  const double a = hertz_radius(contact);
  double sum = 0;  // the integral of 2 pi r p: with s^2 = 1 - r^2/a^2 that of 2 pi a^2 p_0 s^2
  const int n = 1000;
  for (int k = 0; k < n; ++k) {
    const double s = (k + 0.5) / n;
    sum += 2 * pi * a * a * hertz_peak_pressure(contact) * s * s / n;
  }
  CHECK(sum == Approx(contact.force).epsilon(1e-6));
}

#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/footing.hpp"
#include "signorini/core/dense.hpp"
#include "support/quadrature.hpp"

using namespace signorini;
using quadrature::pi;

namespace {

constexpr double a = 1.5, q = 15;
const RigidStrip paper{a, 2 * a* q};            // [m, kN/m]
const RigidStrip tilted{a, 2 * a* q, 0.3 * a};  // the load right of the middle
constexpr double modulus = 20e3 / (1 - 0.0625);

/// Sum over the strip of f(x) p(x) dx, with x = a sin t, in which p dx has no root.
double over(const RigidStrip& strip, const quadrature::Function& f) {
  return quadrature::integral(
      [&](double t) {
        const double x = a * std::sin(t);
        return f(x) * strip.force / pi * (1 + 2 * strip.eccentricity * x / (a * a));
      },
      -pi / 2, pi / 2);
}

/// p(0) / q below a plate of the half-width 1 with E* = q = 1: constant pressure on cells, the plate
/// a cantilever from its middle, both surfaces alike in the middle of each cell.
double plate_middle(double softness, int cells) {
  std::vector<double> ends;
  for (int i = 0; i <= cells; ++i) ends.push_back(std::sin(0.5 * pi * i / cells));
  const auto part = [](double t) { return t == 0 ? 0 : t * std::log(std::abs(t)) - t; };
  const auto bent = [](double x, double s) {  // deflection at x by a unit force at s
    return s < x ? s * s * (3 * x - s) / 6 : x * x * (3 * s - x) / 6;
  };
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(cells + 1, cells + 1);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(cells + 1);
  for (int i = 0; i < cells; ++i) {
    const double x = 0.5 * (ends[i] + ends[i + 1]);
    for (int k = 0; k < cells; ++k) {
      const double low = ends[k], high = ends[k + 1], middle = 0.5 * (low + high);
      const double sinks = part(x - high) - part(x - low) - part(x + high) + part(x + low);
      M(i, k) = 2 / pi * sinks + softness * bent(x, middle) * (high - low);
      load[i] += softness * bent(x, middle) * (high - low);
      M(cells, k) = high - low;
    }
    M(i, cells) = -1;  // how far the middle sinks, not known
  }
  load[cells] = 1;
  return LuFactor(M).solve(load)[0];
}

}  // namespace

TEST_CASE("rigid strip: pressure, force and moment", "[footing][closed-form][LinEtAl-46]") {
  CHECK(rigid_strip_pressure(paper, 0) == Approx(2 * q / pi).epsilon(1e-14).margin(0));
  CHECK(rigid_strip_pressure(paper, 1.2) ==
        Approx(2 * q * a / (pi * std::sqrt(a * a - 1.44))).epsilon(1e-14).margin(0));
  CHECK(rigid_strip_pressure(paper, 1.6) == 0);
  for (const RigidStrip& strip : {paper, tilted}) {
    CHECK(rigid_strip_force(strip, -9, 9) == Approx(45).epsilon(1e-14).margin(0));
    CHECK(over(strip, [](double x) { return x; }) == Approx(45 * strip.eccentricity).margin(1e-12));
    for (const auto& [from, to] : {std::pair{-1.4, -0.2}, {0., 0.1}, {0.7, 1.3}})
      CHECK(rigid_strip_force(strip, from, to) ==
            Approx(quadrature::integral([&](double x) { return rigid_strip_pressure(strip, x); },
                                        from, to))
                .epsilon(1e-12)
                .margin(0));
    CHECK(rigid_strip_force(strip, 0.2, 1.5) == -rigid_strip_force(strip, 1.5, 0.2));
  }
  const RigidStrip edge{a, 1, a / 2};  // about to lift off: nothing at the left edge
  CHECK(rigid_strip_pressure(edge, -a * (1 - 1e-12)) < 1e-5);
  CHECK_THROWS_WITH(rigid_strip_pressure({a, 1, 0.51 * a}, 0), ContainsSubstring("half of the"));
}

TEST_CASE("rigid strip: the surface below it stays straight and turns with the load", "[footing]") {
  // Without the root: PV of 1/(x - s) over p ds vanishes for the central load
  for (const RigidStrip& strip : {paper, tilted})
    for (const double x : {-1.2, -0.3, 0.4, 0.9}) {
      CAPTURE(x, strip.eccentricity);
      const double slope =
          2 / (pi * modulus) *
          quadrature::principal_value([&](double s) { return rigid_strip_pressure(strip, s); }, x,
                                      {-a, 0, a});
      // the roots at the ends cost half of the digits; slope > 0 where the surface rises with x
      CHECK(slope == Approx(-rigid_strip_rotation(strip, modulus)).margin(1e-6 * q / modulus));
    }
  CHECK(rigid_strip_rotation(paper, modulus) == 0);
  CHECK_THROWS_AS(rigid_strip_rotation(paper, 0), std::invalid_argument);
}

TEST_CASE("rigid strip: the stress below is that of all line loads", "[footing]") {
  for (const RigidStrip& strip : {paper, tilted})
    for (const auto& [x, z] : {std::pair{0., 1.}, {0.8, 0.4}, {-1.5, 0.3}, {2.5, 1.}, {-4., 3.}}) {
      CAPTURE(x, z, strip.eccentricity);
      const Eigen::Vector3d s = rigid_strip_stress(strip, x, z);
      const double px = x, pz = z;
      const auto line = [&](double at) {  // stress of a unit line load at `at`
        const double X = px - at, r2 = X * X + pz * pz, radial = -2 / pi * pz / (r2 * r2);
        return Eigen::Vector3d(radial * X * X, radial * pz * pz, -radial * X * pz);
      };
      for (int k = 0; k < 3; ++k)
        CHECK(s[k] == Approx(over(strip, [&](double at) { return line(at)[k]; })).margin(1e-9));
      CHECK(quadrature::residual(
                [&](double u, double v) { return rigid_strip_stress(strip, u, -v); }, x, -z, 1e-4) <
            1e-3);
    }
  CHECK(rigid_strip_stress(paper, 0, a)[1] ==
        Approx(-45 / pi * 3 / (a * std::pow(2, 1.5))).epsilon(1e-14));
  CHECK(rigid_strip_stress(paper, 0, a)[1] ==
        Approx(-10.13).margin(5e-3));  // more than on the surface
  for (const double x : {-2., -1., 0.5, 1.4, 3.}) {
    CAPTURE(x);
    const double p = rigid_strip_pressure(tilted, x);
    CHECK((rigid_strip_stress(tilted, x, 0) + Eigen::Vector3d(p, p, 0)).norm() < 1e-12 * q);
    CHECK(rigid_strip_stress(tilted, x, 1e-9)[1] == Approx(-p).margin(1e-6));
  }
  CHECK_THROWS_WITH(rigid_strip_stress(paper, a, 0), ContainsSubstring("edges"));
}

TEST_CASE("flexible strip: the quoted pressures solve the equation of plate and half-plane",
          "[footing]") {
  for (const FlexibleStrip& each : flexible_strips) {
    CAPTURE(each.softness);
    CHECK(each.pressure ==
          Approx(plate_middle(each.softness, 200)).margin(8e-5));  // cells err by 1e-5
  }
}

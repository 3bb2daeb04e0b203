#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "support/quadrature.hpp"

using namespace signorini;
using quadrature::pi;

namespace {

const double body_modulus = plane_strain_modulus(4000, 0.35);
/// The cylinder and the plate of the paper [N, mm].
const LineContact paper{50, contact_modulus(body_modulus, body_modulus), 41.76};
const double b = hertz_half_width(paper);
const double q0 = hertz_peak_pressure(paper);

double none(double) { return 0; }
double pressure(double x) { return hertz_pressure(paper, x); }

}  // namespace

TEST_CASE("Hertz: the paper's contact has the width and height of the true pi",
          "[hertz][closed-form][LinEtAl-43]") {
  CHECK(paper.modulus == Approx(2279.2023).epsilon(2e-8).margin(0));
  CHECK(b == Approx(1.0800127).epsilon(1e-7).margin(0));  // printed 1.08000
  CHECK(q0 == Approx(24.6156746).epsilon(2e-9).margin(0));
  // printed 24.6219, which is what pi = 3.14 gives
  CHECK(q0 * std::sqrt(pi / 3.14) == Approx(24.6219).epsilon(2e-6).margin(0));
  // the formula as printed, with E and nu instead of E*
  CHECK(b ==
        Approx(2 * std::sqrt(2 * 50 * 41.76 * (1 - 0.35 * 0.35) / (pi * 4000))).epsilon(1e-14));
}

TEST_CASE("Hertz: the pressure sums to the load and bends the surfaces together",
          "[hertz][LinEtAl-43]") {
  CHECK(quadrature::integral(pressure, -b, b) == Approx(paper.force).epsilon(1e-12).margin(0));
  CHECK(pressure(0) == q0);
  CHECK(pressure(1.01 * b) == 0);
  for (const double x : {0.1 * b, -0.4 * b, 0.9 * b}) {
    CAPTURE(x);
    // slope of the two surfaces under p is that of the parabola
    const double slope =
        2 / (pi * paper.modulus) * quadrature::principal_value(pressure, x, {-b, b});
    CHECK(slope == Approx(x / paper.radius).epsilon(1e-9).margin(0));
  }
}

TEST_CASE("Hertz: the stress below is that of all line loads, in equilibrium and compatible",
          "[hertz]") {
  const double points[][2] = {{0, 0.3},    {0.3, 0.5}, {0.87, 0.5},
                              {-0.6, 0.2}, {1.4, 0.7}, {-2, 1.5}};
  for (const auto& [X, Z] : points) {
    CAPTURE(X, Z);
    const Eigen::Vector3d loads = quadrature::below(pressure, none, X * b, Z * b,
                                                    {-b, X * b > b || X * b < -b ? 0 : X * b, b});
    CHECK((hertz_stress(paper, X * b, Z * b) - loads).norm() < 1e-9 * q0);
    const auto field = [](double x, double y) { return hertz_stress(paper, x, -y); };
    // differences of step h err by h^2 / b^3 of the stress
    CHECK(quadrature::residual(field, X * b, -Z * b, 1e-4 * b) < 1e-3 * q0 / b);
    CHECK(hertz_stress(paper, -X * b, Z * b)[2] == -hertz_stress(paper, X * b, Z * b)[2]);
  }
  for (const double x : {-1.5 * b, -b, -0.3 * b, 0.0, 0.99 * b, b, 3 * b}) {
    CAPTURE(x);
    CHECK((hertz_stress(paper, x, 0) + Eigen::Vector3d(pressure(x), pressure(x), 0)).norm() <
          1e-14 * q0);
  }
}

TEST_CASE("Hertz: the largest shear is where the golden ratio says", "[hertz]") {
  const LargestShear largest = hertz_largest_shear(paper);
  // As many digits as are quoted.
  CHECK(largest.stress == Approx(7.3917).epsilon(1e-5).margin(0));
  CHECK(largest.depth == Approx(0.8491).epsilon(1e-4).margin(0));
  const auto shear = [](double x, double z) {
    const Eigen::Vector3d s = hertz_stress(paper, x, z);
    return std::hypot((s[0] - s[1]) / 2, s[2]);
  };
  CHECK(shear(0, largest.depth) == Approx(largest.stress).epsilon(1e-14).margin(0));
  double elsewhere = 0, crosswise = 0;
  for (int i = 0; i <= 200; ++i)
    for (int k = 0; k <= 200; ++k) {
      const double x = 0.01 * i * b, z = 0.01 * k * b;
      elsewhere = std::max(elsewhere, shear(x, z));
      crosswise = std::max(crosswise, std::abs(hertz_stress(paper, x, z)[2]));
    }
  CHECK(elsewhere <= largest.stress * (1 + 1e-14));
  CHECK(elsewhere >= largest.stress * (1 - 1e-3));
  // The nearest of these points is 0.004 b from the largest, where the slope is 0.
  CHECK(crosswise == Approx(q0 / 4).epsilon(1e-4).margin(0));
  CHECK(hertz_stress(paper, std::sqrt(0.75) * b, 0.5 * b)[2] == Approx(q0 / 4).epsilon(1e-14));
}

TEST_CASE("Hertz: published contacts", "[hertz]") {
  const LineContact roller{
      50, contact_modulus(plane_strain_modulus(210000, 0.3), plane_strain_modulus(70000, 0.3)),
      35000};  // NAFEMS contact benchmark 1
  CHECK(hertz_half_width(roller) == Approx(6.21463).epsilon(1e-6).margin(0));
  CHECK(hertz_peak_pressure(roller) == Approx(3585.36).epsilon(1e-6).margin(0));
  CHECK_THROWS_WITH(hertz_half_width({1, 1, 0}), ContainsSubstring("force must be positive"));
  CHECK_THROWS_WITH(hertz_stress(paper, 0, -1), ContainsSubstring("depth must not be negative"));
  CHECK(disc_approach(paper, body_modulus, 50) == Approx(0.0275355).epsilon(1e-5).margin(0));
  CHECK_THROWS_AS(disc_approach(paper, 0, 1), std::invalid_argument);
}

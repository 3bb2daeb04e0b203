#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/disc_between_plates.hpp"
#include "closed_form/moduli.hpp"
#include "support/quadrature.hpp"

using namespace signorini;
using quadrature::pi;

namespace {

constexpr double R = 50;  // disc and plate of the paper [mm, N]
const double body_modulus = plane_strain_modulus(4000, 0.35);
const double body_ratio = plane_strain_ratio(0.35);
const LineContact plate{R, contact_modulus(body_modulus, body_modulus), 41.76};
const double b = hertz_half_width(plate);
const double q0 = hertz_peak_pressure(plate);
const double unit = brazilian_strength({R, 41.76});

/// Traction on a cut with the normal (sin theta, cos theta).
Eigen::Vector2d traction(const Eigen::Vector3d& s, double theta) {
  const double x = std::sin(theta), y = std::cos(theta);
  return {s[0] * x + s[2] * y, s[2] * x + s[1] * y};
}

}  // namespace

TEST_CASE("disc under a chord: free at the rim, in equilibrium, P on every cut", "[brazilian]") {
  const SqueezedDisc disc{R, 41.76};
  const auto stress = [&](double x, double y) { return line_loaded_disc_stress(disc, x, y, 15); };
  for (const double theta : {0.0, 0.1, 0.5, 1.5, 2.5, -1.0, -3.0}) {
    CAPTURE(theta);
    const double x = R * std::sin(theta), y = R * std::cos(theta);
    CHECK(traction(stress(x, y), theta).norm() < 1e-14);
    CHECK(quadrature::residual(stress, 0.6 * x, 0.6 * y, 0.01) < 1e-7);
  }
  const double half = std::sqrt(R * R - 49);
  CHECK(quadrature::integral([&](double x) { return stress(x, 7)[1]; }, {-half, 15, half}) ==
        Approx(-41.76).epsilon(1e-12).margin(0));
  CHECK_THROWS_WITH(line_loaded_disc_stress(disc, 0, 0, 51), ContainsSubstring("outside"));
  CHECK_THROWS_WITH(line_loaded_disc_stress(disc, 30, 40, 30), ContainsSubstring("under a load"));
}

TEST_CASE("disc between plates: the sum is the integral over the pressure", "[brazilian]") {
  for (const auto& point : {Eigen::Vector2d(0, 49.5), Eigen::Vector2d(0.9, 49.7),
                            Eigen::Vector2d(3, -48), Eigen::Vector2d(20, 10)}) {
    CAPTURE(point.transpose());
    const Eigen::Vector3d s = plate_loaded_disc_stress(plate, R, point[0], point[1]);
    for (int k = 0; k < 3; ++k)
      CHECK(s[k] == Approx(quadrature::integral(
                               [&](double at) {
                                 return hertz_pressure(plate, at) *
                                        line_loaded_disc_stress({R, 1}, point[0], point[1], at)[k];
                               },
                               {-b, point[0] > b ? 0 : point[0], b}))
                        .margin(1e-11 * q0));
  }
  // near the surface, the pressure itself
  CHECK(plate_loaded_disc_stress(plate, R, 0.3, std::sqrt(R * R - 0.09) - 0.011 * b)[1] ==
        Approx(-hertz_pressure(plate, 0.3)).epsilon(2e-3));
  CHECK_THROWS_WITH(plate_loaded_disc_stress(plate, R, 0, R), ContainsSubstring("too near"));
}

TEST_CASE("disc between plates: the axis in closed form, and what the half-plane in it costs",
          "[brazilian]") {
  for (const auto& [z, share] : {std::pair{2 * b, 0.015}, {3 * b, 0.004}, {10., 1e-3}, {R, 1e-3}}) {
    CAPTURE(z);
    const Eigen::Vector3d arc = plate_loaded_disc_stress(plate, R, 0, R - z);
    const Eigen::Vector3d plane = loaded_diameter_stress(plate, R, z);
    const double height = R - z;
    CHECK(plane[0] - arc[0] == Approx(0).margin(share * unit));
    CHECK(plane[1] == Approx(arc[1]).epsilon(1e-3).margin(0));
    // radial pressure instead, as a sum of Hondros' arcs, differs by as much again
    const double radial = quadrature::integral(
        [&](double t) {
          const double alpha = t * b / R;
          const SqueezedDisc unit_pressure{R, 2 * R * std::sin(alpha)};
          return q0 * t / std::sqrt((1 - t) * (1 + t)) *
                 arc_loaded_disc_stress(unit_pressure, alpha, 0, height)[0];
        },
        0, 1);
    CHECK(plane[0] - radial == Approx(0).margin(2 * share * unit));
  }
  CHECK(loaded_diameter_stress(plate, R, 10)[0] == Approx(0.258189).margin(5e-7));
  CHECK(loaded_diameter_stress(plate, R, 30)[0] == Approx(0.265566).margin(5e-7));
  CHECK_THROWS_WITH(loaded_diameter_stress(plate, R, 51), ContainsSubstring("no depth of 51"));
}

TEST_CASE("disc between plates: tension begins 2.95 mm below the contact", "[brazilian]") {
  const double zero = tension_depth(plate, R);
  CHECK(zero == Approx(2.95068).epsilon(1e-6).margin(0));
  CHECK(std::abs(loaded_diameter_stress(plate, R, zero)[0]) < 1e-12);
  // Far below the contact the pressure acts across as -P b^2 / (2 pi z^3) (1 - (b/z)^2 + ...), against P / (pi R): so z is shorter
  // than the cube root by (b/z)^2 / 3 = 0.045, less terms of the fourth order: 0.041, and 0.016 with a sixteenth of the force.
  CHECK(zero == Approx(std::cbrt(R * b * b / 2)).epsilon(0.05));
  CHECK(plate_loaded_disc_stress(plate, R, 0, R - zero + 0.01)[0] < 0);
  CHECK(plate_loaded_disc_stress(plate, R, 0, R - zero - 0.01)[0] > 0);
}

TEST_CASE("disc between plates: the strain of the axis sums to the approach of the centre",
          "[brazilian][hertz]") {
  const double approach = quadrature::integral(
      [](double z) {
        const Eigen::Vector3d s = loaded_diameter_stress(plate, R, z);
        return (body_ratio * s[0] - s[1]) / body_modulus;
      },
      {0, 1, 10, R});
  // equal up to (b/R)^2
  CHECK(disc_approach(plate, body_modulus, R) == Approx(approach).epsilon(1e-4).margin(0));
}

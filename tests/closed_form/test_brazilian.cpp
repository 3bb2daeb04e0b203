#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/brazilian.hpp"
#include "support/quadrature.hpp"

using namespace signorini;
using quadrature::pi;

namespace {

const SqueezedDisc disc{50, 41.76};  // of the paper [mm, N/mm]
const double unit = brazilian_strength(disc);

/// Traction on a cut with the normal (sin theta, cos theta).
Eigen::Vector2d traction(const Eigen::Vector3d& s, double theta) {
  const double x = std::sin(theta), y = std::cos(theta);
  return {s[0] * x + s[2] * y, s[2] * x + s[1] * y};
}

/// Hondros' series, term by term: (xx, yy, xy).
Eigen::Vector3d series(double half_angle, double x, double y) {
  const double rho2 = (x * x + y * y) / 2500, theta = std::atan2(x, y);
  double radial = half_angle, hoop = half_angle, shear = 0, power = 1;
  for (int n = 1; n < 3000; ++n, power *= rho2) {
    const double s = power * std::sin(2 * n * half_angle);
    radial += (1 - (1 - 1. / n) * rho2) * s * std::cos(2 * n * theta);
    hoop -= (1 - (1 + 1. / n) * rho2) * s * std::cos(2 * n * theta);
    shear += (1 - rho2) * s * std::sin(2 * n * theta);
  }
  const double p = 2 / pi * 41.76 / (100 * std::sin(half_angle));
  const Eigen::Vector2d r(std::sin(theta), std::cos(theta)), t(r[1], -r[0]);
  const Eigen::Matrix2d sum = -radial * r * r.transpose() - hoop * t * t.transpose() +
                              shear * (r * t.transpose() + t * r.transpose());
  return p * Eigen::Vector3d(sum(0, 0), sum(1, 1), sum(0, 1));
}

}  // namespace

TEST_CASE("disc under lines: tension across, three times as much compression along",
          "[brazilian][closed-form][LinEtAl-44][LinEtAl-45]") {
  CHECK(unit == Approx(0.26585242).epsilon(2e-8).margin(0));
  CHECK(unit * pi / 3.14 == Approx(0.26598726).epsilon(1e-8).margin(0));  // as printed
  const auto stress = [](double x, double y) { return line_loaded_disc_stress(disc, x, y); };
  CHECK((stress(0, 0) - Eigen::Vector3d(unit, -3 * unit, 0)).norm() < 1e-15);
  for (const double y : {-45., -20., 3., 30., 49.}) {
    CAPTURE(y);
    CHECK(stress(0, y)[0] == Approx(unit).epsilon(1e-13).margin(0));
    CHECK(stress(0, y)[1] ==
          Approx(-2 * 41.76 / pi * (1 / (50 - y) + 1 / (50 + y) - 0.01)).epsilon(1e-13).margin(0));
    const double r2 = y * y / 2500;  // and on the other diameter
    CHECK(stress(y, 0)[0] ==
          Approx(unit * std::pow((1 - r2) / (1 + r2), 2)).epsilon(1e-12).margin(0));
    CHECK(stress(y, 0)[1] ==
          Approx(-unit * (4 / std::pow(1 + r2, 2) - 1)).epsilon(1e-12).margin(1e-15));
  }
}

TEST_CASE("disc under lines: in equilibrium, compatible, free at the rim, and P on every cut",
          "[brazilian][LinEtAl-45]") {
  const auto stress = [](double x, double y) { return line_loaded_disc_stress(disc, x, y); };
  for (const double theta : {0.05, 0.7, 1.4, 2.3, 3.0, -0.4, -2.0}) {
    CAPTURE(theta);
    const double x = 50 * std::sin(theta), y = 50 * std::cos(theta);
    CHECK(traction(stress(x, y), theta).norm() < 1e-10 * unit / (theta * theta));
    CHECK(quadrature::residual(stress, 0.6 * x, 0.6 * y, 0.01) < 1e-7);
  }
  for (const double y : {0., 7., -40.}) {
    const double half = std::sqrt(2500 - y * y);
    CHECK(quadrature::integral([&](double x) { return stress(x, y)[1]; }, -half, half) ==
          Approx(-41.76).epsilon(1e-12).margin(0));
    CHECK(std::abs(quadrature::integral([&](double x) { return stress(x, y)[2]; }, -half, half)) <
          1e-12);
  }
  CHECK(stress(11, 17)[2] == -stress(-11, 17)[2]);
  CHECK(stress(11, 17)[2] == -stress(11, -17)[2]);
  CHECK(stress(5, 45)[2] >
        0);  // to the right of the upper load what is right of a cut is pulled up
  CHECK_THROWS_WITH(stress(0, 50), ContainsSubstring("under a load"));
  CHECK_THROWS_WITH(stress(40, 40), ContainsSubstring("outside"));
  CHECK_THROWS_AS(brazilian_strength({0, 1}), std::invalid_argument);
}

TEST_CASE("disc under arcs: closed form and series agree, with Hondros' formula on the axis",
          "[brazilian]") {
  for (const double alpha : {0.05, 0.3, 1.2})
    for (const auto& [x, y] :
         {std::pair{0., 0.}, {11., 17.}, {-30., 35.}, {48., -3.}, {-7., -44.}}) {
      CAPTURE(alpha, x, y);
      CHECK((arc_loaded_disc_stress(disc, alpha, x, y) - series(alpha, x, y)).norm() < 1e-12);
    }
  const double alpha = 8 * pi / 180, p = 41.76 / (100 * std::sin(alpha));
  for (const double rho : {0.0, 0.3, 0.8, 0.99}) {
    CAPTURE(rho);
    const double r2 = rho * rho;
    const double S = (1 - r2) * std::sin(2 * alpha) / (1 - 2 * r2 * std::cos(2 * alpha) + r2 * r2);
    const double T = std::atan((1 + r2) / (1 - r2) * std::tan(alpha));
    const Eigen::Vector3d s = arc_loaded_disc_stress(disc, alpha, 0, 50 * rho);
    CHECK(s[0] == Approx(2 * p / pi * (S - T)).epsilon(1e-12).margin(1e-14));
    CHECK(s[1] == Approx(-2 * p / pi * (S + T)).epsilon(1e-12).margin(0));
  }
}

TEST_CASE("disc under arcs: rim, cuts, equilibrium, and the limit of two lines", "[brazilian]") {
  const double alpha = 0.2, p = 41.76 / (100 * std::sin(alpha));
  const auto stress = [&](double x, double y) { return arc_loaded_disc_stress(disc, alpha, x, y); };
  for (const double theta : {0.0, 0.15, 0.25, 1.5, 2.9, -3.0}) {
    CAPTURE(theta);
    const double x = std::sin(theta), y = std::cos(theta), r = 50 * (1 - 1e-9);
    const bool loaded = std::abs(y) > std::cos(alpha);
    CHECK(
        (traction(stress(r * x, r * y), theta) + (loaded ? p : 0) * Eigen::Vector2d(x, y)).norm() <
        1e-5 * p);
    CHECK(quadrature::residual(stress, 30 * x, 30 * y, 0.01) < 1e-7);
  }
  CHECK(quadrature::integral([&](double x) { return stress(x, 7)[1]; }, -std::sqrt(2451.),
                             std::sqrt(2451.)) == Approx(-41.76).epsilon(1e-10).margin(0));
  CHECK(
      (arc_loaded_disc_stress(disc, 1e-4, 11, 17) - line_loaded_disc_stress(disc, 11, 17)).norm() <
      1e-8);
  // tension in the centre over P / (pi R), five digits, for arcs 2 alpha in degrees
  for (const auto& [degrees, tension] :
       {std::pair{2., 0.9996}, {10., 0.9911}, {15., 0.9800}, {20., 0.9645}, {30., 0.9203}})
    CHECK(arc_loaded_disc_stress(disc, degrees * pi / 360, 0, 0)[0] / unit ==
          Approx(tension).margin(6e-5));
  CHECK_THROWS_WITH(arc_loaded_disc_stress(disc, 2, 0, 0), ContainsSubstring("half an arc"));
  CHECK_THROWS_AS(arc_loaded_disc_stress(disc, 1, 0, 50), std::invalid_argument);
}

#include <cmath>

#include "catch_compat.hpp"
#include "closed_form/cattaneo.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "support/quadrature.hpp"

using namespace signorini;

namespace {

const PartialSlip slip{1.3, 8, 0.3};
const double limit = slip_limit(slip);

double pressure(double x) { return 8 * std::sqrt(std::max(0.0, 1 - x * x / 1.69)); }

/// Gradient of the tangential displacement of the surface, but for its modulus.
double gradient(const quadrature::Function& traction, double x, std::vector<double> points) {
  return quadrature::principal_value(traction, x, points);
}

}  // namespace

TEST_CASE("partial slip: the traction sums to the force and never exceeds friction", "[cattaneo]") {
  for (const double Q : {0.2 * limit, 0.6 * limit, -0.9 * limit, limit}) {
    CAPTURE(Q);
    const double c = stick_half_width(slip, Q);
    const auto t = [&](double x) { return slip_traction(slip, Q, x); };
    const std::vector<double> points =
        c > 0 ? std::vector<double>{-1.3, -c, c, 1.3} : std::vector<double>{-1.3, 1.3};
    CHECK(quadrature::integral(t, points) == Approx(Q).epsilon(1e-12).margin(0));
    for (double x = -1.29; x < 1.3; x += 0.03) {
      const double bound = 0.3 * pressure(x);
      CHECK(std::abs(t(x)) <= bound * (1 + 1e-12));
      if (std::abs(x) > c) CHECK(std::abs(t(x)) == Approx(bound).epsilon(1e-12));
      if (std::abs(x) < 0.99 * c) CHECK(std::abs(t(x)) < bound);
    }
  }
  CHECK(slip_traction(slip, 0, 0.5) == 0);
  CHECK(stick_half_width(slip, 0) == 1.3);
}

TEST_CASE("partial slip: what sticks moves as one, what slips does so against the traction",
          "[cattaneo]") {
  const double Q = 0.6 * limit, c = stick_half_width(slip, Q);
  const auto t = [&](double x) { return slip_traction(slip, Q, x); };
  for (const double x : {-0.9 * c, -0.2 * c, 0.5 * c})
    CHECK(std::abs(gradient(t, x, {-1.3, -c, c, 1.3})) < 1e-7);
  // beyond the stick zone the displacement falls with the distance: it lags behind the rest
  CHECK(gradient(t, 1.1 * c, {-1.3, -c, c, 1.3}) > 0.1);
  CHECK(gradient(t, -1.1 * c, {-1.3, -c, c, 1.3}) < -0.1);
}

TEST_CASE("partial slip: on the way back the past stays in the middle until it is forgotten",
          "[cattaneo]") {
  const double top = 0.6 * limit, Q = 0.1 * limit;
  const double c1 = stick_half_width(slip, top), c2 = stick_half_width(slip, (top - Q) / 2);
  const auto back = [&](double x) { return slip_traction_back(slip, top, Q, x); };
  const std::vector<double> points{-1.3, -c2, -c1, c1, c2, 1.3};
  CHECK(quadrature::integral(back, points) == Approx(Q).epsilon(1e-11).margin(0));
  CHECK(back(1.2) == Approx(-0.3 * pressure(1.2)).epsilon(1e-12));
  CHECK(c2 == Approx(1.3 * std::sqrt(0.75)).epsilon(1e-12));
  const auto change = [&](double x) { return back(x) - slip_traction(slip, top, x); };
  for (const double x : {0.1, 0.5, -0.7}) CHECK(std::abs(gradient(change, x, points)) < 1e-7);
  for (double x = -1.28; x < 1.3; x += 0.1) {
    CAPTURE(x);
    CHECK(slip_traction_back(slip, top, top, x) ==
          Approx(slip_traction(slip, top, x)).margin(1e-14));
    CHECK(slip_traction_back(slip, top, -top, x) ==
          Approx(slip_traction(slip, -top, x)).margin(1e-14));
  }
}

TEST_CASE("partial slip: the benchmark of Yang, Laursen and Meng as it is computed in ANSYS VM272",
          "[cattaneo]") {
  const double body = plane_strain_modulus(200, 0.3);
  const LineContact contact{4, contact_modulus(body, body), 10};  // two half-cylinders of 8
  const PartialSlip here{hertz_half_width(contact), hertz_peak_pressure(contact), 0.2};
  CHECK(here.half_width == Approx(0.680778).epsilon(1e-6).margin(0));
  CHECK(here.peak_pressure == Approx(9.351351).epsilon(1e-6).margin(0));
  CHECK(slip_limit(here) == Approx(2).epsilon(1e-14).margin(0));
  CHECK(stick_half_width(here, 0.05851 * 16) == Approx(0.496511).epsilon(2e-6).margin(0));
}

TEST_CASE("partial slip: beyond the limit nothing holds", "[cattaneo]") {
  CHECK_THROWS_WITH(stick_half_width(slip, 1.001 * limit), ContainsSubstring("beyond the limit"));
  CHECK_THROWS_WITH(slip_traction_back(slip, 1, 1.1, 0), ContainsSubstring("where it turned"));
  CHECK_THROWS_AS(slip_limit({1, 1, 0}), std::invalid_argument);
}

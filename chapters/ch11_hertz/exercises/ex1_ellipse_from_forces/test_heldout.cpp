#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/hertz_fit.hpp"
#include "exercise.hpp"
#include "support/hertz_reading.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using ex11_1::Ellipse;
using ex11_1::ellipse_of_forces;

namespace {

// What q0 sqrt(1 - (x - c)^2 / b^2) does on the hat functions of the nodes: by many points in the angle,
// for which the root is smooth.
VectorXd consistent_forces(const VectorXd& x, double c, double b, double q0) {
  VectorXd force = VectorXd::Zero(x.size());
  const int points = 200000;
  const double step = std::acos(-1.0) / points;
  Index k = 0;
  for (int i = 0; i < points; ++i) {
    const double angle = (i + 0.5) * step - std::acos(0.0);
    const double place = c + b * std::sin(angle);
    while (x(k + 1) < place) ++k;
    const double right = (place - x(k)) / (x(k + 1) - x(k));
    const double part = q0 * b * std::pow(std::cos(angle), 2) * step;
    force(k) += part * (1 - right);
    force(k + 1) += part * right;
  }
  return force;
}

}  // namespace

TEST_CASE("ex11.1 held out: forces of an ellipse on uneven nodes, off the middle", "[ex11.1]") {
  const double centre = GENERATE(0.0, 0.21);
  VectorXd x(41);  // steps of 0.05 to 0.1
  for (Index k = 0; k < 41; ++k) {
    const double t = (static_cast<double>(k) - 20) / 20;
    x(k) = t * (1 + 0.5 * t * t);
  }
  const VectorXd force = consistent_forces(x, centre, 1.1, 24);
  const Ellipse out = ellipse_of_forces(x, force, 1);
  CAPTURE(centre);
  CHECK(out.centre == Approx(centre).epsilon(0).margin(1e-9));
  CHECK(out.half_width == Approx(1.1).epsilon(0.0005));  // bare sums are 0.08 % off
  CHECK(out.peak_pressure == Approx(24).epsilon(0.002));
}

// The half model of the chapter, made whole.
TEST_CASE("ex11.1 held out: the contact of this chapter", "[ex11.1]") {
  const signorini_test::HertzProblem problem;
  const signorini_test::HertzReading half = signorini_test::read_hertz(
      problem, signorini::solved(signorini_test::scene_of(problem), "Hertz"));
  const auto n = static_cast<Index>(half.x.size());
  VectorXd x(2 * n - 1), force(2 * n - 1);
  for (Index k = 0; k < n; ++k) {
    const auto from = static_cast<std::size_t>(k);
    x(n - 1 - k) = -half.x[from];
    x(n - 1 + k) = half.x[from];
    force(n - 1 - k) = force(n - 1 + k) = half.force[from] * (k == 0 ? 2 : 1);
  }
  const Ellipse out = ellipse_of_forces(x, force, 1);
  CHECK(out.centre == Approx(0).margin(1e-12));
  CHECK(out.half_width ==
        Approx(signorini::half_width_of_forces(half.x, half.force)).epsilon(1e-12));
  CHECK(out.half_width == Approx(1.0800127).epsilon(0.002));
  CHECK(out.peak_pressure == Approx(24.615675).epsilon(0.002));
}

TEST_CASE("ex11.1 held out: input that makes no contact is refused", "[ex11.1]") {
  const VectorXd x = VectorXd::LinSpaced(5, 0, 4);
  const VectorXd force = VectorXd::Ones(5);
  CHECK_THROWS_AS(ellipse_of_forces(x, force.head(4), 1), std::invalid_argument);
  CHECK_THROWS_AS(ellipse_of_forces(x.reverse(), force, 1), std::invalid_argument);
  CHECK_THROWS_AS(ellipse_of_forces(x, force, 0), std::invalid_argument);
  VectorXd two = VectorXd::Zero(5);
  two.head(2).setOnes();
  CHECK_THROWS_AS(ellipse_of_forces(x, two, 1), std::invalid_argument);
}

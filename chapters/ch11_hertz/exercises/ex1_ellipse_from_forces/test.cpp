#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using Eigen::VectorXd;
using ex11_1::Ellipse;
using ex11_1::ellipse_of_forces;

static VectorXd list(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

// A pressure of 1 from -2 to 2 has the second moment 16/3. No ellipse, but every sum is exact.
TEST_CASE("ex11.1 the second moment of a uniform pressure is exact", "[ex11.1]") {
  const Ellipse out = ellipse_of_forces(list({-2, -1, 0, 1, 2}), list({0.5, 1, 1, 1, 0.5}), 1);
  CHECK(out.centre == Approx(0).margin(1e-15));
  CHECK(out.half_width == Approx(2 * std::sqrt(4.0 / 3)).epsilon(1e-14));
  CHECK(out.peak_pressure == Approx(1).epsilon(1e-14));
}

TEST_CASE("ex11.1 another place and another thickness", "[ex11.1]") {
  const Ellipse out = ellipse_of_forces(list({5, 6, 7, 8, 9}), list({1, 2, 2, 2, 1}), 4);
  CHECK(out.centre == Approx(7).epsilon(1e-14));
  CHECK(out.half_width == Approx(2 * std::sqrt(4.0 / 3)).epsilon(1e-14));
  CHECK(out.peak_pressure == Approx(0.5).epsilon(1e-14));
}

// Forces that are an ellipse of b = 1, q0 = 3 at every node, times the step: the line is exact.
TEST_CASE("ex11.1 the peak of an ellipse comes from the line", "[ex11.1]") {
  const VectorXd x = VectorXd::LinSpaced(31, -1.5, 1.5);
  const VectorXd force = 0.3 * (1 - x.array().square()).max(0).sqrt();
  const Ellipse out = ellipse_of_forces(x, force, 1);
  CHECK(out.centre == Approx(0).margin(1e-14));
  CHECK(out.peak_pressure == Approx(3).epsilon(1e-12));
}

// Edges of different length and a pressure x + 1 from 0 to 3: forces by hand, nodes 0, 1, 3.
TEST_CASE("ex11.1 long edges need more correction than short ones", "[ex11.1]") {
  const VectorXd x = list({0, 1, 3});
  const VectorXd force = list({2.0 / 3, 3.5, 10.0 / 3});
  const Ellipse out = ellipse_of_forces(x, force, 1);
  const double s0 = 4.0 / 3, s1 = 7.0 / 3, s2 = 10.0 / 3;
  const double c = 13.5 / 7.5;
  const double moment = 33.5 - 7.5 * c * c - (s0 + s1 + 8 * (s1 + s2)) / 12;
  CHECK(out.centre == Approx(c).epsilon(1e-14));
  CHECK(out.half_width == Approx(2 * std::sqrt(moment / 7.5)).epsilon(1e-13));
}

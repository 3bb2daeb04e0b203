#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "closed_form/brazilian.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector2d;
using Eigen::Vector3d;
using ex12_1::disc_stress;
using ex12_1::line_load_stress;

static const double pi = std::acos(-1.0);

// The force's pull on a half circle about it: all of P, whatever the radius.
TEST_CASE("ex12.1 held out: a half circle carries the force, sideways too", "[ex12.1]") {
  const Vector2d direction(0.6, 0.8), edge(-0.8, 0.6), foot(3, -1);
  for (const double r : {0.1, 7.0}) {
    Vector2d sum = Vector2d::Zero();
    const int n = 2000;  // midpoints of a smooth function over its whole period: exact
    for (int k = 0; k < n; ++k) {
      const double theta = ((k + 0.5) / n - 0.5) * pi;
      const Vector2d ray = std::cos(theta) * direction + std::sin(theta) * edge;
      const Vector3d s = line_load_stress(5, foot, direction, foot + r * ray);
      sum +=
          Vector2d(s[0] * ray.x() + s[2] * ray.y(), s[2] * ray.x() + s[1] * ray.y()) * r * pi / n;
    }
    CHECK((sum + 5 * direction).norm() < 1e-11);
  }
}

TEST_CASE("ex12.1 held out: the library's field, everywhere in the disc", "[ex12.1]") {
  signorini::Random random(12);
  for (int k = 0; k < 200; ++k) {
    const double r = 2.5 * std::sqrt(random.uniform(0, 0.999)), t = random.uniform(0, 2 * pi);
    const Vector2d at(r * std::cos(t), r * std::sin(t));
    CAPTURE(at.transpose());
    const Vector3d expected = signorini::line_loaded_disc_stress({2.5, 0.7}, at.x(), at.y());
    CHECK(equal_within(disc_stress(2.5, 0.7, 0, at), expected, 1e-12 * (1 + expected.norm())));
  }
}

// Turned by a quarter the components change places, and the shear its sign.
TEST_CASE("ex12.1 held out: turned loads turn the field", "[ex12.1]") {
  const Vector3d upright = disc_stress(1, 2, 0, {0.3, 0.5});
  const Vector3d level = disc_stress(1, 2, pi / 2, {0.5, -0.3});
  CHECK(equal_within(level, Vector3d(upright[1], upright[0], -upright[2]), 1e-13));
  const double a = 0.4, c = std::cos(a), s = std::sin(a);
  const Vector3d turned = disc_stress(1, 2, a, {0.3 * c + 0.5 * s, -0.3 * s + 0.5 * c});
  CHECK(turned[0] + turned[1] == Approx(upright[0] + upright[1]).epsilon(1e-13));
  CHECK(turned[0] == Approx(c * c * upright[0] + s * s * upright[1] + 2 * s * c * upright[2]));
}

TEST_CASE("ex12.1 held out: places without a stress are refused", "[ex12.1]") {
  CHECK_THROWS_AS(line_load_stress(1, {0, 0}, {0, -1}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(line_load_stress(1, {0, 0}, {0, -1}, {1, 0.1}), std::invalid_argument);
  CHECK(line_load_stress(1, {0, 0}, {0, -1}, {1, 0}).norm() == 0);
  CHECK_THROWS_AS(disc_stress(1, 1, 0, {0.8, 0.7}), std::invalid_argument);
  CHECK_THROWS_AS(disc_stress(1, 1, 0, {0, -1}), std::invalid_argument);
  CHECK_THROWS_AS(disc_stress(0, 1, 0, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(disc_stress(1, -1, 0, {0, 0}), std::invalid_argument);
}

#include <cmath>
#include <cstring>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_5;

namespace {

const Lame stiff{11, 7};

StressResponse at(const Components& H) {
  StressResponse response;
  stress(stiff, H, response);
  return response;
}

Components gradient(double a, double b, double c, double d, double e) {
  return (Components() << a, b, c, d, e).finished();
}

Components hooke(const Components& D) {
  const double spread = stiff.lambda * (D(0) + D(3) + D(4));
  const double shear = stiff.mu * (D(1) + D(2));
  return gradient(2 * stiff.mu * D(0) + spread, shear, shear, 2 * stiff.mu * D(3) + spread,
                  2 * stiff.mu * D(4) + spread);
}

}  // namespace

TEST_CASE("ex22.5 held out: at rest it is Hooke's law", "[ex22.5]") {
  const Components D = gradient(0.3, 1, -0.4, 0.8, -0.2);
  CHECK((at(Components::Zero()).tangent * D - hooke(D)).norm() < 1e-13);
}

TEST_CASE("ex22.5 held out: a small strain keeps its digits", "[ex22.5]") {
  const Components D = gradient(0.3, 1, -0.4, 0.8, -0.2);
  CHECK((at(1e-12 * D).piola - 1e-12 * hooke(D)).norm() < 1e-10 * 1e-12 * hooke(D).norm());
}

TEST_CASE("ex22.5 held out: the tangent is symmetric", "[ex22.5]") {
  const StressResponse response = at(gradient(-0.3, -0.4, 0.6, 0.3, -0.2));
  CHECK((response.tangent - response.tangent.transpose()).norm() < 1e-12);
}

TEST_CASE("ex22.5 held out: a turn stores nothing and turns the stress", "[ex22.5]") {
  const double c = std::cos(1.1), s = std::sin(1.1);
  const StressResponse turn = at(gradient(c - 1, -s, s, c - 1, 0));
  CHECK(turn.piola.norm() < 1e-13);
  CHECK(std::abs(turn.energy) < 1e-13);
  const Components P = at(gradient(0.2, 0.3, -0.2, -0.1, 0.1)).piola;  // F = (1.2, .3; -.2, .9)
  const Components turned = at(gradient(c * 1.2 + s * 0.2 - 1, c * 0.3 - s * 0.9,
                                        s * 1.2 - c * 0.2, s * 0.3 + c * 0.9 - 1, 0.1))
                                .piola;
  const Components expected =
      gradient(c * P(0) - s * P(2), c * P(1) - s * P(3), s * P(0) + c * P(2), s * P(1) + c * P(3),
               P(4));
  CHECK((turned - expected).norm() < 1e-13 * P.norm());
}

TEST_CASE("ex22.5 held out: its name", "[ex22.5]") {
  CHECK(std::strcmp(quadratic_volume().name, "quadratic_volume") == 0);
}

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector4d;

namespace {

double wrong(const ex8_2::Pair& pair, const Vector4d& state) {
  return ex8_2::equations(pair, state).residual.cwiseAbs().maxCoeff();
}

}  // namespace

// d = -1 and s = 1 with compliances 1: f_n = 1 closes the pair, f_t would be -1 if it stuck.
TEST_CASE("ex8.2 a pair that slides forth has friction -B and no part that slides back",
          "[ex8.2][LinEtAl-10][LinEtAl-14][LinEtAl-16][LinEtAl-18][LinEtAl-19]") {
  const ex8_2::Pair pair{-1, 1, 1, 1, 0.5, 0};
  CHECK(wrong(pair, {1, -0.5, 0.5, 0}) < 1e-15);
  CHECK(wrong(pair, {1, 0.5, 1.5, 0}) > 0.1);    // friction along the slip
  CHECK(wrong(pair, {1, -0.6, 0.4, 0}) > 0.01);  // beyond the bound
}

TEST_CASE("ex8.2 a pair that slides back has friction B",
          "[ex8.2][LinEtAl-10][LinEtAl-13][LinEtAl-15][LinEtAl-17]") {
  CHECK(wrong({-1, -1, 1, 1, 0.5, 0}, {1, 0.5, 0, 0.5}) < 1e-15);
}

TEST_CASE("ex8.2 a pair sticks where that needs less than the bound, and more pressure holds more",
          "[ex8.2][LinEtAl-6][LinEtAl-8][LinEtAl-9]") {
  CHECK(wrong({-1, 0.4, 1, 1, 0.5, 0}, {1, -0.4, 0, 0}) < 1e-15);
  CHECK(wrong({-2, 0.9, 1, 1, 0.5, 0}, {2, -0.9, 0, 0}) < 1e-15);
  CHECK(wrong({-1, 0.9, 1, 1, 0.5, 0}, {1, -0.9, 0, 0}) > 0.01);
}

TEST_CASE("ex8.2 cohesion holds a closed pair and not an open one", "[ex8.2][LinEtAl-6]") {
  CHECK(wrong({-1, 0.6, 1, 1, 0.5, 0.2}, {1, -0.6, 0, 0}) < 1e-15);
  CHECK(wrong({1, 0.6, 1, 1, 0.5, 0.2}, {0, 0, 0.6, 0}) < 1e-15);
  CHECK(wrong({1, 0.6, 1, 1, 0.5, 0.2}, {0, -0.2, 0.4, 0}) > 0.01);
}

// Without friction a gap of 1/20 stays. The friction of 7/30 pulls it shut with H = 1/2, and holds it so.
TEST_CASE("ex8.2 friction closes a pair that is open without it", "[ex8.2]") {
  const ex8_2::Pair pair{0.05, 0.6, 1, 1, 0.5, 0.2, 0.5};
  CHECK(wrong(pair, {0, 0, 0.6, 0}) < 1e-15);
  CHECK(wrong(pair, {1.0 / 15, -7.0 / 30, 0.4, 0}) < 1e-15);
  CHECK(wrong({-0.05, 0.6, 1, 1, 0.5, 0.2, 0.5}, {0, 0, 0.6, 0}) > 0.01);  // overlaps
}

// f_n = 1/2 closes the gap of 1 with G_n = 2; f_t = -1/5 undoes the slip of 1/10 with G_t = 1/2.
TEST_CASE("ex8.2 compliances are not 1", "[ex8.2]") {
  CHECK(wrong({-1, 0.1, 2, 0.5, 0.5, 0}, {0.5, -0.2, 0, 0}) < 1e-15);
  CHECK(wrong({-1, 0.2, 2, 0.5, 0.5, 0}, {0.5, -0.25, 0.075, 0}) < 1e-15);  // the bound is 1/4
}

TEST_CASE("ex8.2 the Jacobian is that of the residuals", "[ex8.2]") {
  const ex8_2::Pair pair{-1, 0.3, 2, 0.5, 0.5, 0.2, 0.25};
  const Vector4d x(1.3, -0.4, 0.3, 0.1);  // closed, away from every kink
  const Eigen::Matrix4d J = ex8_2::equations(pair, x).jacobian;
  for (Eigen::Index j = 0; j < 4; ++j) {
    const Vector4d h = 1e-6 * Vector4d::Unit(j);
    const Vector4d rise =
        ex8_2::equations(pair, x + h).residual - ex8_2::equations(pair, x - h).residual;
    CAPTURE(j);
    CHECK(equal_within(rise / 2e-6, J.col(j), 1e-8));
  }
}

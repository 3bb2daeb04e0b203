#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_4;

namespace {

const Material rubber{2, 3};

Matrix2d matrix(double a, double b, double c, double d) {
  return (Matrix2d() << a, b, c, d).finished();
}

}  // namespace

TEST_CASE("ex22.4 a stretch along x", "[ex22.4]") {
  const Matrix2d P = stress(rubber, matrix(1.1, 0, 0, 1));
  CHECK(P(0, 0) == Approx(2 * (1.1 - 1 / 1.1) + 3 * std::log(1.1) / 1.1).epsilon(1e-13));
  CHECK(P(1, 1) == Approx(3 * std::log(1.1)).epsilon(1e-13));
  CHECK(P(0, 1) == Approx(0).margin(1e-15));
  CHECK(stress(rubber, Matrix2d::Identity()).norm() == Approx(0).margin(1e-15));
}

// The cube of a number: its central difference lacks h^2 of it, and no more.
TEST_CASE("ex22.4 differences of a function that is known", "[ex22.4]") {
  const auto cube = [](const Matrix2d& F) -> Matrix2d { return F.array().cube().matrix(); };
  const Matrix2d F = matrix(1.2, 0.3, -0.2, 0.9), D = matrix(1, -2, 0.5, 1);
  const Matrix2d exact = (3 * F.array().square() * D.array()).matrix();
  CHECK((by_differences(cube, F, D) - exact).norm() < 1e-8);
  CHECK((by_differences(cube, F, 1e-3 * D) - 1e-3 * exact).norm() < 1e-11);
}

TEST_CASE("ex22.4 by hand and by differences", "[ex22.4]") {
  const Matrix2d F = matrix(1.2, 0.3, -0.2, 0.9);
  const auto of = [](const Matrix2d& at) { return stress(rubber, at); };
  for (const Matrix2d& D : {matrix(1, 0, 0, 0), matrix(0, 1, 0, 0), matrix(0, 0, 1, 0),
                            matrix(0, 0, 0, 1), matrix(1, -2, 0.5, 3)}) {
    CHECK((tangent(rubber, F, D) - by_differences(of, F, D)).norm() < 1e-8 * D.norm());
    CHECK(tangent(rubber, F, D).norm() > 0.1);
  }
}

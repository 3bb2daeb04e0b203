#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_4;

namespace {

const Material stiff{7, 11};

Matrix2d matrix(double a, double b, double c, double d) {
  return (Matrix2d() << a, b, c, d).finished();
}

double product(const Matrix2d& A, const Matrix2d& B) { return A.cwiseProduct(B).sum(); }

}  // namespace

TEST_CASE("ex22.4 held out: at rest it is Hooke's law", "[ex22.4]") {
  const Matrix2d D = matrix(0.3, 1, -0.4, 0.8);
  const Matrix2d strain = (D + D.transpose()) / 2;
  const Matrix2d hooke = 2 * 7 * strain + 11 * strain.trace() * Matrix2d::Identity();
  CHECK((tangent(stiff, Matrix2d::Identity(), D) - hooke).norm() < 1e-13);
}

TEST_CASE("ex22.4 held out: the tangent is symmetric", "[ex22.4]") {
  const Matrix2d F = matrix(0.7, -0.4, 0.6, 1.3), A = matrix(1, 2, -1, 0.5), B = matrix(0, 1, 3, -2);
  CHECK(product(A, tangent(stiff, F, B)) == Approx(product(B, tangent(stiff, F, A))).epsilon(1e-12));
}

TEST_CASE("ex22.4 held out: a turn turns the stress", "[ex22.4]") {
  const Matrix2d Q = matrix(std::cos(1.1), -std::sin(1.1), std::sin(1.1), std::cos(1.1));
  const Matrix2d F = matrix(1.2, 0.3, -0.2, 0.9);
  CHECK((stress(stiff, Q * F) - Q * stress(stiff, F)).norm() < 1e-13);
  CHECK(stress(stiff, Q).norm() < 1e-13);
}

TEST_CASE("ex22.4 held out: directions of any size", "[ex22.4]") {
  const Matrix2d F = matrix(1.2, 0.3, -0.2, 0.9), D = matrix(1, -2, 0.5, 1);
  const auto of = [](const Matrix2d& at) { return stress(stiff, at); };
  for (const double size : {1e-6, 1.0, 1e3}) {
    CAPTURE(size);
    CHECK((by_differences(of, F, size * D) - size * tangent(stiff, F, D)).norm() <
          1e-7 * size);
  }
}

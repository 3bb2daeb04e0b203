#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::MatrixX2d;
using Eigen::VectorXd;
using ex14_4::Outline;
using ex14_4::pressures;

// The pressure pushes each side into the body, which is on the left; half of that goes to either end.
static MatrixX2d forces_of(double pressure, const MatrixX2d& position, Outline outline) {
  MatrixX2d force = MatrixX2d::Zero(position.rows(), 2);
  for (Index a = 0; a < position.rows(); ++a) {
    const Index b = (a + 1) % position.rows();
    if (b == 0 && outline == Outline::Open) break;
    const double dx = position(b, 0) - position(a, 0), dy = position(b, 1) - position(a, 1);
    for (const Index end : {a, b}) {
      force(end, 0) -= pressure * dy / 2;
      force(end, 1) += pressure * dx / 2;
    }
  }
  return force;
}

static void check_uniform(const MatrixX2d& position, Outline outline) {
  for (const double pressure : {44.3, -2.0}) {
    const VectorXd found = pressures(position, forces_of(pressure, position, outline), outline);
    REQUIRE(found.size() == position.rows());
    for (Index k = 0; k < found.size(); ++k) CHECK(found(k) == Approx(pressure).epsilon(1e-12));
  }
}

TEST_CASE("ex14.4 a straight outline is as it was", "[ex14.4]") {
  const MatrixX2d line = (MatrixX2d(4, 2) << 0, 0, 1, 0, 3, 0, 3.5, 0).finished();
  const MatrixX2d force = (MatrixX2d(4, 2) << 0, 1, 0, 3, 0, 5, 0, 0.5).finished();
  CHECK(equal_within(pressures(line, force, Outline::Open), Eigen::Vector4d(2, 2, 4, 2), 1e-13));
}

// Nine sides on a quarter: by the chords, 0.4 % are missing.
TEST_CASE("ex14.4 a uniform pressure on nine sides of the lining", "[ex14.4]") {
  MatrixX2d rim(10, 2);
  for (Index k = 0; k < 10; ++k) {
    const double angle = std::acos(0.0) * static_cast<double>(k) / 9;
    rim.row(k) << 68 * std::cos(angle), 68 * std::sin(angle);
  }
  check_uniform(rim, Outline::Open);
}

TEST_CASE("ex14.4 a uniform pressure on a trapezium", "[ex14.4]") {
  check_uniform((MatrixX2d(4, 2) << 0, 0, 3, 0, 2, 1, 0.5, 1).finished(), Outline::Closed);
}

TEST_CASE("ex14.4 what has no side has no pressure", "[ex14.4]") {
  CHECK_THROWS_AS(pressures(MatrixX2d::Zero(1, 2), MatrixX2d::Zero(1, 2), Outline::Open),
                  std::invalid_argument);
  CHECK_THROWS_AS(pressures(MatrixX2d::Zero(3, 2), MatrixX2d::Zero(2, 2), Outline::Closed),
                  std::invalid_argument);
}

#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

// u = (1, 2), held in row 1 by the force 3, 1/2 away from row 2.
signorini::DenseProgramme example() {
  const MatrixXd K = (MatrixXd(2, 2) << 2, 0, 0, 1).finished();
  return ex5_2::backwards(K, MatrixXd::Identity(2, 2), Vector2d(1, 2), Vector2d(3, 0),
                          Vector2d(0, 0.5));
}

}  // namespace

TEST_CASE("ex5.2 load and gaps make the chosen numbers a solution", "[ex5.2]") {
  const signorini::DenseProgramme made = example();
  CHECK(equal_within(made.load, Vector2d(5, 2), 1e-14));
  CHECK(equal_within(made.initial_gap, Vector2d(1, 2.5), 1e-14));
}

// f* = 1 + 2 - 5 - 4 = -6.
TEST_CASE("ex5.2 at the solution both bounds meet", "[ex5.2]") {
  const ex5_2::Enclosure bounds = ex5_2::enclose(example(), Vector2d(1, 2), Vector2d(3, 0));
  CHECK(bounds.lower == Approx(-6).epsilon(1e-13));
  CHECK(bounds.upper == Approx(-6).epsilon(1e-13));
}

// No force: the energy without contact, -25/4 - 2. No displacement: the energy 0.
TEST_CASE("ex5.2 two bounds for nothing", "[ex5.2]") {
  const ex5_2::Enclosure bounds = ex5_2::enclose(example(), Vector2d(0, 0), Vector2d(0, 0));
  CHECK(bounds.lower == Approx(-8.25).epsilon(1e-13));
  CHECK(bounds.upper == Approx(0).margin(1e-13));
}

TEST_CASE("ex5.2 displacements that overlap bound nothing", "[ex5.2]") {
  const ex5_2::Enclosure bounds = ex5_2::enclose(example(), Vector2d(1.1, 2), Vector2d(3, 0));
  CHECK(bounds.upper == HUGE_VAL);
  CHECK(bounds.lower == Approx(-6).epsilon(1e-13));
}

TEST_CASE("ex5.2 a force that pulls is no force", "[ex5.2]") {
  const ex5_2::Enclosure bounds = ex5_2::enclose(example(), Vector2d(1, 2), Vector2d(3, -2));
  CHECK(bounds.lower == Approx(-6).epsilon(1e-13));
}

#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "support/equal_within.hpp"

using namespace ex5_6;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

static Loaded carts() {
  return {(Matrix3d() << 1, 1, 1, 1, 2, 2, 1, 2, 3).finished(), Vector3d(2, 7, 9),
          Vector3d(1, 2, 3)};
}

static Loaded two() {
  return {(Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(1, 4), Vector2d(1, 3)};
}

TEST_CASE("ex5.6 three carts, pulled more and more", "[ex5.6]") {
  const Path path = load_path(carts(), 4);
  REQUIRE(path.events.size() == 2);
  CHECK(path.events[0].load == Approx(2).epsilon(1e-14));
  CHECK(path.events[0].pair == 0);
  CHECK(path.events[1].load == Approx(3.5).epsilon(1e-14));
  CHECK(path.events[1].pair == 2);
  CHECK(path.events[0].closes);
  CHECK(path.events[1].closes);
  CHECK(equal_within(path.force, Vector3d(1.5, 0, 0.5), 1e-13));
}

TEST_CASE("ex5.6 a pair that opens again", "[ex5.6]") {
  const Path path = load_path(two(), 3);
  REQUIRE(path.events.size() == 3);
  CHECK(path.events[1].load == Approx(1.4).epsilon(1e-14));
  CHECK(path.events[2].load == Approx(2).epsilon(1e-14));
  CHECK(path.events[2].pair == 0);
  CHECK_FALSE(path.events[2].closes);
  CHECK(equal_within(path.force, Vector2d(0, 2.5), 1e-13));
}

TEST_CASE("ex5.6 before the first pair closes there is no force", "[ex5.6]") {
  const Path path = load_path(carts(), 1.9);
  CHECK(path.events.size() == 0);
  CHECK(path.force.isZero(0));
}

TEST_CASE("ex5.6 what cannot be meant is refused", "[ex5.6]") {
  Loaded body = two();
  body.initial_gap(1) = 0;
  CHECK_THROWS_AS(load_path(body, 1), std::invalid_argument);
  body.initial_gap = Vector3d(1, 1, 1);
  CHECK_THROWS_AS(load_path(body, 1), std::invalid_argument);
}

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_3;

namespace {

Problem bowl(double weight) {
  return {Matrix2d::Identity(), {0, -weight}, {0.3, -0.9}, {0, 0}, 1, true};
}

Problem hill(double weight) {
  return {Matrix2d::Identity(), {0, -weight}, {0, 1}, {0, 0}, 1, false};
}

}  // namespace

TEST_CASE("ex22.3 the bowl, with the turning of the normal and without", "[ex22.3]") {
  State end;
  CHECK(iterations(bowl(0.5), true, 100, end) == 5);
  CHECK((bowl(0.5).rest + end.u).norm() == Approx(1).epsilon(1e-14));
  State frozen;
  CHECK(iterations(bowl(0.5), false, 100, frozen) == 32);
  CHECK((frozen.u - end.u).norm() < 1e-11);
  CHECK(frozen.force == Approx(end.force).epsilon(1e-11));
}

TEST_CASE("ex22.3 a steeper bowl is not found with a frozen normal", "[ex22.3]") {
  State end;
  CHECK(iterations(bowl(1.5), true, 100, end) < 10);
  CHECK(iterations(bowl(1.5), false, 100, end) == 101);
}

TEST_CASE("ex22.3 a node falls off a hill from k r on", "[ex22.3]") {
  CHECK(stays(hill(0.9), {{0, 0}, 0.9}));
  CHECK_FALSE(stays(hill(1.1), {{0, 0}, 1.1}));
  CHECK(stays(bowl(1.5), {{-0.3, -0.1}, 1.5}));
}

#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex22_3;

TEST_CASE("ex22.3 held out: a node that is pulled off has no force", "[ex22.3]") {
  const Problem away{2 * Matrix2d::Identity(), {0, 1}, {0, -0.5}, {0, 0}, 1, true};
  const State end = next(away, {{0, 0}, 0}, true);
  CHECK(end.force == 0);
  CHECK((end.u - Vector2d(0, 0.5)).norm() < 1e-15);
}

// The balance at the end, on a surface elsewhere, of another size and with springs that differ.
TEST_CASE("ex22.3 held out: forces balance where the loop ends", "[ex22.3]") {
  Matrix2d K;
  K << 5, 1, 1, 3;
  for (const bool inside : {true, false}) {
    CAPTURE(inside);
    const Problem problem{K, {inside ? 6.0 : -6.0, 0.3}, {4.5 + (inside ? 0 : 1), 1.2}, {3, 1}, 2, inside};
    State end;
    REQUIRE(iterations(problem, true, 50, end) <= 10);
    REQUIRE(end.force > 0);
    const Vector2d arm = problem.rest + end.u - problem.middle;
    CHECK(arm.norm() == Approx(2).epsilon(1e-12));
    const Vector2d n = (inside ? -1 : 1) * arm.normalized();
    CHECK((K * end.u - problem.load - end.force * n).norm() < 1e-10);
  }
}

TEST_CASE("ex22.3 held out: springs along the surface hold", "[ex22.3]") {
  Matrix2d K = Vector2d(3, 1).asDiagonal();
  const Problem top{K, {0, -2}, {0, 4}, {0, 2}, 2, false};
  CHECK(stays(top, {{0, 0}, 5.9}));  // k r = 6
  CHECK_FALSE(stays(top, {{0, 0}, 6.1}));
}

TEST_CASE("ex22.3 held out: the last error of a turning normal is the square of the one before",
          "[ex22.3]") {
  const Problem problem{Matrix2d::Identity(), {0, -0.5}, {0.3, -0.9}, {0, 0}, 1, true};
  State end;
  static_cast<void>(iterations(problem, true, 100, end));
  State now{Vector2d::Zero(), 0};
  double last = 1;
  for (int k = 0; k < 4; ++k) {
    now = next(problem, now, true);
    const double error = (now.u - end.u).norm();
    if (k > 0) CHECK(error <= 2 * last * last + 1e-14);
    last = error;
  }
}

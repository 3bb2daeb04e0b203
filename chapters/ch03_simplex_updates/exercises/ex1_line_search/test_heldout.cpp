#include <algorithm>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"

namespace {

double s(const ex3_1::Line& line, double t) {
  const double overlap = std::max(0.0, line.b0 + line.b1 * t);
  return 0.5 * overlap * overlap / (line.c0 + 2 * line.c1 * t + line.c2 * t * t);
}

ex3_1::Line random_line(signorini::Random& random) {  // c from two vectors in the plane
  const double x1 = random.uniform(-1, 1);
  const double x2 = random.uniform(0.1, 1);
  const double y1 = random.uniform(-1, 1);
  const double y2 = random.uniform(-1, 1);
  return {random.uniform(0.1, 2), random.uniform(-2, 2), x1 * x1 + x2 * x2, x1 * y1 + x2 * y2,
          y1 * y1 + y2 * y2};
}

}  // namespace

TEST_CASE("ex3.1 held out: no other step gains more", "[ex3.1]") {
  signorini::Random random(1);
  int inside = 0;
  for (int sample = 0; sample < 500; ++sample) {
    const ex3_1::Line line = random_line(random);
    const double largest = random.uniform(0.1, 3);
    const double t = ex3_1::best_step(line, largest);
    CAPTURE(sample, t, largest);
    REQUIRE(t >= 0);
    REQUIRE(t <= largest);
    inside += t > 0 && t < largest ? 1 : 0;
    double best = 0;
    for (int k = 0; k <= 500; ++k) best = std::max(best, s(line, largest * k / 500));
    CHECK(s(line, t) >= best * (1 - 1e-12));
  }
  CHECK(inside > 100);
}

TEST_CASE("ex3.1 held out: units of length and force do not change the step", "[ex3.1]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 100; ++sample) {
    const ex3_1::Line line = random_line(random);
    const double L = 0x1p-30;  // powers of two: no rounding
    const double C = 0x1p20;
    const ex3_1::Line other{line.b0 * L, line.b1 * L, line.c0 * C, line.c1 * C, line.c2 * C};
    CHECK(ex3_1::best_step(other, 1) == ex3_1::best_step(line, 1));
  }
}

TEST_CASE("ex3.1 held out: from the best point no further step", "[ex3.1]") {
  signorini::Random random(3);
  for (int sample = 0; sample < 100; ++sample) {
    const ex3_1::Line line = random_line(random);
    const double t = ex3_1::best_step(line, 1);
    if (t == 0 || t == 1) continue;
    const ex3_1::Line there{line.b0 + line.b1 * t, line.b1,
                            line.c0 + 2 * line.c1 * t + line.c2 * t * t, line.c1 + line.c2 * t,
                            line.c2};
    CHECK(ex3_1::best_step(there, 1) <= 1e-12);
  }
}

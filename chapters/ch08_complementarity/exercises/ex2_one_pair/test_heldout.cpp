#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using Eigen::Vector4d;

namespace {

ex8_2::Pair random_pair(signorini::Random& random) {
  ex8_2::Pair pair{random.uniform(-1, 1),  random.uniform(-2, 2),  random.uniform(0.5, 2),
                   random.uniform(0.5, 2), random.uniform(0.1, 1), random.uniform(0.1, 0.3)};
  pair.coupling =
      random.uniform(-0.5, 0.5) * std::sqrt(pair.normal_compliance * pair.tangential_compliance);
  return pair;
}

struct Solved {
  ex8_2::Pair pair;
  Vector4d solution;
};

// Forces and slip first, then the pair that has them: `kind` 0 sticks, 1 slides forth, -1 back.
Solved random_closed(signorini::Random& random, int kind) {
  ex8_2::Pair pair = random_pair(random);
  const double fn = random.uniform(0.1, 1), bound = pair.cohesion + pair.mu * fn;
  const double ft = kind == 0 ? random.uniform(-0.9, 0.9) * bound : -kind * bound;
  const double slip = kind * random.uniform(0.1, 2);
  pair.free_gap = -pair.normal_compliance * fn - pair.coupling * ft;
  pair.free_slip = slip - pair.coupling * fn - pair.tangential_compliance * ft;
  return {pair, {fn, ft, std::max(slip, 0.0), std::max(-slip, 0.0)}};
}

}  // namespace

TEST_CASE("ex8.2 held out: the Jacobian agrees with central differences", "[ex8.2]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 100; ++sample) {
    const ex8_2::Pair pair = random_pair(random);
    Vector4d x;
    for (double& number : x) number = random.uniform(0.1, 1);
    CAPTURE(sample);
    const Eigen::Matrix4d J = ex8_2::equations(pair, x).jacobian;
    for (Eigen::Index j = 0; j < 4; ++j) {
      const Vector4d h = 1e-6 * Vector4d::Unit(j);
      const Vector4d rise =
          ex8_2::equations(pair, x + h).residual - ex8_2::equations(pair, x - h).residual;
      // Differences of the root are wrong by h^2 over the square of its size, which is at least 0.05.
      CHECK(equal_within(rise / 2e-6, J.col(j), 1e-7));
    }
  }
}

TEST_CASE("ex8.2 held out: Newton's method ends at the solution of a closed pair", "[ex8.2]") {
  signorini::Random random(2);
  for (int sample = 0; sample < 200; ++sample) {
    const auto [pair, expected] = random_closed(random, sample % 3 - 1);
    CAPTURE(sample);
    CHECK(ex8_2::equations(pair, expected).residual.norm() < 1e-14);
    Vector4d x = expected + Vector4d::Constant(0.01);
    for (int step = 0; step < 20; ++step) {
      const ex8_2::System at = ex8_2::equations(pair, x);
      x -= signorini::LuFactor(at.jacobian).solve(at.residual);
    }
    CHECK(equal_within(x, expected, 1e-12));
  }
}

// On the way to the solution too, where a force may still pull: cohesion adds c to the bound, as a larger coefficient would.
TEST_CASE("ex8.2 held out: cohesion acts where the force exceeds the gap and nowhere else",
          "[ex8.2]") {
  signorini::Random random(4);
  int closed = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const ex8_2::Pair pair = random_pair(random);
    const Vector4d x(random.uniform(0.1, 1) * (sample % 2 == 0 ? 1 : -1), random.uniform(-1, 1),
                     0.3, 0.1);
    const double force = pair.normal_compliance * x(0);
    const double gap = pair.free_gap + force + pair.coupling * x(1);
    ex8_2::Pair same = pair;
    same.cohesion = 0;
    if (force > gap) same.mu += pair.cohesion / x(0);
    closed += force > gap ? 1 : 0;
    CAPTURE(sample, force, gap);
    CHECK(equal_within(ex8_2::equations(pair, x).residual, ex8_2::equations(same, x).residual,
                       1e-14));
  }
  CHECK(closed > 50);
  CHECK(closed < 150);
}

TEST_CASE("ex8.2 held out: residuals are lengths, in any units", "[ex8.2][units]") {
  signorini::Random random(3);
  const double length = 1.0 / 1024, force = 4096;  // powers of two hardly round
  for (int sample = 0; sample < 50; ++sample) {
    const ex8_2::Pair p = random_pair(random);
    const ex8_2::Pair q{p.free_gap * length,
                        p.free_slip * length,
                        p.normal_compliance * length / force,
                        p.tangential_compliance * length / force,
                        p.mu,
                        p.cohesion * force,
                        p.coupling * length / force};
    const Vector4d x(0.7, -0.2, 0.3, 0.1);
    const Vector4d y(x(0) * force, x(1) * force, x(2) * length, x(3) * length);
    CAPTURE(sample);
    CHECK(equal_within(ex8_2::equations(q, y).residual / length, ex8_2::equations(p, x).residual,
                       1e-15));
  }
}

#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "support/equal_within.hpp"

using namespace ex10_5;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

Edges random_edges(signorini::Random& random) {
  const auto point = [&random](double y) {
    return Vector2d(random.uniform(-1, 2), y + random.uniform(-0.2, 0.2));
  };
  const Vector2d place(random.uniform(-2, 2), random.uniform(-2, 2));
  return {place, place + Vector2d(1, random.uniform(-0.3, 0.3)), place + point(-0.5),
          place + point(-0.5)};
}

// By many small steps along the edge.
Segment summed(const Edges& edges) {
  Segment sum;
  const Vector2d along = edges.b - edges.a, n = Vector2d(along.y(), -along.x()).normalized();
  const int steps = 20000;
  for (int k = 0; k < steps; ++k) {
    const double s = (2 * k + 1.0) / steps - 1;
    const Vector2d x = edges.a + (1 + s) / 2 * along;
    const double r = (x - edges.c).dot(along) / (edges.d - edges.c).dot(along);
    if (r < 0 || r > 1) continue;
    const Vector2d psi((1 - 3 * s) / 2, (1 + 3 * s) / 2), N(1 - r, r);
    const Vector2d faced = N(0) * edges.c + N(1) * edges.d;
    sum.D += along.norm() / steps * psi;
    sum.M += along.norm() / steps * psi * N.transpose();
    sum.gap += along.norm() / steps * (faced - x).dot(n) * psi;
  }
  return sum;
}

}  // namespace

TEST_CASE("ex10.5 held out: the integrals of many small steps", "[ex10.5]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 30; ++sample) {
    const Edges edges = random_edges(random);
    const Segment exact = mortar_segment(edges), near = summed(edges);
    CAPTURE(sample);
    CHECK(equal_within(exact.D, near.D, 1e-3));
    CHECK(equal_within(exact.M, near.M, 1e-3));
    CHECK(equal_within(exact.gap, near.gap, 1e-3));
    CHECK(equal_within(exact.M.rowwise().sum(), exact.D, 1e-13));  // the N_j have the sum 1
  }
}

TEST_CASE("ex10.5 held out: turned, enlarged, and with the target the other way round",
          "[ex10.5]") {
  signorini::Random random(2);
  const double turn = 1.1;
  const Matrix2d R =
      2 *
      (Matrix2d() << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn)).finished();
  for (int sample = 0; sample < 30; ++sample) {
    const Edges edges = random_edges(random);
    const Segment here = mortar_segment(edges);
    const Segment there = mortar_segment({R * edges.a, R * edges.b, R * edges.c, R * edges.d});
    const Segment other = mortar_segment({edges.a, edges.b, edges.d, edges.c});
    CAPTURE(sample);
    CHECK(equal_within(there.M, 2 * here.M, 1e-12));
    CHECK(equal_within(there.gap, 4 * here.gap, 1e-12));
    CHECK(equal_within(other.M.rowwise().reverse(), here.M, 1e-12));
    CHECK(other.from == Approx(here.from).margin(1e-14));
  }
}

TEST_CASE("ex10.5 held out: an edge along the normal faces nothing", "[ex10.5]") {
  const Segment none = mortar_segment({{0, 0}, {1, 0}, {0.5, -1}, {0.5, -2}});
  CHECK(none.D.norm() == 0);
  CHECK(none.M.norm() == 0);
}

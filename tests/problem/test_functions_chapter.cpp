// What chapter 8 says of its complementarity functions and of one pair with friction.
#include <algorithm>
#include <cmath>

#include "../chapters/ch08_complementarity/functions.hpp"
#include "../chapters/ch08_complementarity/laws.hpp"
#include "../chapters/ch08_complementarity/one_pair.hpp"
#include "../chapters/ch08_complementarity/semismooth.hpp"
#include "catch_compat.hpp"
#include "signorini/core/random.hpp"
#include "signorini/fem/stress.hpp"

using namespace signorini;
using Eigen::Vector2d;
using Eigen::Vector4d;
using Eigen::VectorXd;

TEST_CASE("every complementarity function is zero on the two half-axes and nowhere else",
          "[functions][LinEtAl-12][exact]") {
  for (const ComplementarityFunction& phi : functions)
    for (double a = -2; a <= 2; a += 0.25)
      for (double b = -2; b <= 2; b += 0.25) {
        CAPTURE(phi.name, a, b);
        CHECK((std::abs(phi.value(a, b)) < 1e-15) == (std::min(a, b) == 0));
        CHECK(phi.value(a, b) * std::min(a, b) <= 0);  // negative where both are positive
      }
}

TEST_CASE("the slopes of the complementarity functions are their derivatives", "[functions]") {
  const double h = 1e-6;
  for (const ComplementarityFunction& phi : functions)
    for (const Vector2d& at : {Vector2d(3, 4), Vector2d(-1, 0.5), Vector2d(0.2, -2),
                               Vector2d(-0.3, -0.7), Vector2d(2, 1e-3)}) {
      const double a = at(0), b = at(1);
      const ComplementaritySlope slope = phi.slope(a, b);
      CAPTURE(phi.name, a, b);
      CHECK(slope.a == Approx((phi.value(a + h, b) - phi.value(a - h, b)) / (2 * h)).margin(1e-8));
      CHECK(slope.b == Approx((phi.value(a, b + h) - phi.value(a, b - h)) / (2 * h)).margin(1e-8));
    }
}

TEST_CASE("the split and the one equation of a pair agree, whatever the parts of the slip",
          "[friction][LinEtAl-17][LinEtAl-18][LinEtAl-19]") {
  for (const NamedPair& on : one_pairs)
    for (const double parts : {0.0, 1.0}) {
      CAPTURE(on.name, parts);
      const VectorXd two = solved(split, on.pair, Vector4d(1, 0, parts, parts)).x;
      const VectorXd one = solved(one_equation, on.pair, Vector2d(1, 0)).x;
      CHECK((two.head(2) - one).norm() < 1e-10);
      CHECK(two(2) - two(3) == Approx(on.pair.free_slip + one(1)).margin(1e-10));
    }
}

TEST_CASE("the Jacobians of a pair with friction are those of its residuals", "[friction]") {
  const OnePair pair{-1, 0.3, 0.5, 0.2};
  const auto check = [&pair](auto equations, const VectorXd& x) {
    const System at = equations(pair, x);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      const VectorXd h = 1e-6 * VectorXd::Unit(x.size(), j);
      const VectorXd rise = equations(pair, x + h).residual - equations(pair, x - h).residual;
      CAPTURE(j);
      CHECK((rise / 2e-6 - at.jacobian.col(j)).norm() < 1e-8);
    }
  };
  check(split, Vector4d(1.3, -0.4, 0.3, 0.1));
  check(one_equation, Vector2d(1.3, -0.4));
}

TEST_CASE("the gap is what it was and what the displacements open along the normal of b",
          "[LinEtAl-1][exact]") {
  const FacingPoints at{{1, 3}, {1, 1}, {0.5, -0.5}, {-0.25, 0.25}, {0, 1}};
  CHECK(gap_of(at) == 2 - 0.75);
}

TEST_CASE("apart, pressed, or touching: of gap and pressure none is negative and one is zero",
          "[LinEtAl-2][LinEtAl-3][LinEtAl-4][LinEtAl-11][exact]") {
  CHECK(normal_case(1, 0) == NormalCase::Apart);
  CHECK(normal_case(0, -1) == NormalCase::Pressed);
  CHECK(normal_case(0, 0) == NormalCase::Touching);
  for (const double gap : {-1.0, 0.0, 1.0})
    for (const double sigma_n : {-1.0, 0.0, 1.0}) {
      CAPTURE(gap, sigma_n);
      const bool complementary = gap >= 0 && -sigma_n >= 0 && gap * sigma_n == 0;  // (11)
      CHECK((normal_case(gap, sigma_n) != NormalCase::Forbidden) == complementary);
      CHECK((fischer_burmeister(gap, -sigma_n) == 0) == complementary);  // (12)
    }
}

TEST_CASE("normal stress and shear of a face, by hand", "[LinEtAl-5][LinEtAl-7]") {
  const Vector2d n(0.6, -0.8);
  const Traction on = traction(Eigen::Vector3d(-2, -6, 1), n);
  CHECK(on.normal == Approx(-5.52).epsilon(1e-14));
  CHECK(on.tangential.norm() == Approx(1.64).epsilon(1e-13));
  CHECK(std::abs(on.tangential.dot(n)) < 1e-14);
}

TEST_CASE("a pair sticks below the bound and slides at it",
          "[LinEtAl-6][LinEtAl-8][LinEtAl-9]"
          "[LinEtAl-10][exact]") {
  CHECK(shear_bound(0.5, 0.25, -2) == 1);  // pressure raises the bound
  CHECK(shear_bound(0.5, 0.25, 0) == 0.5);
  CHECK(tangential_case(0.5, 0, 1) == TangentialCase::Sticks);
  CHECK(tangential_case(1, 0, 1) == TangentialCase::Sticks);
  CHECK(tangential_case(1, 3, 1) == TangentialCase::Slides);
  CHECK(tangential_case(0.5, 3, 1) == TangentialCase::Forbidden);
  CHECK(tangential_case(2, 0, 1) == TangentialCase::Forbidden);
}

TEST_CASE("friction is against the slip, and two parts of the slip say the same",
          "[LinEtAl-13][LinEtAl-14][LinEtAl-15][LinEtAl-16][exact]") {
  for (const double bound : {0.0, 1.0, 2.0})
    for (const double shear : {-2.0, -1.0, 0.0, 1.0, 2.0})
      for (const double slip : {-1.0, 0.0, 1.0}) {
        CAPTURE(bound, shear, slip);
        const double plus = std::max(slip, 0.0), minus = std::max(-slip, 0.0);
        CHECK(coulomb_holds(shear, slip, bound) == split_holds(shear, plus, minus, bound));
      }
  CHECK(coulomb_holds(-1, 1, 1));  // slides forth, dragged back
  CHECK_FALSE(coulomb_holds(1, 1, 1));
  CHECK(split_holds(0, 5, 5, 0));  // without a bound both parts may grow
}

TEST_CASE("the active set takes the steps of Newton's method with the minimum",
          "[functions][LinEtAl-11]") {
  const ContactProblem two{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-3, -1)};
  const SetRun way = semismooth(two, 1, Vector2d(0, 0));
  REQUIRE(way.ended);
  CHECK(way.sets == std::vector<std::vector<Eigen::Index>>{{0, 1}, {0}, {0}});
  CHECK((way.force - Vector2d(1.5, 0)).norm() < 1e-15);
  Random random(1);
  for (int sample = 0; sample < 200; ++sample) {
    const Eigen::Index n = random.whole(1, 6);
    Eigen::MatrixXd B(n, n);
    for (double& b : B.reshaped()) b = random.uniform(-1, 1);
    ContactProblem problem{B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n), VectorXd(n)};
    for (double& d : problem.free_gap) d = random.uniform(-2, 1);
    const SetRun sets = semismooth(problem, 1, 0 * problem.free_gap);
    const NewtonRun steps = newton(problem, functions[1], 0 * problem.free_gap, {1e-11, 0});
    CAPTURE(sample, n);
    CHECK(sets.ended == steps.ended);
    if (!sets.ended) continue;
    CHECK((sets.force - steps.forces.back()).norm() < 1e-9);
    CHECK(sets.sets.size() - 1 == std::max<std::size_t>(1, steps.steps()));
  }
}

TEST_CASE("from near a solution one step arrives, also where a pair touches without force",
          "[functions][LinEtAl-11]") {
  const ContactProblem touching{(Eigen::Matrix2d() << 2, 1, 1, 2).finished(), Vector2d(-2, -1)};
  Random random(2);
  for (int sample = 0; sample < 100; ++sample) {
    const Vector2d near(1 + random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
    const SetRun way = semismooth(touching, 1, near);
    REQUIRE(way.ended);
    for (const std::vector<Eigen::Index>& set : way.sets) {
      const bool first = !set.empty() && set[0] == 0;
      CHECK(first);
    }
    CHECK((way.force - Vector2d(1, 0)).norm() < 1e-14);
  }
}

TEST_CASE("the return map is Coulomb's law: its fixed points are where the law holds",
          "[friction]") {
  for (const double bound : {0.0, 1.0, 2.0})
    for (const double friction : {-2.0, -1.0, 0.0, 1.0, 2.0})
      for (const double slip : {-1.0, 0.0, 1.0}) {
        CAPTURE(bound, friction, slip);
        CHECK((returned(friction - 3 * slip, bound) == friction) ==
              coulomb_holds(friction, slip, bound));
      }
}

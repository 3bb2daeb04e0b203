// What chapter 8 says of its complementarity functions and of one pair with friction.
#include <algorithm>
#include <cmath>

#include "../chapters/ch08_complementarity/functions.hpp"
#include "../chapters/ch08_complementarity/one_pair.hpp"
#include "catch_compat.hpp"

using namespace signorini;
using Eigen::Vector2d;
using Eigen::Vector4d;
using Eigen::VectorXd;

TEST_CASE("every complementarity function is zero on the two half-axes and nowhere else",
          "[functions][exact]") {
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
          "[friction]") {
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

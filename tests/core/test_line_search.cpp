#include "catch_compat.hpp"
#include "signorini/core/line_search.hpp"

using namespace signorini;

TEST_CASE("a step goes as far as the merit falls by a part of what its slope promises",
          "[line_search]") {
  double last = 0;
  const auto ends = [&](double root) {  // m(t) = (1 - root t)^2, with the slope -2 root
    return armijo(1, -2 * root, [&](double t) {
      last = t;
      return (1 - root * t) * (1 - root * t);
    });
  };
  CHECK(ends(1) == 1);     // the full step of a linear equation
  CHECK(ends(1.9) == 1);   // to the other side, but lower
  CHECK(ends(2) == 0.5);   // as high as before is not lower
  CHECK(ends(4) == 0.25);  // 9, 1 and then 0
  CHECK(last == 0.25);     // where the last look was
  CHECK(armijo(1, -1, [](double t) { return 1 + t; }) == 0);
  // Lower, but by less than the ten-thousandth part of the promise.
  CHECK(armijo(1, -1, [](double t) { return 1 - 0.5e-4 * t; }) == 0);
}

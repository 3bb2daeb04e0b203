#include <cmath>
#include <stdexcept>

#include "../chapters/ch13_strip_footing/base.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex13_4;

TEST_CASE("ex13.4 columns whose fate is known", "[ex13.4]") {
  const Trend half = trend_of({9, 5, 3, 2});  // steps 4, 2, 1
  CHECK(half.fate == Fate::Converges);
  CHECK(half.order == Approx(1).epsilon(1e-14));
  CHECK(half.limit == Approx(1).epsilon(1e-14));
  const Trend doubled = trend_of({1, 2, 4, 8});
  CHECK(doubled.fate == Fate::Grows);
  CHECK(doubled.power == Approx(1).epsilon(1e-14));
  CHECK(trend_of({1, 2, 1, 2}).fate == Fate::Unclear);
  CHECK_THROWS_AS(trend_of({1, 2}), std::invalid_argument);
}

// The table of the edge, without its last and dearest row.
TEST_CASE("ex13.4 the edge of the rigid footing: the force has a limit, the pressure has none",
          "[ex13.4]") {
  std::vector<double> worst, force, pressure;
  for (const Eigen::Index k : {1, 2, 4}) {
    const ch13::Base base = ch13::rigid_base(ch13::soil_of(8 * k, 10 * k, 9 * k, 4, 60));
    const Eigen::Index corner = base.force.size() - 1;
    worst.push_back(100 * base.worst());
    force.push_back(100 * base.deviation()(corner));
    pressure.push_back(base.pressure()(corner) / ch13::q);
  }
  CHECK(trend_of(worst).fate == Fate::Converges);
  CHECK(trend_of(force).fate == Fate::Converges);
  CHECK(trend_of(force).limit == Approx(17.15).margin(0.1));
  CHECK(trend_of(pressure).fate == Fate::Grows);
  CHECK(trend_of(pressure).power == Approx(0.5).margin(0.02));  // the pressure goes as 1/sqrt(r)
}

TEST_CASE("ex13.4 steps that change their sign, and steps that are over", "[ex13.4]") {
  const Trend swings = trend_of({0, 2, 1});  // steps 2, -1, then 1/2, -1/4, ...
  CHECK(swings.fate == Fate::Converges);
  CHECK(swings.order == Approx(1).epsilon(1e-14));
  CHECK(swings.limit == Approx(4.0 / 3).epsilon(1e-14));
  CHECK(trend_of({3, 2, 2}).limit == 2);
  CHECK(trend_of({3, 2, 2}).order == HUGE_VAL);
  CHECK(trend_of({0, -1, -3}).fate == Fate::Grows);  // away from zero, downwards
}

#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

// Every second row of the penalty in figure 19.2.
TEST_CASE("ex19.3 the penalty of figure 19.2", "[ex19.3]") {
  const ex19_3::Reading mine = ex19_3::read_sweep({{0.1, 0.6651, 603.7},
                                                   {0.3162, 0.3977, 604.5},
                                                   {1, 0.2024, 602.6},
                                                   {3.162, 0.1344, 626.0},
                                                   {10, 0.1238, 1325},
                                                   {31.62, 0.1230, 3791},
                                                   {100, 0.1231, 11637},
                                                   {1000, 0.1231, 114973},
                                                   {10000, 0.1231, 1148350}});
  CHECK(mine.floor == 0.1230);
  CHECK(mine.enough == 3.162);
  CHECK(mine.order == Approx(1.0).margin(0.002));
}

TEST_CASE("ex19.3 an error that does not depend on the parameter", "[ex19.3]") {
  const ex19_3::Reading mine = ex19_3::read_sweep({{1, 0.5, 10}, {2, 0.5, 10}, {4, 0.5, 10}});
  CHECK(mine.enough == 1);
  CHECK(mine.order == 0);
}

TEST_CASE("ex19.3 parameters must increase", "[ex19.3]") {
  CHECK_THROWS_AS(ex19_3::read_sweep({{2, 0.5, 10}, {1, 0.5, 10}}), std::invalid_argument);
}

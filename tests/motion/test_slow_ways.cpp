// Iterations that hardly come closer, by series whose sums are known.
#include "addons/motion/slow_ways.hpp"
#include "catch_compat.hpp"
#include "support/random_outcomes.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Vector2d;

namespace {

const std::vector<ContactStatus> same = {ContactStatus::Stick, ContactStatus::Open};

/// How many ways it takes from 1 to 1e-12, if an iteration leaves of each component a share.
int ways_to_end(const Vector2d& left) {
  SlowWays ways;
  Vector2d error(1, 0.3);
  int count = 0;
  for (; error.norm() > 1e-12 && count < 1000; ++count) {
    const Vector2d way = left.cwiseProduct(error) - error;
    const double share = ways.share(way, same);
    ways.gone(way, same, share);
    error += share * way;
  }
  return count;
}

}  // namespace

TEST_CASE("ways that shrink slowly, or swing, come to their end", "[motion]") {
  // Of one number, or of two that shrink alike, the series is exact: the fourth way ends at its sum, but for rounding.
  CHECK(ways_to_end({0.95, 0.95}) <= 6);
  CHECK(ways_to_end({-0.95, -0.95}) <= 6);
  // All of each way would take 539 of them.
  CHECK(ways_to_end({-0.95, 0.3}) <= 60);
  // Nothing is changed where all is well: 1e-12 is half to the power of 40.
  CHECK(ways_to_end({0.5, 0.1}) == 40);
}

TEST_CASE("all of a way is gone if pairs change, and if ways grow along themselves", "[motion]") {
  SlowWays ways;
  const Vector2d way(1, 2);
  CHECK(ways.share(way, same) == 1);
  ways.gone(way, same, 1);
  CHECK(ways.share(-0.9 * way, same) == 1);  // as yet
  for (int k = 0; k < 2; ++k) ways.gone(way, same, 1);
  CHECK(ways.share(-0.9 * way, same) == 1 / 1.9);
  CHECK(ways.share(-0.9 * way, {ContactStatus::Stick, ContactStatus::Stick}) == 1);
  CHECK(ways.share(0.4 * way, same) == 1);
  CHECK(ways.share(1.1 * way, same) == 1);
}

// It ended after 60 iterations that each left nine tenths.
TEST_CASE("a block of rubber that slides with much friction is solved", "[motion]") {
  CHECK(try_scene(548, RandomScenes::Moving).outcome == Outcome::Solved);
}

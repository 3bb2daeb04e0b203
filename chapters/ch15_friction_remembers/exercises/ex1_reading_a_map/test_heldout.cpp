#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex15_1;
using signorini::ContactStatus;

constexpr ContactStatus o = ContactStatus::Open, k = ContactStatus::Stick,
                        f = ContactStatus::SlipForward, b = ContactStatus::SlipBackward;

TEST_CASE("ex15.1 held out: a pair that opens does not say that a push has turned", "[ex15.1]") {
  const Map map{Eigen::Vector3d(0, 1, 2), {{f, k, b}, {o, f, o}, {f, f, k}}};
  CHECK(turns(map) == decltype(turns(map)){});
}

TEST_CASE("ex15.1 held out: sliding the other way at once is a turn", "[ex15.1]") {
  const Map map{Eigen::Vector3d(0, 1, 2), {{k, k, f}, {k, f, b}, {b, k, b}, {f, k, b}}};
  CHECK(turns(map) == std::vector<std::size_t>{1, 2, 3});
}

TEST_CASE("ex15.1 held out: pairs in any order, off the middle, and a gap in what sticks",
          "[ex15.1]") {
  Map map;
  map.x = (Eigen::VectorXd(5) << 7, 3, 11, 5, 9).finished();
  map.rows = {{k, k, f, o, k}, {k, f, f, k, k}};
  CHECK(stuck_half_width(map, 0) == 3);
  CHECK(stuck_half_width(map, 1) == 2);
  CHECK(always_stuck(map) == std::vector<Eigen::Index>{0, 4});
  CHECK(turns(map) == decltype(turns(map)){});
}

TEST_CASE("ex15.1 held out: one row has no turn", "[ex15.1]") {
  const Map map{Eigen::Vector2d(-1, 1), {{k, k}}};
  CHECK(turns(map) == decltype(turns(map)){});
  CHECK(stuck_half_width(map, 0) == 1);
  CHECK(always_stuck(map).size() == 2);
}

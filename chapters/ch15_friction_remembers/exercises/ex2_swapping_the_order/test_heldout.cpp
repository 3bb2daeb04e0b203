#include <stdexcept>

#include "../chapters/ch15_friction_remembers/orders.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using ex15_2::in_order;
using namespace signorini;

// Histories of any shape end where they ended; three of them, and another end of time.
TEST_CASE("ex15.2 held out: histories that went to and fro", "[ex15.2]") {
  Scene scene;
  scene.path = Path{equal_steps(7, 6),
                    {{"a", {0, 1, 9}, {3, -1, 7}}, {"b", {2}, {5}}, {"c", {0, 6}, {1, 0}}}};
  scene.path->halvings = 2;
  const Path path = in_order(scene, "b").path.value();
  CHECK(path.times == equal_steps(8, 6));
  CHECK(path.halvings == 2);
  REQUIRE(path.histories.size() == 3);
  CHECK(path.histories[0].name == "a");
  CHECK(path.histories[0].at(3) == 0);
  CHECK(path.histories[0].at(4.5) == Approx(2).epsilon(1e-14));
  CHECK(path.histories[0].at(6) == Approx(4).epsilon(1e-14));
  CHECK(path.histories[1].at(0) == 0);
  CHECK(path.histories[1].at(1.5) == Approx(2.5).epsilon(1e-14));
  CHECK(path.histories[1].at(3) == 5);
  CHECK(path.histories[1].at(6) == 5);
  CHECK(path.histories[2].at(6) == 0);
}

TEST_CASE("ex15.2 held out: the cylinder of the chapter in two orders", "[ex15.2]") {
  const ch15::Order way = ch15::orders()[2];
  const Scene scene = ch15::cylinder(equal_steps(4, 2), way.press, way.push);
  CHECK(ch15::end_of(in_order(scene, "press")).push == Approx(0.609).epsilon(1e-3));
  CHECK(ch15::end_of(in_order(scene, "push")).push == Approx(0).margin(1e-10));
}

TEST_CASE("ex15.2 held out: what has no order is refused", "[ex15.2]") {
  Scene scene;
  CHECK_THROWS_AS(in_order(scene, "press"), std::invalid_argument);
  scene.path = Path{{1}, {{"press", {0, 1}, {0, 1}}}};
  CHECK_THROWS_AS(in_order(scene, "hand"), std::invalid_argument);
  CHECK_NOTHROW(in_order(scene, "press"));
}

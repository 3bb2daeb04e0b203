#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex7_3;
using Rows = std::vector<Row>;

// At 60 degrees a force counts half, at 120 degrees minus half.
static const Rows round_about = {{0, 1, 2}, {60, 8, 4}, {120, 2, 4}, {180, 1, 1}};

TEST_CASE("ex7.3 held out: forces behind 90 degrees push back", "[ex7.3]") {
  CHECK(load_carried(round_about) == Approx(2 * (1 + 4 - 1 - 1)).epsilon(1e-12));
  CHECK(end_of_contact(round_about).pressed == 180);
  CHECK(end_of_contact(round_about).free == 180);
  CHECK(half_within(round_about) == 60);
}

TEST_CASE("ex7.3 held out: a pole that pulls", "[ex7.3]") {
  const Rows rows = {{0, -0.1, -1}, {60, 8, 4}, {90, 0, 0}};
  CHECK_FALSE(rightly_held(rows));
  CHECK(load_carried(rows) == Approx(7.8).epsilon(1e-12));
  CHECK(rightly_held({{0, 0, 0}, {60, 8, 4}}));
}

// A node without a force before the end is no end.
TEST_CASE("ex7.3 held out: a hole in the contact, and a contact at the pole only", "[ex7.3]") {
  const End end = end_of_contact({{0, 1, 1}, {10, 0, 0}, {20, 1, 1}, {35, 0, 0}, {40, 0, 0}});
  CHECK(end.pressed == 20);
  CHECK(end.free == 35);
  CHECK(end_of_contact({{0, 1, 1}, {10, 0, 0}}).pressed == 0);
  CHECK(half_within({{0, 1, 1}, {10, 0, 0}}) == 0);
}

TEST_CASE("ex7.3 held out: pieces", "[ex7.3]") {
  CHECK(piece_of(round_about, 0) == 0.5);
  CHECK(piece_of(round_about, 1) == 2);
  CHECK(piece_of({{0, 0, 0}, {1, 1, 1}}, 0) == 0);
}

TEST_CASE("ex7.3 held out: what is no bearing is refused", "[ex7.3]") {
  for (const Rows& bad : {Rows{}, Rows{{0, 1, 1}}, Rows{{1, 1, 1}, {2, 1, 1}},
                          Rows{{0, 1, 1}, {2, 1, 1}, {2, 1, 1}}, Rows{{0, 1, 1}, {200, 1, 1}}}) {
    CHECK_THROWS_AS(load_carried(bad), std::invalid_argument);
    CHECK_THROWS_AS(rightly_held(bad), std::invalid_argument);
    CHECK_THROWS_AS(end_of_contact(bad), std::invalid_argument);
    CHECK_THROWS_AS(piece_of(bad, 0), std::invalid_argument);
    CHECK_THROWS_AS(half_within(bad), std::invalid_argument);
  }
  CHECK_THROWS_AS(end_of_contact({{0, 0, 0}, {1, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(piece_of(round_about, 4), std::invalid_argument);
  CHECK_THROWS_AS(half_within({{0, 0, 0}, {180, 1, 1}}), std::invalid_argument);
}

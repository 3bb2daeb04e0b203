#include <cmath>
#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex7_3;

// results/nodes.md: pulled and pressed. The load is 25 kN/cm^2 on 20 cm.
static const std::vector<Row> pulled = {
    {0.00, 12.920, 36.22},  {8.18, 27.083, 37.96},  {16.36, 30.458, 42.69}, {24.55, 35.041, 49.12},
    {32.73, 39.721, 55.68}, {40.91, 43.390, 60.82}, {49.09, 45.999, 64.48}, {57.27, 45.839, 64.26},
    {65.45, 42.658, 59.80}, {73.64, 33.382, 46.79}, {81.82, 6.579, 9.22},   {90.00, 0.000, 0.00}};
static const std::vector<Row> pressed = {
    {0.00, 22.686, 63.60},  {8.18, 45.436, 63.69},  {16.36, 45.382, 63.61}, {24.55, 44.605, 62.52},
    {32.73, 42.567, 59.67}, {40.91, 38.295, 53.68}, {49.09, 31.614, 44.31}, {57.27, 21.668, 30.37},
    {65.45, 2.537, 3.56},   {73.64, 0.000, 0.00},   {81.82, 0.000, 0.00},   {90.00, 0.000, 0.00}};

TEST_CASE("ex7.3 the forces carry the load", "[ex7.3]") {
  CHECK(load_carried(pulled) == Approx(500).margin(0.05));
  CHECK(load_carried(pressed) == Approx(500).margin(0.05));
  CHECK(rightly_held(pulled));
  CHECK(rightly_held(pressed));
}

// Nodes are 8.18 degrees apart.
TEST_CASE("ex7.3 a contact ends between two nodes", "[ex7.3]") {
  for (const auto* rows : {&pulled, &pressed}) {
    const End end = end_of_contact(*rows);
    CHECK(end.free - end.pressed == Approx(8.18).margin(0.02));
    double beyond = 0;
    for (const Row& row : *rows)
      if (row.angle >= end.free) beyond += row.force;
    CHECK(beyond == 0);
  }
  CHECK(end_of_contact(pressed).free < end_of_contact(pulled).free);
}

// Cells have straight sides: a node stands for half of two chords.
TEST_CASE("ex7.3 a node stands for a piece of the edge, and one of them for half", "[ex7.3]") {
  const double chord = 2 * 5 * std::sin(std::acos(-1.0) / 44);
  double all = 0;
  for (std::size_t k = 0; k < 11; ++k) all += piece_of(pulled, k);
  CHECK(all == Approx(10.5 * chord).epsilon(1e-3));
  CHECK(piece_of(pulled, 5) == Approx(chord).epsilon(1e-3));
  CHECK(piece_of(pulled, 11) == 0);
}

TEST_CASE("ex7.3 half of the load is within and half beyond", "[ex7.3]") {
  const auto up_to = [](std::vector<Row> rows, double angle, bool with) {
    for (Row& row : rows)
      if (with ? row.angle > angle : row.angle >= angle) row.force = 0;
    return load_carried(rows);
  };
  for (const auto* rows : {&pulled, &pressed}) {
    const double angle = half_within(*rows);
    CHECK(up_to(*rows, angle, true) >= 250);
    CHECK(up_to(*rows, angle, false) < 250);
  }
  CHECK(half_within(pressed) < half_within(pulled));
}

TEST_CASE("ex7.3 what is no bearing is refused", "[ex7.3]") {
  CHECK_THROWS_AS(load_carried({{0, 1, 1}}), std::invalid_argument);
}

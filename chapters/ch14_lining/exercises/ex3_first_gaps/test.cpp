#include <cmath>
#include <stdexcept>

#include "../chapters/ch14_lining/rings.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex14_3;

// A row of results/turned_all.md.
static signorini::Scene turned(const char* element, Eigen::Index cells, const char* gap_operator,
                               const char* source) {
  ch14::Rings rings;
  rings.element = element;
  rings.cells_angle = cells;
  rings.gap_operator = gap_operator;
  rings.turn = 0.5;
  signorini::Scene scene = scene_of(rings);
  signorini::ContactSpec& contact = scene.contacts[0];
  if (contact.source.body != source)
    std::swap(contact.source, std::get<signorini::Side>(contact.target));
  return scene;
}

TEST_CASE("ex14.3 matching meshes have the gap of the drawing, up to their sides", "[ex14.3]") {
  const FirstGaps gaps = first_gaps(scene_of(ch14::paper));
  CHECK(gaps.pairs == 10);
  CHECK(gaps.inside == 0);
  CHECK(gaps.least == Approx(0.15 * std::cos(ch14::quarter_turn / 18)).epsilon(1e-9));
  CHECK(gaps.most == Approx(gaps.least).epsilon(1e-9));
  CHECK(as_drawn(gaps, 0.15, 0.01));
  CHECK_FALSE(as_drawn(gaps, 0.15, 0.001));
}

TEST_CASE("ex14.3 turned by half a cell, eight of ten nodes start inside the rock", "[ex14.3]") {
  const FirstGaps gaps = first_gaps(turned("q4_incompatible", 9, "node_to_segment", "lining"));
  CHECK(gaps.pairs == 10);
  CHECK(gaps.inside == 8);
  CHECK(gaps.least == Approx(68.15 * std::cos(ch14::quarter_turn / 18) - 68).epsilon(1e-9));
}

// How many of the 18 runs of the chapter could have been doubted before they ran?
TEST_CASE("ex14.3 the runs of the chapter whose gaps are those of the drawing", "[ex14.3]") {
  int trusted = 0, all = 0;
  for (const char* gap_operator : {"node_to_segment", "gauss_points", "mortar"})
    for (const char* source : {"lining", "rock"}) {
      for (const Eigen::Index cells : {9, 36})
        trusted +=
            as_drawn(first_gaps(turned("q4_incompatible", cells, gap_operator, source)), 0.15, 0.1);
      trusted += as_drawn(first_gaps(turned("q8", 9, gap_operator, source)), 0.15, 0.1);
      all += 3;
    }
  CHECK(all == 18);
  CHECK(trusted == 10);
}

TEST_CASE("ex14.3 sides that are short enough", "[ex14.3]") {
  const auto sagitta = [](Eigen::Index sides) {
    return 68.15 * (1 - std::cos(ch14::quarter_turn / 2 / static_cast<double>(sides)));
  };
  const Eigen::Index sides = sides_needed(68.15, 0.15, 0.1);
  CHECK(sagitta(sides) <= 0.015);
  CHECK(sagitta(sides - 1) > 0.015);
  CHECK_THROWS_AS(sides_needed(68.15, 0, 0.1), std::invalid_argument);
}

TEST_CASE("ex14.3 a press fit is drawn with a gap below zero, and one side may do", "[ex14.3]") {
  CHECK(as_drawn({3, 3, -0.0505, -0.0495}, -0.05, 0.02));
  CHECK_FALSE(as_drawn({3, 3, -0.0505, -0.0495}, -0.05, 0.002));
  CHECK(sides_needed(1, 1, 1) == 1);
}

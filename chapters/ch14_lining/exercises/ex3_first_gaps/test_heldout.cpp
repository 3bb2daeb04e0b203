#include <cmath>
#include <limits>
#include <stdexcept>

#include "../chapters/ch14_lining/rings.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/errors.hpp"
#include "meshes/block.hpp"

using namespace ex14_3;

// What a fit adds to the gaps of the meshes is in the plan.
TEST_CASE("ex14.3 held out: a press fit", "[ex14.3]") {
  signorini::Scene scene = scene_of(ch14::paper);
  const FirstGaps loose = first_gaps(scene);
  scene.contacts[0].interference = 0.2;
  const FirstGaps fit = first_gaps(scene);
  CHECK(fit.pairs == loose.pairs);
  CHECK(fit.inside == fit.pairs);
  CHECK(fit.least == Approx(loose.least - 0.2).epsilon(1e-12));
  CHECK(as_drawn(fit, -0.05, 0.02));
  CHECK_FALSE(as_drawn(fit, 0.05, 0.02));
  CHECK_FALSE(as_drawn(fit, -0.05, 1e-6));
}

TEST_CASE("ex14.3 held out: two contacts count together", "[ex14.3]") {
  signorini::Scene scene;
  scene.bodies[0].mesh = signorini::block("block", {0, 0.5}, {4, 1}, 4, 1);
  scene.bodies[0].material = {1000, 0.3, signorini::PlaneState::Strain, 1};
  scene.bodies[0].supports = {signorini::symmetric("left")};
  scene.contacts = {{{"bottom"}, signorini::half_plane({0, 0}, {0, 1})},
                    {{"right"}, signorini::half_plane({4.25, 0}, {-1, 0})}};
  const FirstGaps gaps = first_gaps(scene);
  CHECK(gaps.pairs == 7);
  CHECK(gaps.least == Approx(0.25).epsilon(1e-14));
  CHECK(gaps.most == Approx(0.5).epsilon(1e-14));
  CHECK_FALSE(as_drawn(gaps, 0.25, 0.9));
  CHECK_FALSE(as_drawn(gaps, 0.5, 0.4));
  CHECK(as_drawn(gaps, 0.5, 0.51));
  scene.contacts[0].target = signorini::half_plane({0, 0.5}, {0, 1});
  CHECK(first_gaps(scene).least == 0);
  CHECK(first_gaps(scene).inside == 0);  // it touches
}

TEST_CASE("ex14.3 held out: without contact there is no gap, and a bad scene is refused",
          "[ex14.3]") {
  signorini::Scene scene = scene_of(ch14::paper);
  scene.contacts.clear();
  const FirstGaps none = first_gaps(scene);
  CHECK(none.pairs == 0);
  CHECK(none.least == 0);
  CHECK(none.most == 0);
  CHECK(as_drawn(none, 0.15, 0));
  scene.bodies[0].supports.clear();
  CHECK_THROWS_AS(first_gaps(scene), signorini::ProblemError);
}

TEST_CASE("ex14.3 held out: no fewer sides would do, whatever the circle", "[ex14.3]") {
  for (const double unit : {1e-6, 1.0, 1e6})
    for (const double share : {0.25, 0.1, 1e-2, 1e-4, 1e-8, 1e-12}) {
      CAPTURE(unit, share);
      const auto sides = static_cast<double>(sides_needed(unit, 2 * share * unit, 0.5));
      const auto sagitta = [](double n) {
        return 2 * std::pow(std::sin(ch14::quarter_turn / 4 / n), 2);
      };
      CHECK(sagitta(sides) <= share);
      CHECK(sagitta(sides - 1) > share);
    }
  CHECK(sides_needed(1, 1, 0.3) == 1);  // one side lies 0.293 inside
  CHECK(sides_needed(1, 5, 2) == 1);
}

TEST_CASE("ex14.3 held out: what is no length is refused", "[ex14.3]") {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(sides_needed(-1, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(sides_needed(1, 1, 0), std::invalid_argument);
  CHECK_THROWS_AS(sides_needed(1, no_number, 1), std::invalid_argument);
}

#include <cmath>

#include "catch_compat.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/core/rounding.hpp"
#include "support/two_blocks.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::patch_test;
using signorini_test::PatchResult;
using signorini_test::press_blocks;

namespace {

const GapOperator& weighted() { return find_gap_operator("mortar"); }

struct Edges {
  Index source, target;
};
constexpr Edges non_matching[] = {{8, 11}, {11, 8}, {7, 15}, {7, 10}};

}  // namespace

TEST_CASE("a uniform pressure passes between any two meshes: the contact patch test",
          "[mortar][patch]") {
  // Rounding leaves 1e-14. Only a source of more edges that is 1000 times as stiff as the target multiplies it:
  // pressures that alternate from node to node hardly move anything then.
  const auto ratio = GENERATE(1.0, 1e3, 1e-3);
  const auto inclination = GENERATE(0.0, 15.0, -30.0);
  for (const char* element : {"q4", "q8", "q4_incompatible"})
    for (const Edges& edges : non_matching) {
      CAPTURE(element, edges.source, edges.target, inclination, ratio);
      const double accepted = ratio > 1 && edges.source > edges.target ? 1e-11 : 3e-13;
      CHECK(patch_test(weighted(), {}, edges.source, edges.target, inclination, ratio, element) <=
            accepted);
    }
}

TEST_CASE("triangles pass a uniform pressure too, among themselves and to quadrilaterals",
          "[mortar][patch]") {
  struct Pair {
    const char *source, *target;
    bool mixed;
  };
  const auto inclination = GENERATE(0.0, 15.0);
  for (const Pair& pair : {Pair{"t3", "t3", false},
                           {"t6", "t6", false},
                           {"t3", "q4", false},
                           {"q8", "t6", false},
                           {"t6", "t3", false},  // sides of three nodes against those of two
                           {"t3", "t6", false},
                           {"q4", "t6", false},
                           {"q4_incompatible", "q4", true},
                           {"q8", "q8", true},
                           {"t6", "q8", true}})
    for (const Edges& edges : non_matching) {
      CAPTURE(pair.source, pair.target, pair.mixed, edges.source, edges.target, inclination);
      const PatchResult result = press_blocks(
          weighted(), {},
          {edges.source, edges.target, inclination, 1, pair.source, pair.target, pair.mixed});
      CHECK(result.deviation <= 3e-13);
    }
}

TEST_CASE("without segments the pressure is off by about a percent, less with more points",
          "[mortar][patch]") {
  for (const char* element : {"q4", "q8"})
    for (const Edges& edges : non_matching) {
      GapOptions options;
      options.quadrature = Quadrature::SourceEdges;
      double deviation[3];
      const int points[3] = {2, 4, 10};
      for (int k = 0; k < 3; ++k) {
        options.points = points[k];
        deviation[k] = patch_test(weighted(), options, edges.source, edges.target, 0, 1, element);
      }
      CAPTURE(element, edges.source, edges.target, deviation[0], deviation[1], deviation[2]);
      CHECK(deviation[0] > 0.004);
      CHECK(deviation[0] < 0.04);
      CHECK(deviation[1] < deviation[0]);
      CHECK(deviation[2] < 0.002);
      CHECK(deviation[2] > 1e-6);  // it is the kinks, not rounding
    }
}

TEST_CASE("on matching meshes no segments are needed", "[mortar][patch]") {
  GapOptions options;
  options.quadrature = Quadrature::SourceEdges;
  for (const char* element : {"q4", "q8"})
    CHECK(patch_test(weighted(), options, 8, 8, 15, 1, element) <= 1e-13);
}

TEST_CASE("more points than needed on segments change nothing", "[mortar][patch]") {
  for (const int points : {2, 3, 7, 16}) {
    GapOptions options;
    options.points = points;
    CAPTURE(points);
    CHECK(patch_test(weighted(), options, 7, 10, 15, 1, "q8") <= 1e-13);
  }
}

TEST_CASE("two blocks under pressure close every pair and share their interface", "[mortar]") {
  const PatchResult result = press_blocks(weighted(), {}, {8, 11, 15, 1, "q8"});
  CHECK(result.pressure.size() == 17);
  const double length = 2 / std::cos(15 * pi / 180);
  CHECK(result.pairs.weight.sum() == Approx(length).epsilon(1e-14));
}

// Parts of a body by name.
#include <limits>

#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/regions.hpp"
#include "support/message.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using signorini_test::problem_message;

namespace {

Mesh plate() { return block("block", {0, 0}, {4, 2}, 4, 2); }

}  // namespace

TEST_CASE("a region has the cells whose middle lies in its rectangle", "[regions]") {
  Mesh mesh = with_region(plate(), "left", {0, 0}, {1.5, 2});  // on the edge counts
  CHECK(region(mesh, "left") == std::vector<Index>{0, 1, 4, 5});
  const double far = std::numeric_limits<double>::infinity();
  mesh = with_region(mesh, "upper", {-far, 1}, {far, far});
  CHECK(region(mesh, "upper") == std::vector<Index>{4, 5, 6, 7});
  mesh = with_region(mesh, "left", {0, 0}, {1, 1});  // again, smaller
  CHECK(region(mesh, "left") == std::vector<Index>{0});
}

TEST_CASE("regions that are not there, or have no cells, are errors", "[regions]") {
  Mesh mesh = with_region(plate(), "left", {0, 0}, {1, 2});
  CHECK_THAT(problem_message([&] { static_cast<void>(region(mesh, "rigth")); }),
             ContainsSubstring("has no region 'rigth'; it has: left"));
  CHECK_THAT(problem_message([&] {
               mesh = with_region(mesh, "thin", {0, 0}, {4, 0.4});
             }),
             ContainsSubstring("no cell has its middle in (0, 0) to (4, 0.4)"));
  mesh.regions["none"] = {};
  CHECK_THAT(problem_message([&] { static_cast<void>(region(mesh, "none")); }),
             ContainsSubstring("has no cells"));
  mesh.regions["wrong"] = {3, 8};
  CHECK_THAT(problem_message([&] { static_cast<void>(region(mesh, "wrong")); }),
             ContainsSubstring("refers to cell 8, but the cells are 0 to 7"));
}

TEST_CASE("a middle on the edge of a rectangle belongs in all units", "[regions]") {
  for (const double unit : {1.0, 1e-3, 1e3, 0.3}) {
    const Mesh strip = block("strip", {0, 0}, {4.137 * unit, 2 * unit}, 5, 1);
    const Mesh left = with_region(strip, "left", {-unit, -unit}, {2.0685 * unit, 3 * unit});
    CAPTURE(unit);
    CHECK(region(left, "left") == std::vector<Index>{0, 1, 2});
  }
}

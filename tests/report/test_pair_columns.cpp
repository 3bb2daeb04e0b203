#include <cmath>
#include <string>
#include <vector>

#include "addons/steps/steps.hpp"
#include "catch_compat.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/bodies.hpp"
#include "support/three_pairs.hpp"
#include "support/two_bodies.hpp"

using namespace signorini;
using signorini_test::lines_of;
using signorini_test::three_forces_with_friction;
using signorini_test::three_gaps;
using signorini_test::three_pairs;

TEST_CASE("with friction the table has its columns behind the others",
          "[pressure_table][friction]") {
  const std::vector<std::string> lines =
      lines_of(pressure_csv(three_gaps(), three_forces_with_friction()));
  REQUIRE(lines.size() == 5);
  CHECK_THAT(lines[0], ContainsSubstring("# contact stone.rim on half plane: force on the source"));
  CHECK(lines[1] ==
        "x,y,gap,pressure,force,status,shear_traction,shear_force,slip,motion,dissipated");
  CHECK(lines[2] == "0,1,0,20,10,closed,-10,-5,0.5,forward,2.5");
  CHECK(lines[3] == "2,0,0,3,3,closed,2,2,0,stick,0");
  CHECK(lines[4] == "4,-1,0.25,0,0,open,0,0,-0.125,open,0");
}

TEST_CASE("a pair that cannot rub bears no shear and has neither slip nor motion",
          "[pressure_table][friction]") {
  Solution solution = three_forces_with_friction();
  solution.contact.frictional_pairs = {0};
  solution.contact.friction.conservativeResize(1);
  solution.contact.slip.conservativeResize(1);
  const std::vector<std::string> lines = lines_of(pressure_csv(three_gaps(), solution));
  CHECK(lines[2] == "0,1,0,20,10,closed,-10,-5,0.5,forward,2.5");
  CHECK(lines[3] == "2,0,0,3,3,closed,0,0,,,0");
  CHECK(lines[4] == "4,-1,0.25,0,0,open,0,0,,,0");
}

TEST_CASE("on a path the table has slip and work so far", "[pressure_table][steps]") {
  PathState state;
  state.steps = 2;
  state.slip = Eigen::Vector3d(1.5, 0.25, -0.5);
  state.dissipation = Eigen::Vector3d(12.5, 1, 0);
  const Solution solution = three_forces_with_friction();
  const std::vector<std::string> lines =
      lines_of(pressure_csv(three_gaps(), solution, "rel 1e-6", totals(&state)));
  CHECK_THAT(lines[1], ContainsSubstring("dissipated 2.5, in total 13.5"));
  CHECK(lines[2] ==
        "x,y,gap,pressure,force,status,shear_traction,shear_force,slip,motion,dissipated,"
        "slip_total,dissipated_total");
  CHECK(lines[3] == "0,1,0,20,10,closed,-10,-5,0.5,forward,2.5,1.5,12.5");
  CHECK(resultants(three_gaps(), solution, totals(&state)).dissipated_total == 13.5);
  const std::vector<PairColumn> columns = pair_columns(three_gaps(), solution, totals(&state));
  CHECK(lines_of(csv_head(columns) + csv_lines(columns)) ==
        std::vector<std::string>(lines.begin() + 2, lines.end()));
  state.slip = Eigen::Vector2d(0, 0);
  CHECK_THROWS_WITH(pair_columns(three_gaps(), solution, totals(&state)),
                    ContainsSubstring("the solution has 3 slips, but the state of its path 2"));
  CHECK_THROWS_AS(resultants(three_gaps(), solution, totals(&state)), std::invalid_argument);
}

TEST_CASE("words have a name each, numbers their digits, and what is missing is empty",
          "[pair_columns]") {
  const double none = std::nan("");
  const PairColumn number{"slip", "length", "", Eigen::Vector2d(1.0 / 3, none)};
  CHECK(number.cell(0) == "0.3333333333");
  CHECK(number.cell(0, "%.2f") == "0.33");
  CHECK(number.cell(1).empty());
  const PairColumn word{"motion", "-", "", Eigen::Vector2d(1, none), {"open", "stick"}};
  CHECK(word.cell(0) == "stick");
  CHECK(word.cell(1).empty());
}

TEST_CASE("contacts are called after their sides, and no two alike", "[pair_columns]") {
  Scene scene =
      signorini_test::two_blocks(signorini_test::named_block("lower", {0, 0}, {2, 1}, 2, 1),
                                 signorini_test::named_block("upper", {0, 1}, {2, 1}, 2, 1));
  const ContactSpec wall{{"left", "upper"}, half_plane({0, 0}, {1, 0})};
  scene.contacts.insert(scene.contacts.end(), {wall, wall, wall});
  scene.contacts[2].source.boundary = "right";
  const std::vector<std::string> names = {"upper.bottom on lower.top", "upper.left on half plane",
                                          "upper.right on half plane",
                                          "upper.left on half plane (2)"};
  const Plan planned = plan([&] {
    Scene once = scene;
    once.contacts.pop_back();
    once.contacts[2].target = half_plane({2, 0}, {-1, 0});
    return once;
  }());
  CHECK(planned.contacts == std::vector<std::string>(names.begin(), names.end() - 1));
  CHECK(contact_names(planned.bodies, scene.contacts) == names);
}

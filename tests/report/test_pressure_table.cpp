#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/report/pressure_table.hpp"
#include "support/three_pairs.hpp"

using namespace signorini;
using signorini_test::lines_of;
using signorini_test::three_forces;
using signorini_test::three_forces_with_friction;
using signorini_test::three_gaps;
using signorini_test::three_pairs;

TEST_CASE("the resultants are the sums of the pairs, with sign", "[pressure_table]") {
  const Resultants sum = resultants(three_gaps(), three_forces());
  CHECK(sum.force == Eigen::Vector2d(6, 11));         // out of the obstacle, onto the body
  CHECK(sum.moment == Approx(-6 + 6).margin(1e-14));  // x fy - y fx: 0 x 8 - 1 x 6 and 2 x 3 - 0
  CHECK(sum.closed_weight == 1.5);
  CHECK(sum.peak_pressure == 20);
  Solution shifted = three_forces();
  shifted.contact.force(1) = 5;
  CHECK(resultants(three_gaps(), shifted).moment == Approx(-6 + 10).epsilon(1e-14));
}

TEST_CASE("friction counts in the resultants, and notes stand in front of the table",
          "[pressure_table][friction]") {
  Solution solution = three_forces_with_friction();
  // Tangents (0.8, -0.6) and (1, 0): friction adds (-4, 3) at (0, 1) and (2, 0) at (2, 0).
  const Resultants sum = resultants(three_gaps(), solution);
  CHECK((sum.force - Eigen::Vector2d(6 - 4 + 2, 11 + 3)).norm() <= 1e-14);
  CHECK(sum.moment == Approx(4).epsilon(1e-14));
  CHECK(sum.normal_force == 13);
  CHECK(sum.shear_force == -3);
  CHECK(sum.dissipated == 2.5);  // the second pair sticks: what rounding left of its slip is none
  CHECK(sum.dissipated_total == 2.5);
  solution.notes = {"this is one of several"};
  CHECK(lines_of(pressure_csv(three_gaps(), solution))[0] == "# note this is one of several");
  solution.notes = {"of 'a\r\nb'"};
  Model odd = three_gaps();
  odd.contacts = {"a\nb"};
  CHECK(lines_of(pressure_csv(odd, solution))[0] == "# note of 'a  b'");
  CHECK_THAT(lines_of(pressure_csv(odd, solution))[1],
             StartsWith("# contact a b: force on the source ("));
}

TEST_CASE("the pairs of every kind are counted", "[pressure_table][friction]") {
  Solution solution = three_forces_with_friction();
  const Resultants sum = resultants(three_gaps(), solution);
  CHECK(std::vector<Eigen::Index>{sum.pairs, sum.closed, sum.frictional_pairs, sum.stick,
                                  sum.slide} == std::vector<Eigen::Index>{3, 2, 3, 1, 1});
  solution.contact.contact_status[0] = ContactStatus::SlipBackward;
  CHECK(resultants(three_gaps(), solution).slide == 1);
  const Resultants smooth = resultants(three_gaps(), three_forces());
  CHECK(std::vector<Eigen::Index>{smooth.closed, smooth.frictional_pairs, smooth.stick,
                                  smooth.slide} == std::vector<Eigen::Index>{2, 0, 0, 0});
}

TEST_CASE("sums of the contacts add up to that of all", "[pressure_table][friction]") {
  Model model = three_gaps();
  model.contacts = {"a.rim on half plane", "b.rim on \"c\".top"};
  model.contact_of = {0, 1, 1};
  const Solution solution = three_forces_with_friction();
  const std::vector<Resultants> each = resultants_of_contacts(model, solution);
  const Resultants all = resultants(model, solution);
  REQUIRE(each.size() == 2);
  CHECK(each[0].normal_force == 10);
  CHECK(each[1].normal_force == 3);
  CHECK(each[0].pairs == 1);
  CHECK(each[1].stick == 1);
  CHECK(each[1].peak_pressure == 3);
  CHECK((each[0].force + each[1].force - all.force).norm() <= 1e-14);
  CHECK(each[0].moment + each[1].moment == Approx(all.moment).epsilon(1e-14));
  CHECK(each[0].dissipated + each[1].dissipated == all.dissipated);
  CHECK(each[0].closed_weight + each[1].closed_weight == all.closed_weight);

  const std::vector<std::string> lines = lines_of(pressure_csv(model, solution));
  REQUIRE(lines.size() == 7);
  CHECK_THAT(lines[0], ContainsSubstring("# force on the sources (4, 14)"));
  CHECK_THAT(lines[1],
             ContainsSubstring("# contact a.rim on half plane: force on the source (2, 11)"));
  CHECK_THAT(lines[2], ContainsSubstring("shear force 2, open 1, stick 1, slide 0, dissipated 0"));
  CHECK_THAT(lines[3], ContainsSubstring(",dissipated,contact"));
  CHECK_THAT(lines[4], ContainsSubstring(",2.5,a.rim on half plane"));
  CHECK_THAT(lines[5], ContainsSubstring(R"(,0,"b.rim on ""c"".top")"));
}

TEST_CASE("the table has its columns and one line per pair in order", "[pressure_table]") {
  const std::vector<std::string> lines = lines_of(pressure_csv(three_gaps(), three_forces()));
  REQUIRE(lines.size() == 5);
  CHECK(lines[1] == "x,y,gap,pressure,force,status");
  CHECK(lines[2] == "0,1,0,20,10,closed");
  CHECK(lines[3] == "2,0,0,3,3,closed");
  CHECK(lines[4] == "4,-1,0.25,0,0,open");
}

TEST_CASE("the resultants and a tolerance go in front as comments", "[pressure_table]") {
  CHECK_THAT(lines_of(pressure_csv(three_gaps(), three_forces()))[0],
             ContainsSubstring("# force on the sources (6, 11)") &&
                 ContainsSubstring("closed boundary 1.5") && ContainsSubstring("peak pressure 20"));
  const std::vector<std::string> lines =
      lines_of(pressure_csv(three_gaps(), three_forces(), "rel 1e-6 abs 1e-9"));
  CHECK(lines[0] == "# tolerance rel 1e-6 abs 1e-9");
  CHECK(lines[2] == "x,y,gap,pressure,force,status");
}

TEST_CASE("no table is made of a problem that is not solved", "[pressure_table]") {
  Solution solution = three_forces();
  solution.contact.report.status = SolveStatus::Breakdown;
  CHECK_THROWS_WITH(pressure_csv(three_gaps(), solution), ContainsSubstring("breakdown"));
  CHECK_THROWS_AS(resultants(three_gaps(), solution), std::invalid_argument);
}

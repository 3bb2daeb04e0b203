#include <sstream>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/report/pressure_table.hpp"

using namespace signorini;

namespace {

/// Three pairs with slanted normals, the first two closed.
Pairs three_gaps() {
  Pairs gaps;
  gaps.initial_gap.setZero(3);
  gaps.weight = Eigen::Vector3d(0.5, 1, 0.5);
  gaps.position.resize(3, 2);
  gaps.position << 0, 1, 2, 0, 4, -1;
  gaps.normal.resize(3, 2);
  gaps.normal << 0.6, 0.8, 0, 1, 1, 0;
  gaps.node = {7, 8, 9};
  return gaps;
}

Solution three_forces() {
  Solution solution;
  solution.contact.report.status = Status::Solved;
  solution.contact.force = Eigen::Vector3d(10, 3, 0);
  solution.contact.gap = Eigen::Vector3d(0, 0, 0.25);
  solution.contact.active = {0, 1};
  solution.pressure = Eigen::Vector3d(20, 3, 0);
  return solution;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

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
  Solution solution = three_forces();
  solution.contact.rubbing = {0, 1, 2};
  solution.contact.friction = Eigen::Vector3d(-5, 2, 0);
  // Tangents (0.8, -0.6) and (1, 0): friction adds (-4, 3) at (0, 1) and (2, 0) at (2, 0).
  const Resultants sum = resultants(three_gaps(), solution);
  CHECK((sum.force - Eigen::Vector2d(6 - 4 + 2, 11 + 3)).norm() <= 1e-14);
  CHECK(sum.moment == Approx(4).epsilon(1e-14));
  solution.notes = {"this is one of several"};
  CHECK(lines_of(pressure_csv(three_gaps(), solution))[0] == "# note this is one of several");
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
  solution.contact.report.status = Status::Breakdown;
  CHECK_THROWS_WITH(pressure_csv(three_gaps(), solution), ContainsSubstring("breakdown"));
  CHECK_THROWS_AS(resultants(three_gaps(), solution), std::invalid_argument);
}

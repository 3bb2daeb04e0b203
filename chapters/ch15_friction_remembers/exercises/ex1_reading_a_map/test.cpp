#include <string>

#include "../chapters/ch15_friction_remembers/partial_slip.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex15_1;
using signorini::ContactStatus;

// o open, k sticks, f forward, b backward
static Map map_of(const std::vector<std::string>& rows) {
  Map map;
  map.x = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(rows[0].size()), -4, 4);
  for (const std::string& row : rows) {
    std::vector<ContactStatus> contact_status;
    for (const char letter : row)
      contact_status.push_back(letter == 'o'   ? ContactStatus::Open
                               : letter == 'k' ? ContactStatus::Stick
                               : letter == 'f' ? ContactStatus::SlipForward
                                               : ContactStatus::SlipBackward);
    map.rows.push_back(contact_status);
  }
  return map;
}

TEST_CASE("ex15.1 a map by hand", "[ex15.1]") {
  const Map map = map_of({"okkkkkkko", "ofkkkkkfo", "offkkkffo", "okkkkkkko", "obkkkkkbo"});
  CHECK(stuck_half_width(map, 0) == 3);
  CHECK(stuck_half_width(map, 1) == 2);
  CHECK(stuck_half_width(map, 2) == 1);
  CHECK(turns(map) == std::vector<std::size_t>{3});
  CHECK(always_stuck(map) == std::vector<Eigen::Index>{3, 4, 5});
}

TEST_CASE("ex15.1 nothing that sticks has no width", "[ex15.1]") {
  const Map map = map_of({"offffffko", "offfffffo"});
  CHECK(stuck_half_width(map, 0) == 0);
  CHECK(stuck_half_width(map, 1) == 0);
  CHECK(always_stuck(map) == decltype(always_stuck(map)){});
  CHECK_THROWS_AS(stuck_half_width(map, 2), std::out_of_range);
}

// Six steps up, twelve down, twelve up.
TEST_CASE("ex15.1 the push on the cylinder turns twice", "[ex15.1]") {
  const ch15::Pressed known = ch15::pressed_cylinder();
  Map map;
  std::vector<double> times;
  ch15::remember(
      ch15::by_force(ch15::cylinder(ch15::steps_between(1, 6, 6), ch15::pressing, known.push())),
      [&](const signorini::Model& model, const signorini::Step& step) {
        map.x = model.pairs.position.col(0);
        map.rows.push_back(step.solution.contact.contact_status);
        times.push_back(step.state.time);
      });
  CHECK(turns(map) == std::vector<std::size_t>{6, 18});
  for (std::size_t row = 0; row < map.rows.size(); ++row)  // a cell is 0.06 mm
    CHECK(stuck_half_width(map, row) == Approx(known.stuck(times[row])).margin(0.065));
}

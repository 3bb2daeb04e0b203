#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_4;

TEST_CASE("ex16.4 held out: small phases neither count nor vote", "[ex16.4]") {
  const Verdict verdict = find_fault(
      {{"plan", 0.01, 0.1}, {"factor", 4, 4}, {"recovery", 0.01, 0.1}, {"contact", 0.001, 0.1}});
  CHECK(verdict.slowness == 1);
  CHECK(verdict.faulty == decltype(verdict.faulty){});
}

TEST_CASE("ex16.4 held out: too long and too short are faults", "[ex16.4]") {
  const Verdict verdict =
      find_fault({{"a", 1, 1}, {"b", 2, 1}, {"c", 1, 1}, {"d", 1, 2}, {"e", 1, 1.2}});
  CHECK(verdict.slowness == 1);
  CHECK(verdict.faulty == std::vector<std::string>{"b", "d"});
}

TEST_CASE("ex16.4 held out: an even number of phases, and none", "[ex16.4]") {
  CHECK(find_fault({{"a", 1, 1}, {"b", 1, 3}}).slowness == 2);
  CHECK(find_fault({{"a", 1, 1}, {"b", 1, 3}}).faulty.size() == 2);
  CHECK(find_fault({}).slowness == 1);
}

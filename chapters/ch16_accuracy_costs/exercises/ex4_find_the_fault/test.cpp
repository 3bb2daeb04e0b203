#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_4;

TEST_CASE("ex16.4 a busy machine is nobody's fault", "[ex16.4]") {
  const Verdict verdict = find_fault({{"assembly", 1, 2}, {"factor", 3, 6}, {"contact", 0.5, 1}});
  CHECK(verdict.slowness == Approx(2).epsilon(1e-15));
  CHECK(verdict.faulty == decltype(verdict.faulty){});
}

TEST_CASE("ex16.4 one phase with a wrong law", "[ex16.4]") {
  const Verdict verdict =
      find_fault({{"assembly", 1, 1.1}, {"factor", 4, 8.8}, {"refinement", 1, 1.1}});
  CHECK(verdict.slowness == Approx(1.1).epsilon(1e-12));
  CHECK(verdict.faulty == std::vector<std::string>{"factor"});
}

TEST_CASE("ex16.4 the middle of four, and a phase that is too short to count", "[ex16.4]") {
  const Verdict four = find_fault({{"a", 1, 2}, {"b", 1, 1}, {"c", 1, 1.2}, {"d", 1, 1.4}});
  CHECK(four.slowness == Approx(1.3).epsilon(1e-14));
  CHECK(four.faulty == std::vector<std::string>{"a", "b"});
  CHECK(find_fault({{"a", 1, 1.2}, {"b", 1, 1}, {"c", 1, 1.4}}).slowness == 1.2);
  const Verdict brief = find_fault({{"assembly", 1, 2}, {"factor", 3, 6}, {"plan", 0.01, 0.1}});
  CHECK(brief.slowness == Approx(2).epsilon(1e-14));
  CHECK(brief.faulty == std::vector<std::string>{});
}

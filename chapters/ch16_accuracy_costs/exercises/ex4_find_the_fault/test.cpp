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

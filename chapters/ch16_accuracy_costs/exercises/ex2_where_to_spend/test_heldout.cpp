#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_2;

TEST_CASE("ex16.2 held out: a target that is met costs nothing", "[ex16.2]") {
  const Spending plan = spend({{"mesh", 1, 5, 8}}, 1);
  CHECK(plan.reached);
  CHECK(plan.halved.empty());
  CHECK(plan.budget[0].cost == 5);
  CHECK(spend({}, 1).reached);
}

TEST_CASE("ex16.2 held out: of two equal errors the first", "[ex16.2]") {
  const Spending plan = spend({{"a", 1, 1, 2}, {"b", 1, 1, 2}}, 1.2);
  CHECK(plan.halved == std::vector<std::string>{"a", "b"});
}

TEST_CASE("ex16.2 held out: what cannot be halved stays in the sum", "[ex16.2]") {
  const Spending plan = spend({{"theory", 0.1, 0, 0}, {"mesh", 0.4, 1, 8}}, 0.25);
  CHECK(plan.reached);
  CHECK(plan.halved == std::vector<std::string>{"mesh", "mesh"});
  CHECK_THROWS_AS(spend({}, 0), std::invalid_argument);
}

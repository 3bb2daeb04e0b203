#include <stdexcept>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_2;

TEST_CASE("ex16.2 the largest error first", "[ex16.2]") {
  const Spending plan = spend({{"gaps", 0.8, 1, 2}, {"mesh", 0.3, 10, 8}}, 0.5);
  CHECK(plan.reached);
  CHECK(plan.halved == std::vector<std::string>{"gaps", "gaps"});
  CHECK(plan.budget[0].error == Approx(0.2).epsilon(1e-15));
  CHECK(plan.budget[0].cost == 4);
  CHECK(plan.budget[1].cost == 10);
  CHECK(plan.obstacle == decltype(plan.obstacle){});
}

TEST_CASE("ex16.2 what cannot be bought is named", "[ex16.2]") {
  const Spending plan = spend({{"theory", 0.4, 0, 0}, {"mesh", 1, 1, 8}}, 0.3);
  CHECK_FALSE(plan.reached);
  CHECK(plan.obstacle == "theory");
  CHECK(plan.halved == decltype(plan.halved){});  // nothing is bought that cannot help
}

TEST_CASE("ex16.2 nothing reaches a target of nothing", "[ex16.2]") {
  CHECK_THROWS_AS(spend({{"mesh", 1, 1, 8}}, -0.1), std::invalid_argument);
}

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex16_2;

TEST_CASE("ex16.2 held out: a target that is met costs nothing", "[ex16.2]") {
  const Spending plan = spend({{"mesh", 1, 5, 8}}, 1);
  CHECK(plan.reached);
  CHECK(plan.halved == decltype(plan.halved){});
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

TEST_CASE("ex16.2 held out: a large cause that cannot be halved need not be in the way",
          "[ex16.2]") {
  const Spending plan = spend({{"theory", 0.2, 0, 0}, {"mesh", 0.1, 1, 8}}, 0.25);
  CHECK(plan.reached);
  CHECK(plan.halved == std::vector<std::string>{"mesh"});
}

TEST_CASE("ex16.2 held out: small causes that cannot be halved are in the way together",
          "[ex16.2]") {
  const Spending plan =
      spend({{"load", 0.125, 0, 0}, {"mesh", 1, 1, 8}, {"theory", 0.25, 0, 0}}, 0.375);
  CHECK_FALSE(plan.reached);
  CHECK(plan.halved == decltype(plan.halved){});
  CHECK(plan.obstacle == "theory");
  CHECK(spend({{"theory", 0.5, 0, 0}}, 0.5).reached);
}

#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/family.hpp"
#include "support/message.hpp"

using namespace signorini;

namespace {

struct Animal {
  const char* name;
  int legs;
};

}  // namespace

TEST_CASE("a member is found by its name, and who asks for another is told the names", "[family]") {
  const std::vector<Animal> animals = {{"ant", 6}, {"bee", 6}, {"cat", 4}};
  CHECK(find_member(animals, "cat", "animal").legs == 4);
  CHECK(&find_member(animals, "ant", "animal") == &animals.front());
  CHECK(names_of(animals) == "ant, bee, cat");
  CHECK(signorini_test::problem_message([&] {
          static_cast<void>(find_member(animals, "dog", "animal"));
        }) == "unknown animal 'dog'; there are: ant, bee, cat");
  CHECK(signorini_test::problem_message([&] {
          static_cast<void>(find_member(animals, "bea", "animal"));
        }) == "unknown animal 'bea'; did you mean 'bee'? There are: ant, bee, cat");
}

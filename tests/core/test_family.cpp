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

TEST_CASE("a member is added once, in front of the one that is named or at the end", "[family]") {
  std::vector<Animal> animals;
  add_member({"cat", 4}, animals);
  add_member({"bee", 6}, animals);
  add_member({"ant", 6}, animals, "bee");
  add_member({"dog", 4}, animals, "eel");
  add_member({"bee", 5}, animals, "cat");
  CHECK(names_of(animals) == "cat, ant, bee, dog");
  CHECK(find_member(animals, "bee", "animal").legs == 6);
}

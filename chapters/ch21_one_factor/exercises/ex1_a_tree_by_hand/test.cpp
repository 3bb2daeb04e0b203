#include <numeric>

#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex21_1;

TEST_CASE("ex21.1 from one end to the other the tree is a chain", "[ex21.1]") {
  std::vector<int> order(1023);
  std::iota(order.begin(), order.end(), 0);
  const Tree tree = eliminate(order);
  CHECK(tree.height == 1023);
  CHECK(tree.entries == 2045);
  CHECK(tree.parent[0] == 1);
  CHECK(tree.parent[1022] == -1);
}

TEST_CASE("ex21.1 separators make it ten high", "[ex21.1]") {
  CHECK(separators(3) == std::vector<int>{0, 2, 1});
  CHECK(separators(7) == std::vector<int>{0, 2, 1, 4, 6, 5, 3});
  const Tree tree = eliminate(separators(1023));
  CHECK(tree.height == 10);
}

#include "../chapters/ch21_one_factor/elimination_tree.hpp"
#include "catch_compat.hpp"
#include "exercise.hpp"

using namespace ex21_1;

TEST_CASE("ex21.1 held out: the middle first joins both of its neighbours", "[ex21.1]") {
  const Tree tree = eliminate({1, 0, 2});
  CHECK(tree.parent == std::vector<int>{1, 2, -1});
  CHECK(tree.height == 3);
  CHECK(tree.entries == 6);
}

TEST_CASE("ex21.1 held out: as the tree of the chapter, for any order", "[ex21.1]") {
  const int n = 40;
  ch21::Sparse K(n, n);
  for (int k = 0; k < n; ++k)
    for (int j = std::max(0, k - 1); j <= std::min(n - 1, k + 1); ++j) K.insert(j, k) = 1;
  std::vector<int> strides;
  for (int k = 0; k < n; ++k) strides.push_back(k * 7 % n);
  for (const std::vector<int>& order : {separators(n), strides}) {
    const ch21::EliminationTree known = ch21::elimination_tree(K, order);
    const Tree tree = eliminate(order);
    CHECK(tree.parent == known.parent);
    CHECK(tree.height == known.height);
    CHECK(static_cast<double>(tree.entries) == known.entries);
  }
}

TEST_CASE("ex21.1 held out: no chain and one spring", "[ex21.1]") {
  CHECK(eliminate({}).height == 0);
  CHECK(separators(0) == decltype(separators(0)){});
  CHECK(eliminate({0}).height == 1);
  CHECK(eliminate(separators(1024)).height == 11);
}

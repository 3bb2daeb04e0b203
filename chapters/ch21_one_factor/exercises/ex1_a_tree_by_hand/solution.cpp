#include <algorithm>
#include <set>

#include "exercise.hpp"

namespace ex21_1 {

namespace {

void part(int first, int last, std::vector<int>& order) {
  if (first > last) return;
  const int middle = (first + last) / 2;
  part(first, middle - 1, order);
  part(middle + 1, last, order);
  order.push_back(middle);
}

}  // namespace

Tree eliminate(const std::vector<int>& order) {
  const std::size_t n = order.size();
  std::vector<std::size_t> place(n);
  for (std::size_t k = 0; k < n; ++k) place[static_cast<std::size_t>(order[k])] = k;
  std::vector<std::set<std::size_t>> later(n);  // by place
  for (std::size_t u = 1; u < n; ++u)
    later[std::min(place[u - 1], place[u])].insert(std::max(place[u - 1], place[u]));
  Tree tree;
  tree.parent.assign(n, -1);
  for (std::size_t k = 0; k < n; ++k) {
    tree.entries += static_cast<long long>(later[k].size()) + 1;
    if (later[k].empty()) continue;
    const std::size_t parent = *later[k].begin();
    tree.parent[k] = static_cast<int>(parent);
    later[parent].insert(std::next(later[k].begin()), later[k].end());
  }
  std::vector<int> depth(n, 1);
  for (std::size_t k = n; k-- > 0;) {
    if (tree.parent[k] >= 0) depth[k] = depth[static_cast<std::size_t>(tree.parent[k])] + 1;
    tree.height = std::max(tree.height, depth[k]);
  }
  return tree;
}

std::vector<int> separators(int n) {
  std::vector<int> order;
  part(0, n - 1, order);
  return order;
}

}  // namespace ex21_1

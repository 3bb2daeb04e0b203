#include <stdexcept>

#include "exercise.hpp"

namespace ex20_2 {

static void require(bool holds, const char* otherwise) {
  if (!holds) throw std::invalid_argument(otherwise);
}

Reading read(const std::vector<bool>& overlapping, const std::vector<Exchange>& exchanges) {
  const int n = static_cast<int>(overlapping.size());
  std::vector<bool> basic(overlapping.size() * 3, false);
  const auto at = [&](int variable) { return basic.begin() + variable; };
  for (int i = 0; i < n; ++i) *at(overlapping[static_cast<std::size_t>(i)] ? 2 * n + i : i) = true;
  Reading reading;
  for (const auto& [joins, leaves] : exchanges) {
    require(joins >= 0 && joins < 2 * n, "read: only a gap or a force can join");
    require(leaves >= 0 && leaves < 3 * n, "read: there is no such variable");
    require(!*at(joins), "read: what joins is in the basis already");
    require(*at(leaves), "read: what leaves is not in the basis");
    *at(joins) = true;
    *at(leaves) = false;
    require(!*at(joins % n) || !*at(n + joins % n), "read: a force joins beside the gap of its pair");
    reading.ended += leaves >= 2 * n ? 1 : 0;
    reading.in_vain += leaves >= n && leaves < 2 * n ? 1 : 0;
  }
  reading.solved = true;
  for (int i = 0; i < n; ++i) {
    if (*at(n + i)) reading.closed.push_back(i);
    if (*at(2 * n + i)) reading.solved = false;
  }
  return reading;
}

}  // namespace ex20_2

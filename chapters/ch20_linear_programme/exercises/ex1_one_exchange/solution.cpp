#include "exercise.hpp"

namespace ex20_1 {

Index joining(const Tableau& tableau) {
  const Index n = tableau.pairs();
  std::vector<bool> taken(static_cast<std::size_t>(n), false);
  for (std::size_t row = 0; row < taken.size(); ++row)
    if (!tableau.artificial[row]) taken[static_cast<std::size_t>(tableau.basic[row] % n)] = true;
  Index best = -1;
  double fastest = 1e-12;
  for (Index j = 0; j < 2 * n; ++j) {
    if (taken[static_cast<std::size_t>(j % n)]) continue;
    double gain = 0;
    for (Index row = 0; row < n; ++row)
      if (tableau.artificial[static_cast<std::size_t>(row)]) gain += tableau.rows(row, j);
    if (gain > fastest) {
      fastest = gain;
      best = j;
    }
  }
  return best;
}

Index leaving(const Tableau& tableau, Index variable) {
  const Index n = tableau.pairs();
  Index first = -1;
  double shortest = 0;
  for (Index row = 0; row < n; ++row) {
    const double entry = tableau.rows(row, variable);
    if (entry <= 1e-12) continue;
    const double ratio = tableau.rows(row, 2 * n) / entry;
    if (first < 0 || ratio < shortest) {
      shortest = ratio;
      first = row;
    }
  }
  return first;
}

}  // namespace ex20_1

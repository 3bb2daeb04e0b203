#include "signorini/report/step_tables.hpp"

#include <algorithm>

#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

namespace {

double is_in(const std::vector<Index>& sorted, Index pair) {
  return std::binary_search(sorted.begin(), sorted.end(), pair) ? 1 : 0;
}

}  // namespace

Table outer_steps(const QuasiActiveRun& run, const Eigen::VectorXd& at) {
  require(at.size() == run.state.gap.size(), "outer_steps: need ", run.state.gap.size(),
          " positions, one per pair, got ", at.size());
  Table table({"step", "at", "quasi_active", "closed"});
  for (std::size_t k = 0; k < run.steps.size(); ++k)
    for (const Index pair : run.steps[k].violated)
      table.row({static_cast<double>(k), at(pair), is_in(run.steps[k].quasi_active, pair),
                 is_in(run.steps[k].closed, pair)});
  return table;
}

Table inner_steps(const std::vector<std::vector<Index>>& supports, const Eigen::VectorXd& at) {
  Table table({"step", "at", "joins"});
  for (std::size_t k = 0; k < supports.size(); ++k)
    for (const Index pair : supports[k]) {
      require(pair < at.size(), "inner_steps: pair ", pair, " has no position, there are ",
              at.size());
      table.row({static_cast<double>(k), at(pair), k == 0 ? 1 : 1 - is_in(supports[k - 1], pair)});
    }
  return table;
}

}  // namespace signorini

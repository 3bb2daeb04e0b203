#include <algorithm>
#include <stdexcept>

#include "exercise.hpp"
#include "signorini/core/dense.hpp"

namespace ex1_3 {

using Eigen::Index;
using Rows = std::vector<Index>;

Body without(const Body& body, Index unknown) {
  const Index n = body.load.size();
  if (unknown < 0 || unknown >= n) throw std::invalid_argument("without: no such unknown");
  const double pivot = body.stiffness(unknown, unknown);
  if (!(pivot > 0)) throw std::invalid_argument("without: nothing holds this unknown");
  Rows others;
  for (Index i = 0; i < n; ++i)
    if (i != unknown) others.push_back(i);
  const Eigen::VectorXd share = body.stiffness(others, unknown) / pivot;  // -1 times how it follows
  return {body.stiffness(others, others) - share * body.stiffness(unknown, others),
          body.load(others) - share * body.load(unknown)};
}

Condensed condense(const Body& body, const Rows& touching, const Eigen::VectorXd& initial_gap) {
  const auto n_c = static_cast<Index>(touching.size());
  if (initial_gap.size() != n_c)
    throw std::invalid_argument("condense: every stop has one initial gap");
  Rows sorted = touching;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() || sorted.front() < 0 ||
      sorted.back() >= body.load.size())
    throw std::invalid_argument("condense: touching names unknowns, each once");
  Body left = body;
  for (Index i = body.load.size() - 1; i >= 0; --i)
    if (!std::binary_search(sorted.begin(), sorted.end(), i)) left = without(left, i);
  Rows place;  // of each stop among what is left
  for (const Index i : touching)
    place.push_back(std::lower_bound(sorted.begin(), sorted.end(), i) - sorted.begin());
  const signorini::CholeskyFactor factor(left.stiffness(place, place));
  return {factor.solve_columns(Eigen::MatrixXd::Identity(n_c, n_c)),
          initial_gap - factor.solve(left.load(place))};
}

}  // namespace ex1_3

#include <stdexcept>

#include "exercise.hpp"

namespace ex5_3 {

void exchange(Table& table, Index pair) {
  auto& [M, q, closed] = table;
  if (pair < 0 || pair >= q.size()) throw std::invalid_argument("exchange: no such pair");
  const double pivot = M(pair, pair);
  if (!(pivot > 1e-12)) throw std::invalid_argument("exchange: nothing moves this pair alone");
  const Eigen::VectorXd column = M.col(pair) / pivot;  // what a unit of the new x changes
  const Eigen::RowVectorXd row = M.row(pair);
  const double value = q(pair);
  M -= column * row;
  q -= column * value;
  M.row(pair) = -row / pivot;
  M.col(pair) = column;
  M(pair, pair) = 1 / pivot;
  q(pair) = -value / pivot;
  closed[static_cast<std::size_t>(pair)].flip();
}

std::vector<Index> exchange_wrong_pairs(Table& table) {
  std::vector<Index> wrong;
  for (Index i = 0; i < table.q.size(); ++i)
    if (table.q(i) < -1e-12) wrong.push_back(i);
  for (const Index i : wrong) exchange(table, i);
  return wrong;
}

}  // namespace ex5_3

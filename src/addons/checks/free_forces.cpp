#include "addons/checks/free_forces.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "signorini/core/disjoint_sets.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

FreeForces::FreeForces(const Carried& carried)
    : carried_(carried),
      pairs_(carried.force.size() - static_cast<Index>(carried.law.pair.size())),
      unit_(carried.force.size()),
      slip_row_(at(pairs_), -1),
      sticks_(at(pairs_), false) {
  for (Index row = 0; row < unit_.size(); ++row) {
    const double length = carried.effect.col(row).norm();
    unit_(row) = length > 0 ? length : 1;
  }
  largest_ = largest(unit_.cwiseProduct(carried.force));
  for (std::size_t k = 0; k < carried.law.pair.size(); ++k)
    slip_row_[at(carried.law.pair[k])] = pairs_ + static_cast<Index>(k);
  for (Index pair = 0; pair < pairs_; ++pair) add(pair);
}

void FreeForces::add(Index pair) {
  const Index slip = slip_row_[at(pair)];
  const double mu = slip < 0 ? 0 : carried_.law.coefficient(slip - pairs_);
  const double cohesion = slip < 0 ? 0 : carried_.law.cohesion(slip - pairs_);
  const ContactStatus contact_status = carried_.statuses[at(pair)];
  if (pair >= carried_.equations && contact_status == ContactStatus::Open &&
      (carried_.movement(pair) > carried_.rounding(pair) || cohesion > 0))
    return;
  One normal{pair, pair};
  if (mu > 0 || cohesion > 0) {
    const double way = carried_.movement(slip);
    sticks_[at(pair)] =
        contact_status == ContactStatus::Stick || std::abs(way) <= carried_.rounding(slip);
    if (sticks_[at(pair)])
      free_.push_back({pair, slip});
    else
      normal = {pair, pair, slip, way > 0 ? -mu : mu};
  }
  free_.push_back(normal);
}

std::vector<SparseEntries> FreeForces::exchanges() const {
  std::vector<SparseEntries> columns;
  for (const One& one : free_) {
    SparseEntries column;
    const auto put = [&](Index row, double factor) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(carried_.effect, row); it; ++it)
        column.emplace_back(it.row(), factor * it.value());
    };
    put(one.row, 1 / unit_(one.row));
    if (one.slip >= 0) put(one.slip, one.slope / unit_(one.row));
    columns.push_back(std::move(column));
  }
  return null_combinations(columns, carried_.effect.rows(), certificate_tolerance);
}

SharedForces FreeForces::group_of(const std::vector<SparseEntries>& members) const {
  SharedForces group;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < members.size(); ++k)
    for (const auto& [place, change] : members[k]) {
      const One& one = free_[at(place)];
      const Index column = static_cast<Index>(k);
      group.pairs.push_back(one.pair);
      entries.emplace_back(one.row, column, change / unit_(one.row));
      if (one.slope != 0)
        entries.emplace_back(one.slip, column, one.slope * change / unit_(one.row));
    }
  std::sort(group.pairs.begin(), group.pairs.end());
  group.pairs.erase(std::unique(group.pairs.begin(), group.pairs.end()), group.pairs.end());
  group.exchanges.resize(unit_.size(), static_cast<Index>(members.size()));
  group.exchanges.setFromTriplets(entries.begin(), entries.end());
  return group;
}

Index FreeForces::slip_row(Index pair) const { return slip_row_[at(pair)]; }

bool FreeForces::sticks(Index pair) const { return sticks_[at(pair)]; }

std::vector<SharedForces> FreeForces::groups() const {
  const std::vector<SparseEntries> all = exchanges();
  DisjointSets sets(pairs_);
  const auto pair_of = [&](const std::pair<Index, double>& entry) {
    return free_[at(entry.first)].pair;
  };
  for (const SparseEntries& exchange : all)
    for (const auto& entry : exchange) sets.join(pair_of(entry), pair_of(exchange.front()));
  std::map<Index, std::vector<SparseEntries>> members;
  for (const SparseEntries& exchange : all)
    members[sets.name(pair_of(exchange.front()))].push_back(exchange);
  std::vector<SharedForces> groups;
  for (const auto& [first, exchanges_of_group] : members)
    groups.push_back(group_of(exchanges_of_group));
  return groups;
}

}  // namespace signorini

#include "signorini/closing/undetermined.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "signorini/closing/elimination.hpp"
#include "signorini/closing/polyhedron.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double passes = 1e-12;  // what a certificate lets pass, see Certificate::holds()

/// A force that may change, with the friction force that follows it where its pair slides.
struct FreeForce {
  Index pair;
  Index row;
  Index slip = -1;
  double slope = 0;
};

/// An orthonormal basis of the exchanges of a group.
struct Changes {
  std::vector<Index> rows;  ///< of the pairs of the group, rising
  MatrixXd moved;           ///< of these rows, in units of what a force moves
  MatrixXd force;           ///< the same [force]

  [[nodiscard]] Index place(Index row) const {
    return std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
  }
};

/// Forces in units of what they move, and which of them may change.
class Forces {
 public:
  explicit Forces(const Carried& carried);

  [[nodiscard]] std::vector<SharedForces> shared(double work) const;

 private:
  void add(Index pair);
  /// A basis of the changes of the free forces that do nothing, one sparse vector each.
  [[nodiscard]] std::vector<SparseEntries> exchanges() const;
  /// Drives the forces of a group to their ends. \param[in,out] work  what is left of it
  void measure(SharedForces& group, double& work) const;
  [[nodiscard]] Changes changes(const SharedForces& group) const;
  [[nodiscard]] Polyhedron polyhedron(const SharedForces& group, const Changes& changes) const;
  [[nodiscard]] SharedForces group_of(const std::vector<SparseEntries>& members) const;

  const Carried& carried_;
  Index pairs_;
  VectorXd unit_;                ///< `n_c + n_s` length of the columns of the effect
  double largest_;               ///< of the forces in these units
  std::vector<Index> slip_row_;  ///< of each pair; -1 if it does not rub
  std::vector<FreeForce> free_;
  std::vector<bool> sticks_;  ///< of each pair: its friction force is free within its bound
};

Forces::Forces(const Carried& carried)
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

void Forces::add(Index pair) {
  const Index slip = slip_row_[at(pair)];
  const double mu = slip < 0 ? 0 : carried_.law.coefficient(slip - pairs_);
  const double cohesion = slip < 0 ? 0 : carried_.law.cohesion(slip - pairs_);
  const Motion motion = carried_.motions[at(pair)];
  if (pair >= carried_.equations && motion == Motion::Open &&
      (carried_.movement(pair) > carried_.rounding(pair) || cohesion > 0))
    return;
  FreeForce normal{pair, pair};
  if (mu > 0 || cohesion > 0) {
    const double way = carried_.movement(slip);
    sticks_[at(pair)] = motion == Motion::Stick || std::abs(way) <= carried_.rounding(slip);
    if (sticks_[at(pair)])
      free_.push_back({pair, slip});
    else
      normal = {pair, pair, slip, way > 0 ? -mu : mu};
  }
  free_.push_back(normal);
}

std::vector<SparseEntries> Forces::exchanges() const {
  std::vector<SparseEntries> columns;
  for (const FreeForce& one : free_) {
    SparseEntries column;
    const auto put = [&](Index row, double factor) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(carried_.effect, row); it; ++it)
        column.emplace_back(it.row(), factor * it.value());
    };
    put(one.row, 1 / unit_(one.row));
    if (one.slip >= 0) put(one.slip, one.slope / unit_(one.row));
    columns.push_back(std::move(column));
  }
  return null_combinations(columns, carried_.effect.rows(), passes);
}

SharedForces Forces::group_of(const std::vector<SparseEntries>& members) const {
  SharedForces group;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < members.size(); ++k)
    for (const auto& [place, change] : members[k]) {
      const FreeForce& one = free_[at(place)];
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

Changes Forces::changes(const SharedForces& group) const {
  Changes all;
  for (const Index pair : group.pairs) {
    all.rows.push_back(pair);
    if (slip_row_[at(pair)] >= 0) all.rows.push_back(slip_row_[at(pair)]);
  }
  std::sort(all.rows.begin(), all.rows.end());
  const VectorXd unit = unit_(all.rows);
  MatrixXd moved = MatrixXd::Zero(unit.size(), group.exchanges.cols());
  for (Index k = 0; k < moved.cols(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(group.exchanges, k); it; ++it)
      moved(all.place(it.row()), k) = unit_(it.row()) * it.value();
  all.moved = column_span(moved).basis;
  all.force = unit.cwiseInverse().asDiagonal() * all.moved;
  return all;
}

/// The bounds of all pairs of a group, in units of what a force moves.
Polyhedron Forces::polyhedron(const SharedForces& group, const Changes& changes) const {
  std::vector<Eigen::RowVectorXd> G;
  std::vector<double> h;
  const auto bound = [&](const Eigen::RowVectorXd& growth, double slack, double unit) {
    if (largest(growth.transpose()) * unit <= passes) return;
    G.emplace_back(unit * growth);
    h.push_back(unit * slack > passes * largest_ ? unit * slack : 0);
  };
  const auto change = [&](Index row) { return changes.force.row(changes.place(row)); };
  const VectorXd& force = carried_.force;
  for (const Index pair : group.pairs) {
    if (pair >= carried_.equations) bound(change(pair), force(pair), unit_(pair));
    if (!sticks_[at(pair)]) continue;
    const Index slip = slip_row_[at(pair)];
    const double mu = carried_.law.coefficient(slip - pairs_);
    const double most = mu * force(pair) + carried_.law.cohesion(slip - pairs_);
    for (const double side : {1.0, -1.0})
      bound(mu * change(pair) - side * change(slip), most - side * force(slip), unit_(slip));
  }
  MatrixXd rows(static_cast<Index>(G.size()), changes.force.cols());
  for (std::size_t i = 0; i < G.size(); ++i) rows.row(static_cast<Index>(i)) = G[i];
  return {rows, Eigen::Map<const VectorXd>(h.data(), rows.rows())};
}

void Forces::measure(SharedForces& group, double& work) const {
  const auto width = static_cast<double>(group.exchanges.cols());
  const double size = (4 * static_cast<double>(group.pairs.size()) + width) * width;
  if ((work -= 2 * size * width) < 0) {  // not even a first point
    for (const Index pair : group.pairs) group.forces.push_back({pair, unknown, unknown});
    return;
  }
  const Changes changes = this->changes(group);
  Polyhedron all = polyhedron(group, changes);
  std::vector<Index> rows = changes.rows;
  std::stable_sort(rows.begin(), rows.end(), [&](Index a, Index b) {
    return unit_(a) * std::abs(carried_.force(a)) > unit_(b) * std::abs(carried_.force(b));
  });
  for (const Index row : rows) {
    const Index place = changes.place(row);
    if (largest(changes.moved.row(place).transpose()) <= passes) continue;
    const Index before = all.pivots();
    const auto [low, high] =
        work > 0 ? all.range(changes.moved.row(place).transpose()) : std::pair(unknown, unknown);
    work -= size * static_cast<double>(all.pivots() - before) + 2 * width * width * width;
    if (high - low <= passes * largest_) continue;
    const double now = unit_(row) * carried_.force(row);
    const auto force = [&](double change) {
      return std::abs(now + change) <= passes * largest_ ? 0 : (now + change) / unit_(row);
    };
    group.forces.push_back({row, force(low), force(high)});
  }
  std::sort(group.forces.begin(), group.forces.end(),
            [](const ForceRange& a, const ForceRange& b) { return a.row < b.row; });
}

std::vector<SharedForces> Forces::shared(double work) const {
  const std::vector<SparseEntries> all = exchanges();
  std::vector<Index> leader(at(pairs_));  // of the group of each pair
  std::iota(leader.begin(), leader.end(), Index{0});
  const auto find = [&](Index pair) {
    while (leader[at(pair)] != pair) pair = leader[at(pair)] = leader[at(leader[at(pair)])];
    return pair;
  };
  const auto pair_of = [&](const std::pair<Index, double>& entry) {
    return free_[at(entry.first)].pair;
  };
  for (const SparseEntries& exchange : all)
    for (const auto& entry : exchange)
      leader[at(find(pair_of(entry)))] = find(pair_of(exchange.front()));
  std::map<Index, std::vector<SparseEntries>> members;
  for (const SparseEntries& exchange : all)
    members[find(pair_of(exchange.front()))].push_back(exchange);
  std::vector<SharedForces> groups;
  for (const auto& [first, exchanges_of_group] : members) {
    SharedForces group = group_of(exchanges_of_group);
    measure(group, work);
    if (!group.forces.empty()) groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const SharedForces& a, const SharedForces& b) {
    return a.width() > b.width();
  });
  return groups;
}

}  // namespace

double SharedForces::width() const {
  double most = 0;
  for (const ForceRange& range : forces) {
    const double width = range.high - range.low;
    most = std::max(most, std::isnan(width) ? std::numeric_limits<double>::infinity() : width);
  }
  return most;
}

std::vector<SharedForces> undetermined_forces(const Carried& carried, double work) {
  const Index rows = carried.force.size();
  const Index pairs = static_cast<Index>(carried.motions.size());
  require(carried.effect.cols() == rows && carried.movement.size() == rows &&
              carried.rounding.size() == rows &&
              pairs + static_cast<Index>(carried.law.pair.size()) == rows,
          "undetermined_forces: need ", rows, " columns, movements and roundings for ", rows,
          " forces of ", pairs, " pairs and ", carried.law.pair.size(), " slips, got ",
          carried.effect.cols(), ", ", carried.movement.size(), " and ", carried.rounding.size());
  return Forces(carried).shared(work);
}

}  // namespace signorini

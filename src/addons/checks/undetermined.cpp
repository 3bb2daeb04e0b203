#include "addons/checks/undetermined.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "addons/checks/free_forces.hpp"
#include "addons/checks/polyhedron.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// An orthonormal basis of the exchanges of a group.
struct Changes {
  std::vector<Index> rows;  ///< of the pairs of the group, rising
  MatrixXd moved;           ///< of these rows, in units of what a force moves
  MatrixXd force;           ///< the same [force]

  [[nodiscard]] Index place(Index row) const {
    return std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
  }
};

Changes changes_of(const FreeForces& free, const SharedForces& group) {
  Changes all;
  for (const Index pair : group.pairs) {
    all.rows.push_back(pair);
    if (free.slip_row(pair) >= 0) all.rows.push_back(free.slip_row(pair));
  }
  std::sort(all.rows.begin(), all.rows.end());
  const VectorXd unit = free.unit()(all.rows);
  MatrixXd moved = MatrixXd::Zero(unit.size(), group.exchanges.cols());
  for (Index k = 0; k < moved.cols(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(group.exchanges, k); it; ++it)
      moved(all.place(it.row()), k) = free.unit()(it.row()) * it.value();
  all.moved = column_span(moved).basis;
  all.force = unit.cwiseInverse().asDiagonal() * all.moved;
  return all;
}

/// The bounds of all pairs of a group, in units of what a force moves.
Polyhedron bounds_of(const Carried& carried, const FreeForces& free, const SharedForces& group,
                     const Changes& changes) {
  std::vector<Eigen::RowVectorXd> G;
  std::vector<double> h;
  const double none = certificate_tolerance * free.largest_force();
  const auto bound = [&](const Eigen::RowVectorXd& growth, double slack, double unit) {
    if (largest(growth.transpose()) * unit <= certificate_tolerance) return;
    G.emplace_back(unit * growth);
    h.push_back(unit * slack > none ? unit * slack : 0);
  };
  const auto change = [&](Index row) { return changes.force.row(changes.place(row)); };
  const VectorXd& force = carried.force;
  const Index pairs = static_cast<Index>(carried.statuses.size());
  for (const Index pair : group.pairs) {
    if (pair >= carried.equations) bound(change(pair), force(pair), free.unit()(pair));
    if (!free.sticks(pair)) continue;
    const Index slip = free.slip_row(pair);
    const double mu = carried.law.coefficient(slip - pairs);
    const double most = mu * force(pair) + carried.law.cohesion(slip - pairs);
    for (const double side : {1.0, -1.0})
      bound(mu * change(pair) - side * change(slip), most - side * force(slip), free.unit()(slip));
  }
  MatrixXd rows(static_cast<Index>(G.size()), changes.force.cols());
  for (std::size_t i = 0; i < G.size(); ++i) rows.row(static_cast<Index>(i)) = G[i];
  return {rows, Eigen::Map<const VectorXd>(h.data(), rows.rows())};
}

/// Drives the forces of a group to their ends. \param[in,out] work  what is left of it
void measure(const Carried& carried, const FreeForces& free, SharedForces& group, double& work) {
  const auto width = static_cast<double>(group.exchanges.cols());
  const double size = (4 * static_cast<double>(group.pairs.size()) + width) * width;
  if ((work -= 2 * size * width) < 0) {  // not even a first point
    for (const Index pair : group.pairs) group.forces.push_back({pair, unknown, unknown});
    return;
  }
  const Changes changes = changes_of(free, group);
  Polyhedron all = bounds_of(carried, free, group, changes);
  const VectorXd moving = free.unit().cwiseProduct(carried.force);
  const double none = certificate_tolerance * free.largest_force();
  std::vector<Index> rows = changes.rows;
  std::stable_sort(rows.begin(), rows.end(),
                   [&](Index a, Index b) { return std::abs(moving(a)) > std::abs(moving(b)); });
  for (const Index row : rows) {
    const VectorXd way = changes.moved.row(changes.place(row)).transpose();
    if (largest(way) <= certificate_tolerance) continue;
    const Index before = all.pivots();
    const auto [low, high] = work > 0 ? all.range(way) : std::pair(unknown, unknown);
    work -= size * static_cast<double>(all.pivots() - before) + 2 * width * width * width;
    if (high - low <= none) continue;
    const auto force = [&](double change) {
      const double end = moving(row) + change;
      return std::abs(end) <= none ? 0 : end / free.unit()(row);
    };
    group.forces.push_back({row, force(low), force(high)});
  }
  std::sort(group.forces.begin(), group.forces.end(),
            [](const ForceRange& a, const ForceRange& b) { return a.row < b.row; });
}

}  // namespace

std::vector<SharedForces> undetermined_forces(const Carried& carried, double work) {
  const Index rows = carried.force.size();
  const Index pairs = static_cast<Index>(carried.statuses.size());
  require_argument(carried.effect.cols() == rows && carried.movement.size() == rows &&
                       carried.rounding.size() == rows &&
                       pairs + static_cast<Index>(carried.law.pair.size()) == rows,
                   "undetermined_forces: need ", rows, " columns, movements and roundings for ",
                   rows, " forces of ", pairs, " pairs and ", carried.law.pair.size(),
                   " slips, got ", carried.effect.cols(), ", ", carried.movement.size(), " and ",
                   carried.rounding.size());
  const FreeForces free(carried);
  std::vector<SharedForces> groups;
  for (SharedForces& group : free.groups()) {
    measure(carried, free, group, work);
    if (!group.forces.empty()) groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const SharedForces& a, const SharedForces& b) {
    return a.width() > b.width();
  });
  return groups;
}

}  // namespace signorini

#include "signorini/contact/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Entries of one row that are more than rounding, and what given displacements add to it.
struct FreeRow {
  std::vector<std::pair<Index, double>> entries;
  double held = 0;
};

FreeRow free_row(const NodalRows& rows, Index row, const Unknowns& unknowns) {
  FreeRow found;
  double largest = 0;
  for (NodalRows::InnerIterator it(rows, row); it; ++it)
    largest = std::max(largest, std::abs(it.value()));
  for (NodalRows::InnerIterator it(rows, row); it; ++it) {
    const Index node = it.col() / 2;
    const Index axis = it.col() % 2;
    const Index unknown = unknowns.number(node, axis);
    if (unknown >= 0 && std::abs(it.value()) > 4 * epsilon * largest)
      found.entries.emplace_back(unknown, it.value());
    else
      found.held += it.value() * unknowns.held(node, axis);
  }
  return found;
}

void append(Triplets& entries, Index row, const FreeRow& free, double sign) {
  for (const auto& [unknown, value] : free.entries)
    entries.emplace_back(static_cast<int>(row), static_cast<int>(unknown), sign * value);
}

Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(Index rows, Index columns,
                                                    const Triplets& entries) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> result(rows, columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

NodalRows kept_rows(const NodalRows& rows, const std::vector<Index>& kept) {
  Triplets entries;
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (NodalRows::InnerIterator it(rows, kept[k]); it; ++it)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(it.col()), it.value());
  return matrix(static_cast<Index>(kept.size()), rows.cols(), entries);
}

template <typename Array>
Array below_dense(const Array& upper, const Array& lower) {
  Array both(upper.rows() + lower.rows(), lower.cols());
  both << upper, lower;
  return both;
}

/// A side with both ends held cannot open or close: the boundary was meant for a support or for contact.
void check_not_supported(const Surface& source, const std::set<Index>& held) {
  for (const CellSide& side : boundary(source.mesh, source.boundary)) {
    const std::vector<Index> nodes = source.mesh.side_nodes(side);
    pose(held.count(nodes.front()) == 0 || held.count(nodes.back()) == 0, "contact boundary '",
         source.boundary, "' is also held by a support: nodes ", nodes.front(), " and ",
         nodes.back(),
         " cannot move along the target's normal. Take the support or the contact off this "
         "boundary");
  }
}

}  // namespace

Gaps reduce(const Pairs& pairs, const Surface& source, const Unknowns& unknowns,
            const std::string& what) {
  const Index candidates = pairs.initial_gap.size();
  const bool slides = pairs.sliding.rows() == candidates;
  const double size = pairs.position.size() > 0 ? pairs.position.cwiseAbs().maxCoeff() : 0;
  Gaps gaps;
  std::vector<Index> kept;
  std::set<Index> held;
  std::vector<double> gap;
  std::vector<double> slip;
  Triplets normal;
  Triplets tangential;
  for (Index pair = 0; pair < candidates; ++pair) {
    const FreeRow opening = free_row(pairs.opening, pair, unknowns);
    const double initial = pairs.initial_gap(pair) + opening.held;
    if (opening.entries.empty()) {
      pose(initial >= -16 * epsilon * size, what, ": the pair at (", pairs.position(pair, 0), ", ",
           pairs.position(pair, 1), ") is held by supports and overlaps by ", -initial,
           ". Move one of the two sides or release the node");
      held.insert(pairs.node[static_cast<std::size_t>(pair)]);
      continue;
    }
    const Index row = static_cast<Index>(kept.size());
    append(normal, row, opening, -1);
    if (slides) {
      const FreeRow sliding = free_row(pairs.sliding, pair, unknowns);
      append(tangential, row, sliding, 1);
      slip.push_back(sliding.held);
    }
    gap.push_back(initial);
    kept.push_back(pair);
  }
  held.erase(-1);
  check_not_supported(source, held);
  const Index n_pairs = static_cast<Index>(kept.size());
  gaps.A = matrix(n_pairs, unknowns.count, normal);
  gaps.T = matrix(slides ? n_pairs : 0, unknowns.count, tangential);
  gaps.initial_gap = Eigen::Map<Eigen::VectorXd>(gap.data(), n_pairs);
  gaps.initial_slip = Eigen::Map<Eigen::VectorXd>(slip.data(), slides ? n_pairs : 0);
  gaps.opening = kept_rows(pairs.opening, kept);
  if (slides) gaps.sliding = kept_rows(pairs.sliding, kept);
  gaps.weight = pairs.weight(kept);
  gaps.position = pairs.position(kept, Eigen::all);
  gaps.normal = pairs.normal(kept, Eigen::all);
  for (const Index pair : kept) {
    const Index node = pairs.node[static_cast<std::size_t>(pair)];
    gaps.node.push_back(node < 0 ? node : source.first_node + node);
  }
  for (const Index node : pairs.unpaired) gaps.unpaired.push_back(source.first_node + node);
  return gaps;
}

NodalRows below(const NodalRows& upper, const NodalRows& lower) {
  Triplets entries;
  for (Index row = 0; row < upper.rows(); ++row)
    for (NodalRows::InnerIterator it(upper, row); it; ++it)
      entries.emplace_back(static_cast<int>(row), static_cast<int>(it.col()), it.value());
  for (Index row = 0; row < lower.rows(); ++row)
    for (NodalRows::InnerIterator it(lower, row); it; ++it)
      entries.emplace_back(static_cast<int>(upper.rows() + row), static_cast<int>(it.col()),
                           it.value());
  return matrix(upper.rows() + lower.rows(), lower.cols(), entries);
}

Gaps stacked(const Gaps& upper, const Gaps& lower) {
  if (upper.initial_gap.size() == 0) return lower;
  Gaps both;
  both.A = below(upper.A, lower.A);
  both.T = below(upper.T, lower.T);
  both.opening = below(upper.opening, lower.opening);
  both.sliding = below(upper.sliding, lower.sliding);
  both.initial_gap = below_dense(upper.initial_gap, lower.initial_gap);
  both.initial_slip = below_dense(upper.initial_slip, lower.initial_slip);
  both.weight = below_dense(upper.weight, lower.weight);
  both.position = below_dense(upper.position, lower.position);
  both.normal = below_dense(upper.normal, lower.normal);
  both.node = upper.node;
  both.node.insert(both.node.end(), lower.node.begin(), lower.node.end());
  both.unpaired = upper.unpaired;
  both.unpaired.insert(both.unpaired.end(), lower.unpaired.begin(), lower.unpaired.end());
  return both;
}

}  // namespace signorini

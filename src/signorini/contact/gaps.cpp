// # Gaps of what can still move
//
// The gap of a pair is \f$g + N u\f$ with the displacements \f$u\f$ of all nodes. Supports have
// given some of these. Split \f$u\f$ into free and held components:
//
// \f[ gap = (g + N_h u_h) + N_f u_f = g' - A\,u_f, \qquad A = -N_f, \f]
//
// and the same for the slip, with \f$T = S_f\f$. A support that pushes the body towards an
// obstacle changes the initial gap, and no unknown stands for it. The minus sign is the first
// paper's: with it \f$A^T\lambda\f$ and the stiffness stand on one side of the equation,
// \f$K u + A^T\lambda = p\f$ with \f$\lambda \ge 0\f$.
//
// Some rows become empty: both points are held along the normal, and the pair can neither open nor
// close. Its contact force would be undetermined, since supports take whatever it gives. Such
// pairs are dropped.

#include "signorini/contact/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Entries of one row that are more than rounding, and what given displacements add to it.
///
/// An empty row is empty up to rounding. The normal of a flat side at \f$10^6\f$ sizes from the
/// origin is off by \f$10^{-10}\f$ to one side, so that it has a small component along the side. If
/// a support holds the node across the side and not along it, this component alone would remain,
/// and only a displacement \f$10^{10}\f$ times as large as the gap could close it.
struct FreeRow {
  std::vector<std::pair<Index, double>> entries;
  double held = 0;
};

/// Each entry is compared with two numbers: the largest of its row, for the rounding of the
/// arithmetic, and the larger of the two entries of its node, for the uncertainty of the direction.
FreeRow free_row(const NodalRows& rows, Index row, const Unknowns& unknowns, double directions) {
  FreeRow found;
  double largest = 0;
  std::map<Index, double> of_node;  // the larger of its two entries
  for (NodalRows::InnerIterator it(rows, row); it; ++it) {
    const double size = std::abs(it.value());
    largest = std::max(largest, size);
    double& own = of_node[it.col() / 2];
    own = std::max(own, size);
  }
  for (NodalRows::InnerIterator it(rows, row); it; ++it) {
    const Index node = it.col() / 2;
    const Index axis = it.col() % 2;
    const Index unknown = unknowns.number(node, axis);
    const double rounding = 4 * std::max(epsilon * largest, directions * of_node[node]);
    if (unknown >= 0 && std::abs(it.value()) > rounding)
      found.entries.emplace_back(unknown, it.value());
    else
      found.held += it.value() * unknowns.held(node, axis);
  }
  return found;
}

/// Signs differ: gaps enter with a minus, slips with a plus.
void append(Triplets& entries, Index row, const FreeRow& free, double sign) {
  for (const auto& [unknown, value] : free.entries)
    entries.emplace_back(static_cast<int>(row), static_cast<int>(unknown), sign * value);
}

/// A side with both ends held cannot open or close: the boundary was meant for a support or for
/// contact.
///
/// One node that is held and on the contact is usual, such as the corner between a clamped end and
/// the contact. A whole side that is held is a mistake in the scene.
void check_not_supported(const Surface& source, const std::set<Index>& held) {
  for (const CellSide& side : boundary(source.mesh, source.boundary)) {
    const std::vector<Index> nodes = source.mesh.side_nodes(side);
    require_input(
        held.count(nodes.front()) == 0 || held.count(nodes.back()) == 0, "contact boundary '",
        source.boundary, "' is also held by a support: nodes ", nodes.front(), " and ",
        nodes.back(),
        " cannot move along the target's normal. Take the support or the contact off this "
        "boundary");
  }
}

/// The pairs that can open or close are kept. The others hold no contact force.
void sort_pairs(const Pairs& pairs, const std::vector<FreeRow>& openings, const Surface& source,
                Gaps& gaps) {
  std::set<Index> held;
  for (Index pair = 0; pair < pairs.initial_gap.size(); ++pair) {
    const bool moves = !openings[static_cast<std::size_t>(pair)].entries.empty();
    (moves ? gaps.kept : gaps.dropped).push_back(pair);
    if (!moves) held.insert(pairs.node[static_cast<std::size_t>(pair)]);
  }
  // Pairs of Gauss points have no node of their own, and cannot tell which node is held.
  held.erase(-1);
  check_not_supported(source, held);
}

/// Some of the pairs, with the nodes counted among those of all bodies.
Pairs selected(const Pairs& pairs, const std::vector<Index>& kept, const Surface& source) {
  Pairs some;
  // Every array of the pairs is cut in the same way: by numbers of rows.
  some.opening = selected_rows(pairs.opening, kept);
  if (pairs.sliding.rows() > 0) some.sliding = selected_rows(pairs.sliding, kept);
  some.initial_gap = pairs.initial_gap(kept);
  some.weight = pairs.weight(kept);
  some.position = pairs.position(kept, Eigen::all);
  some.normal = pairs.normal(kept, Eigen::all);
  some.moment = pairs.moment(kept, Eigen::all);
  some.target_moment = pairs.target_moment(kept, Eigen::all);
  for (const Index pair : kept) {
    const Index node = pairs.node[static_cast<std::size_t>(pair)];
    // Nodes are counted through all bodies from here on, as unknowns are. A pair of a Gauss point
    // has none.
    some.node.push_back(node < 0 ? node : source.first_node + node);
  }
  for (const Index node : pairs.unpaired) some.unpaired.push_back(source.first_node + node);
  return some;
}

}  // namespace

/// A gap is the difference of two positions, each rounded in proportion to its size.
double gap_rounding(const Pairs& pairs) {
  return 16 * epsilon * (pairs.position.size() > 0 ? pairs.position.cwiseAbs().maxCoeff() : 0);
}

/// A contact has a few rows, as long as all bodies have unknowns.
///
/// Eigen makes such a matrix in two passes. The first sorts entries by columns, and looks at each
/// column of the matrix, whether it has entries or not. One contact between two of a thousand
/// blocks has 5 rows of 18 000 columns, with 20 entries in all. A thousand contacts would look at
/// 18 million empty columns.
///
/// Entries that are sorted by rows need not know how many columns there are. Those in one place are
/// added in the order in which they came, as Eigen adds them, so the sums have the same bits. No
/// entries at all is a usual case, such as the slips of a contact without friction.
NodalRows rows_of(Triplets entries, Index rows, Index columns) {
  std::stable_sort(entries.begin(), entries.end(), [](const auto& one, const auto& other) {
    return std::pair(one.row(), one.col()) < std::pair(other.row(), other.col());
  });
  // Rows are filled one after the other, from left to right: nothing that is there has to move.
  NodalRows result(rows, columns);
  result.reserve(static_cast<Index>(entries.size()));
  auto entry = entries.begin();
  for (Index row = 0; row < rows; ++row) {
    result.startVec(row);
    for (Index last = -1; entry != entries.end() && entry->row() == row; ++entry) {
      if (entry->col() != last)
        result.insertBack(row, last = entry->col()) = entry->value();
      else
        result.data().value(result.data().size() - 1) += entry->value();
    }
  }
  result.finalize();
  return result;
}

/// First all openings are read, to know which pairs remain; then the rows of the pairs that do.
/// Normals, weights and positions follow their pairs. The columns of held components are kept in
/// `opening` and `sliding`: the force of a support is read from them when the contact forces are
/// known.
Gaps reduce(const Pairs& pairs, const Surface& source, const Unknowns& unknowns,
            double directions) {
  std::vector<FreeRow> openings;
  for (Index pair = 0; pair < pairs.initial_gap.size(); ++pair)
    openings.push_back(free_row(pairs.opening, pair, unknowns, directions));
  Gaps gaps;
  sort_pairs(pairs, openings, source, gaps);
  const std::vector<Index>& kept = gaps.kept;
  const Index n_pairs = static_cast<Index>(kept.size());
  const bool slides = pairs.sliding.rows() > 0;
  gaps.pairs = selected(pairs, kept, source);
  // Slips that supports prescribe are there from the beginning, like gaps.
  gaps.initial_slip.resize(slides ? n_pairs : 0);
  Triplets normal;
  Triplets tangential;
  for (Index row = 0; row < n_pairs; ++row) {
    const Index pair = kept[static_cast<std::size_t>(row)];
    const FreeRow& opening = openings[static_cast<std::size_t>(pair)];
    // What supports open or close has no column; it goes to the initial gap.
    append(normal, row, opening, -1);
    gaps.pairs.initial_gap(row) += opening.held;
    if (!slides) continue;
    const FreeRow sliding = free_row(pairs.sliding, pair, unknowns, directions);
    append(tangential, row, sliding, 1);
    gaps.initial_slip(row) = sliding.held + (pairs.slid.size() > 0 ? pairs.slid(pair) : 0);
  }
  gaps.A = rows_of(std::move(normal), n_pairs, unknowns.count);
  gaps.T = rows_of(std::move(tangential), slides ? n_pairs : 0, unknowns.count);
  return gaps;
}

/// Friction uses it: only some pairs rub, and only those get a row for their slip.
NodalRows selected_rows(const NodalRows& rows, const std::vector<Index>& kept) {
  Triplets entries;
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (NodalRows::InnerIterator it(rows, kept[k]); it; ++it)
      entries.emplace_back(static_cast<int>(k), static_cast<int>(it.col()), it.value());
  return rows_of(std::move(entries), static_cast<Index>(kept.size()), rows.cols());
}

/// A scene with several contacts has one list of pairs. A matrix without rows may come from a
/// contact without friction, which has no slips; then the other one stays as it is.
NodalRows below(const NodalRows& upper, const NodalRows& lower) {
  if (upper.rows() == 0 && upper.cols() <= lower.cols()) return lower;
  Triplets entries;
  const auto add = [&](const NodalRows& rows, Index first) {
    for (Index row = 0; row < rows.rows(); ++row)
      for (NodalRows::InnerIterator it(rows, row); it; ++it)
        entries.emplace_back(static_cast<int>(first + row), static_cast<int>(it.col()), it.value());
  };
  add(upper, 0);
  add(lower, upper.rows());
  return rows_of(std::move(entries), upper.rows() + lower.rows(),
                 std::max(upper.cols(), lower.cols()));
}

}  // namespace signorini

// Two sides that hold together: the rows of their gaps and slips, as equations.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/contact_input.hpp"
#include "signorini/scene/pair_up.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// Of a row that is a combination, what is left of entries that cancel.
constexpr double left_over = 1e-14;

bool held(const Plan& draft, Index component) {
  return draft.unknowns.number(component / 2, component % 2) < 0;
}

/// A combination of the rows of a pair.
Equation combined_rows(const Pairs& pairs, const NodalRows& slips, Index pair, double opening,
                  double sliding) {
  const Eigen::SparseVector<double> row =
      opening * pairs.opening.row(pair).transpose() + sliding * slips.row(pair).transpose();
  const double most = row.nonZeros() > 0 ? row.coeffs().abs().maxCoeff() : 0;
  Equation equation;
  for (Eigen::SparseVector<double>::InnerIterator entry(row); entry; ++entry)
    if (std::abs(entry.value()) > left_over * most)
      equation.terms.emplace_back(entry.index(), entry.value());
  equation.right = -opening * pairs.initial_gap(pair);
  equation.rounding = (std::abs(opening) + std::abs(sliding)) * gap_rounding(pairs);
  equation.parts = {{pair, opening, sliding}};
  return equation;
}

/// Whether supports take the place of a row: they hold its node, and part of what this faces. If they hold all of that, the row
/// says whether they close the gap.
bool between_supports(const Plan& draft, const Equation& row) {
  Index faced = 0;
  Index given = 0;
  for (const auto& [component, value] : row.terms) {
    if (component / 2 == row.own / 2) continue;
    ++faced;
    if (held(draft, component)) ++given;
  }
  return held(draft, row.own) && given > 0 && given < faced;
}

/// The rows of a pair: one along its normal, or one along each axis, so that a support that holds a node along x takes the
/// place of one of them.
std::vector<Equation> rows_of(const Pairs& pairs, const NodalRows& slips, Index pair, Index node,
                              const Plan& draft, bool slides) {
  const Vector2d n = pairs.normal.row(pair).transpose();
  std::vector<Equation> rows;
  if (slides) {
    rows.push_back(combined_rows(pairs, slips, pair, 1, 0));
    const int across = std::abs(n.y()) >= std::abs(n.x()) ? 1 : 0;
    const bool other = held(draft, 2 * node + across) && std::abs(n(1 - across)) > left_over;
    rows.back().own = 2 * node + (other ? 1 - across : across);
    return rows;
  }
  const double size = n.squaredNorm();
  rows.push_back(combined_rows(pairs, slips, pair, n.x() / size, n.y() / size));
  rows.push_back(combined_rows(pairs, slips, pair, n.y() / size, -n.x() / size));
  for (int axis = 0; axis < 2; ++axis) rows[at(axis)].own = 2 * node + axis;
  return rows;
}

/// Adds a row, times a factor.
void add_row(const Equation& row, double factor, Equation& sum) {
  std::map<Index, double> terms(sum.terms.begin(), sum.terms.end());
  for (const auto& [component, value] : row.terms) terms[component] += factor * value;
  sum.terms.assign(terms.begin(), terms.end());
  sum.right += factor * row.right;
  sum.rounding += std::abs(factor) * row.rounding;
  for (const RowPart& part : row.parts)
    sum.parts.push_back({part.pair, factor * part.opening, factor * part.sliding});
}

/// The nodes of a side of cells next to one of its ends.
std::vector<Index> next_along(const Surface& source, Index end) {
  std::vector<Index> next;
  for (const CellSide& side : boundary(source.mesh, source.boundary)) {
    const std::vector<Index> nodes = source.mesh.side_nodes(side);
    if (source.first_node + nodes.front() == end) next.push_back(source.first_node + nodes[1]);
    if (source.first_node + nodes.back() == end) next.push_back(source.first_node + nodes[nodes.size() - 2]);
  }
  return next;
}

/// Some rows bear nothing: they are left out, or supports hold all of their nodes. What they would bear, the rows of the nearest
/// nodes on both sides bear that can. Without that a uniform traction would lack a part, and sides whose ends are held would fail the
/// patch test. The sum of mortar rows is that of their integrals.
/// Where there are none, because supports hold all nodes of the source, a row that was left out holds what it faces after all.
/// \param slides  whether each node has one row, along its normal
void hand_on(const Surface& source, const Plan& draft, bool slides, Bond& bond, std::vector<Equation>& rows) {
  const auto weight = [&](const Equation& row) { return bond.pairs.weight(row.parts.front().pair); };
  const auto is_held = [&](const Equation& row) {
    return std::all_of(row.terms.begin(), row.terms.end(), [&](const auto& term) { return held(draft, term.first); });
  };
  std::vector<Equation> idle = bond.left_out;
  std::copy_if(rows.begin() + static_cast<std::ptrdiff_t>(bond.first), rows.end(), std::back_inserter(idle), is_held);
  bond.left_out.clear();
  std::vector<Equation> alone;
  for (const Equation& left : idle) {
    std::vector<Equation*> heirs;
    std::vector<Index> seen = {left.own / 2};
    for (std::size_t k = 0; k < seen.size(); ++k)
      for (const Index node : next_along(source, seen[k])) {
        const auto heir = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(bond.first), rows.end(),
                                       [&](const Equation& row) {
                                         return row.own / 2 == node && (slides || row.own % 2 == left.own % 2);
                                       });
        if (heir != rows.end() && !is_held(*heir) && weight(*heir) > 0)
          heirs.push_back(&*heir);
        else if (std::find(seen.begin(), seen.end(), node) == seen.end())
          seen.push_back(node);
      }
    for (Equation* const heir : heirs)
      add_row(left, weight(left) / (weight(*heir) * static_cast<double>(heirs.size())), *heir);
    if (!is_held(left)) (heirs.empty() ? alone : bond.left_out).push_back(left);
  }
  rows.insert(rows.end(), alone.begin(), alone.end());
}

/// What is done about gaps of the meshes, in words for the plan; nothing if there are none.
std::string fit(const Tie& tie, Bond& bond) {
  Pairs& pairs = bond.pairs;
  const double rounding = gap_rounding(pairs);
  const Eigen::ArrayXd gap = pairs.initial_gap;
  const double apart = gap.size() > 0 ? gap.abs().maxCoeff() : 0;
  const bool closes = tie.closes && !tie.stiffness;
  pairs.initial_gap = (gap.abs() <= (closes ? rounding : apart)).select(0, gap);
  if (apart <= rounding) return "";
  bond.apart = closes ? 0 : apart;
  return text(", gaps and overlaps of up to ", apart,
              closes ? " closed"
                     : " stay, and a force along the sides lacks its moment across them: closes = "
                       "true has neither");
}

/// Nodes that no row holds: the side is longer than what it faces.
void note_unpaired(const std::string& what, const Pairs& pairs, Plan& draft) {
  if (!pairs.unpaired.empty())
    draft.notes.push_back(text(what, ": ", pairs.unpaired.size(),
                               pairs.unpaired.size() == 1 ? " node faces" : " nodes face",
                               " no target and ",
                               pairs.unpaired.size() == 1 ? "holds" : "hold", " nothing"));
}

void check_tie(const ContactSpec& sides, const std::string& what, const Pairs& pairs) {
  require_input(!sides.friction && !sides.interference && !sides.adjust, what,
                ": friction, interference and adjusted gaps are those of a contact: leave them out");
  require_input(
      std::none_of(pairs.node.begin(), pairs.node.end(), [](Index node) { return node < 0; }), what,
      ": the operator ", sides.gap_operator,
      " has more pairs than the nodes of a side can follow: take mortar or node_to_segment");
}

std::string name_of(const Tie& tie, const Plan& draft) {
  std::string name = contact_names(draft.bodies, {tie.sides}).front();
  return name.replace(name.find(" on "), 4, tie.slides ? " along " : " to ");
}

/// Springs along the normal and along the tangent of each pair, at rest as the meshes are.
void add_springs(const Vector2d& stiffness, const Bond& bond, const NodalRows& slips,
                 std::vector<Equation>& rows) {
  require_input(stiffness.allFinite() && stiffness.minCoeff() >= 0, bond.what,
                ": a stiffness must be a number >= 0, got (", stiffness.x(), ", ", stiffness.y(), ')');
  for (Index pair = 0; pair < bond.pairs.weight.size(); ++pair)
    for (const int across : {0, 1}) {
      if (stiffness(across) == 0) continue;
      rows.push_back(combined_rows(bond.pairs, slips, pair, 1 - across, across));
      rows.back().stiffness = stiffness(across) * bond.pairs.weight(pair);
    }
}

}  // namespace

void add_tie(const Tie& tie, Plan& draft, Equations& all) {
  Bond bond;
  bond.what = describe(draft.bodies, tie.sides)
                  .replace(0, 7, tie.stiffness ? "elastic tie" : tie.slides ? "sliding tie" : "tie");
  bond.name = name_of(tie, draft);
  bond.pairs = pair_up(tie.sides, draft.bodies, false, nullptr);
  check_tie(tie.sides, bond.what, bond.pairs);
  check_obstacle_side(tie.sides, draft.bodies, bond.pairs);
  const std::string fitted = fit(tie, bond);
  note_unpaired(bond.what, bond.pairs, draft);
  const NodalRows slips = turned(bond.pairs.opening);
  bond.sides = std::make_shared<const ContactSpec>(tie.sides);
  const Index first_node = draft.bodies[body_index(draft.bodies, tie.sides.source)].first_node;
  bond.first = all.rows.size();
  if (tie.stiffness) add_springs(*tie.stiffness, bond, slips, all.rows);
  for (Index pair = 0; pair < bond.pairs.initial_gap.size() && !tie.stiffness; ++pair) {
    const Index node = first_node + bond.pairs.node[at(pair)];
    for (Equation& row : rows_of(bond.pairs, slips, pair, node, draft, tie.slides))
      (between_supports(draft, row) ? bond.left_out : all.rows).push_back(std::move(row));
  }
  if (!tie.stiffness && find_gap_operator(tie.sides.gap_operator).passes_patch_test)
    hand_on(surface(draft.bodies, tie.sides.source), draft, tie.slides, bond, all.rows);
  bond.end = all.rows.size();
  const bool rigid = std::holds_alternative<Obstacle>(tie.sides.target);
  draft.on.push_back(text(bond.what, ": ", bond.end - bond.first,
                          tie.stiffness ? " springs" : " equations",
                          rigid ? std::string() : " by " + tie.sides.gap_operator, fitted));
  all.bonds.push_back(std::move(bond));
}

}  // namespace signorini

#include "addons/estimate/marking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "addons/estimate/contact_edges.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Edges of all bodies, none marked.
std::vector<MarkedEdges> unmarked(const Model& model) {
  std::vector<MarkedEdges> marks;
  for (const BodyModel& body : model.bodies) marks.push_back(marked_alike(body.mesh, 0));
  return marks;
}

/// The side of a source between two neighbouring pairs.
struct PairSide {
  std::size_t body;  ///< number
  Index edge;        ///< of its mesh
  ContactEdge pairs;
};

std::vector<PairSide> pair_sides(const Model& model, const std::vector<MarkedEdges>& marks) {
  std::vector<PairSide> sides;
  for (const ContactEdge& pairs : contact_edges(model)) {
    const std::size_t b = source_index(model, pairs.from);
    sides.push_back({b, marks[b].edges.at(pairs.side), pairs});
  }
  return sides;
}

std::vector<char> closed_pairs(const Model& model, const Solution& solution) {
  std::vector<char> closed(at(model.pairs.weight.size()), 0);
  for (const Index pair : solution.contact.active) closed[at(pair)] = 1;
  return closed;
}

/// Shares of the error, edge by edge of each body.
using EdgeShares = std::vector<std::vector<double>>;

void add_cells(const Model& model, const std::vector<MarkedEdges>& marks, const Estimate& estimate,
               EdgeShares& shares) {
  double sum = 0;
  for (const Eigen::VectorXd& share : estimate.share) sum += share.lpNorm<1>();
  if (sum == 0) return;
  const double scale = std::abs(estimate.parts.interior) / sum;
  for (std::size_t b = 0; b < marks.size(); ++b) {
    const Mesh& mesh = model.bodies[b].mesh;
    for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
      const double share = scale * std::abs(estimate.share[b](cell));
      const double first = estimate.first_direction[b](cell);
      const auto add = [&](int side, double part) {
        shares[b][at(marks[b].edges.at({cell, side}))] += part;
      };
      if (mesh.corners(cell) == 3) {
        add(longest_side(mesh, cell), share);
      } else {
        add(0, first * share);
        add(1, (1 - first) * share);
      }
    }
  }
}

void add_contact(const Model& model, const Solution& solution, const Estimate& estimate,
                 const std::vector<PairSide>& sides, EdgeShares& shares) {
  const std::vector<char> closed = closed_pairs(model, solution);
  const ErrorParts& parts = estimate.parts;
  double cubes = 0;
  double ends = 0;
  const auto each = [&](auto&& inside, auto&& end) {
    for (const PairSide& side : sides) {
      const int both = closed[at(side.pairs.from)] + closed[at(side.pairs.to)];
      if (both == 2) inside(side);
      if (both == 1) end(side);
    }
  };
  each([&](const PairSide& side) { cubes += std::pow(side.pairs.length, 3); },
       [&](const PairSide&) { ++ends; });
  each(
      [&](const PairSide& side) {
        shares[side.body][at(side.edge)] +=
            (std::abs(parts.gap) + std::abs(parts.quadrature_error)) *
            std::pow(side.pairs.length, 3) / cubes;
      },
      [&](const PairSide& side) {
        shares[side.body][at(side.edge)] += std::abs(parts.free_boundary) / ends;
      });
}

/// The sides that the outline leaves; what cancels in their sum counts in none of them.
void add_outline(const std::vector<MarkedEdges>& marks, const Estimate& estimate,
                 EdgeShares& shares) {
  double sum = 0;
  for (const std::vector<SideShare>& body : estimate.of_sides)
    for (const SideShare& side : body) sum += std::abs(side.amount);
  if (sum == 0) return;
  const double scale = std::abs(estimate.parts.outline) / sum;
  for (std::size_t b = 0; b < marks.size(); ++b)
    for (const SideShare& side : estimate.of_sides[b])
      shares[b][at(marks[b].edges.at(side.side))] += scale * std::abs(side.amount);
}

/// Marks what is one cell thick, see marks_where_coarse(). \return whether there is such a place
bool mark_thin(const Mesh& mesh, MarkedEdges& marks) {
  const std::vector<std::array<CellSide, 2>>& sides = marks.edges.sides;
  std::vector<char> outside(at(mesh.n_nodes()), 0);
  for (const std::array<CellSide, 2>& edge : sides)
    if (edge[1].cell < 0)
      for (const Index node : mesh.side_nodes(edge[0])) outside[at(node)] = 1;
  const auto any_corner = [&](Index cell, auto&& holds) {
    for (int k = 0; k < mesh.corners(cell); ++k)
      if (holds(mesh.cells(cell, k))) return true;
    return false;
  };
  std::vector<char> reached(at(mesh.n_nodes()), 0);  // corners of cells that have one inside
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    if (any_corner(cell, [&](Index node) { return outside[at(node)] == 0; }))
      for (int k = 0; k < mesh.corners(cell); ++k) reached[at(mesh.cells(cell, k))] = 1;
  bool any = false;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    if (any_corner(cell, [&](Index node) { return reached[at(node)] != 0; })) continue;
    any = true;
    const auto inside = [&](int side) {
      return sides[at(marks.edges.at({cell, side}))][1].cell >= 0;
    };
    bool alone = true;
    for (int side = 0; side < mesh.corners(cell); ++side) alone = alone && !inside(side);
    for (int side = 0; side < mesh.corners(cell); ++side)
      if (alone || inside(side)) marks.halved[at(marks.edges.at({cell, side}))] = 1;
  }
  return any;
}

/// A chord that may be halved.
struct Candidate {
  double gain;  ///< what it loses for a new node
  std::size_t body;
  Index chord;
  double share;  ///< of the error that falls to it now
  double nodes;  ///< that halving it adds

  bool operator<(const Candidate& other) const {
    return std::tie(gain, other.body, other.chord) < std::tie(other.gain, body, chord);
  }
};

/// The chords of all bodies, the one first whose halving pays most.
struct Chords {
  std::vector<std::vector<Index>> of_edge;  ///< the chord of each edge, body by body
  std::vector<std::vector<char>> halved;    ///< how often each chord is
  double share = 0;                         ///< of the error, on all of them
  std::priority_queue<Candidate> queue;

  void add_body(const Mesh& mesh, const MeshEdges& edges, const std::vector<double>& shares) {
    // Of three nodes per side: two more on it, and the middle of the edge that leaves it.
    const double per_edge = mesh.order() == MeshOrder::Quadratic ? 3 : 1;
    const std::vector<Index>& own = of_edge.emplace_back(refinement_lines(mesh, edges));
    const std::size_t count = at(1 + *std::max_element(own.begin(), own.end()));
    halved.emplace_back(count, 0);
    std::vector<double> of_chord(count, 0);
    std::vector<double> nodes(count, 0);
    for (std::size_t e = 0; e < own.size(); ++e) {
      of_chord[at(own[e])] += shares[e];
      nodes[at(own[e])] += per_edge;
    }
    for (std::size_t c = 0; c < count; ++c) {
      share += of_chord[c];
      queue.push({of_chord[c] / nodes[c], of_edge.size() - 1, static_cast<Index>(c), of_chord[c],
                  nodes[c]});
    }
  }

  /// Whether halving helps. \return a chord has a share of the error
  [[nodiscard]] bool any() const { return !queue.empty() && queue.top().share != 0; }

  /// Halves the first chord. A quarter of its error stays. \return how many nodes are new
  double halve_worst() {
    Candidate next = queue.top();
    queue.pop();
    const double nodes = next.nodes;
    char& times = halved[next.body][at(next.chord)];
    ++times;
    share -= 0.75 * next.share;
    next.share /= 4;
    next.nodes *= 2;
    next.gain = next.share / next.nodes;
    if (times < std::numeric_limits<char>::max()) queue.push(next);
    return nodes;
  }
};

}  // namespace

std::vector<MarkedEdges> mark_elements(const Model& model, const Solution& solution,
                                       const Estimate& estimate, double part, double growth) {
  std::vector<MarkedEdges> marks = unmarked(model);
  EdgeShares shares;
  for (const MarkedEdges& body : marks) shares.emplace_back(body.edges.size(), 0.0);
  add_cells(model, marks, estimate, shares);
  add_contact(model, solution, estimate, pair_sides(model, marks), shares);
  add_outline(marks, estimate, shares);
  Chords chords;
  double missing = 0;  // new nodes
  for (std::size_t b = 0; b < marks.size(); ++b) {
    missing += (growth - 1) * static_cast<double>(model.bodies[b].mesh.n_nodes());
    chords.add_body(model.bodies[b].mesh, marks[b].edges, shares[b]);
  }
  const double enough = part * chords.share;
  while ((chords.share > enough || missing > 0) && chords.any()) missing -= chords.halve_worst();
  for (std::size_t b = 0; b < marks.size(); ++b)
    for (std::size_t e = 0; e < chords.of_edge[b].size(); ++e)
      marks[b].halved[e] = chords.halved[b][at(chords.of_edge[b][e])];
  return marks;
}

std::vector<MarkedEdges> marks_where_coarse(const Model& model, const Solution& solution,
                                            std::size_t few) {
  std::vector<MarkedEdges> marks = unmarked(model);
  bool any = false;
  for (std::size_t b = 0; b < marks.size(); ++b)
    any = mark_thin(model.bodies[b].mesh, marks[b]) || any;
  std::vector<std::size_t> count(model.contacts.size(), 0);
  for (const Index pair : solution.contact.active) ++count[model.contact_of[at(pair)]];
  const std::vector<char> closed = closed_pairs(model, solution);
  const std::vector<Index>& node = model.pairs.node;
  const bool nodal = std::none_of(node.begin(), node.end(), [](Index n) { return n < 0; });
  for (const PairSide& side : nodal ? pair_sides(model, marks) : std::vector<PairSide>()) {
    const bool presses = closed[at(side.pairs.from)] != 0 || closed[at(side.pairs.to)] != 0;
    char times = 0;
    for (std::size_t own = count[model.contact_of[at(side.pairs.from)]]; presses && own < few;
         own = std::max(own + 1, 2 * own - 1))
      ++times;
    char& mark = marks[side.body].halved[at(side.edge)];
    mark = std::max(mark, times);
    any = any || times > 0;
  }
  if (!any) marks.clear();
  return marks;
}

}  // namespace signorini

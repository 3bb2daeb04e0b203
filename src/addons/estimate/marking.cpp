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
  for (const Index pair : solution.contact.active()) closed[at(pair)] = 1;
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

/// What lies beside the sides of the cells of a body.
struct Neighbours {
  const BodyModel& body;
  const MarkedEdges& marks;

  /// Whether a cell of the same material, whose stress is recovered with it, lies beyond a side.
  [[nodiscard]] bool inside(const std::array<CellSide, 2>& edge) const {
    const MaterialField& material = body.material;
    return edge[1].cell >= 0 && material.number(edge[0].cell) == material.number(edge[1].cell);
  }
  [[nodiscard]] bool inside(const CellSide& side) const {
    return inside(marks.edges.sides[at(marks.edges.at(side))]);
  }
  /// Whether any corner of a cell is marked.
  [[nodiscard]] bool any_corner(Index cell, const std::vector<char>& marked) const {
    for (int k = 0; k < body.mesh.corners(cell); ++k)
      if (marked[at(body.mesh.cells(cell, k))] != 0) return true;
    return false;
  }
};

/// The cells of one material that have a corner inside it, or share one with such a cell.
std::vector<char> resolved_cells(const Neighbours& beside) {
  const Mesh& mesh = beside.body.mesh;
  const MaterialField& material = beside.body.material;
  std::vector<char> within(at(mesh.n_nodes()), 1);
  for (const std::array<CellSide, 2>& edge : beside.marks.edges.sides)
    if (!beside.inside(edge))
      for (const Index node : mesh.side_nodes(edge[0])) within[at(node)] = 0;
  std::vector<char> resolved(at(mesh.n_cells()), 0);
  for (std::size_t number = 0; number <= material.others.size(); ++number) {
    std::vector<char> reached(at(mesh.n_nodes()), 0);  // corners of cells that have one inside
    const auto each = [&](auto&& visit) {
      for (Index cell = 0; cell < mesh.n_cells(); ++cell)
        if (material.number(cell) == number) visit(cell);
    };
    each([&](Index cell) {
      if (beside.any_corner(cell, within))
        for (int k = 0; k < mesh.corners(cell); ++k) reached[at(mesh.cells(cell, k))] = 1;
    });
    each([&](Index cell) { resolved[at(cell)] = beside.any_corner(cell, reached) ? 1 : 0; });
  }
  return resolved;
}

/// Marks what is one cell thick, see marks_where_coarse(). \return whether there is such a place
bool mark_thin(const BodyModel& body, MarkedEdges& marks) {
  const Neighbours beside{body, marks};
  const std::vector<char> resolved = resolved_cells(beside);
  bool any = false;
  for (Index cell = 0; cell < body.mesh.n_cells(); ++cell) {
    if (resolved[at(cell)] != 0) continue;
    any = true;
    const int corners = body.mesh.corners(cell);
    bool alone = true;
    for (int side = 0; side < corners; ++side)
      alone = alone && !beside.inside(CellSide{cell, side});
    for (int side = 0; side < corners; ++side)
      if (alone || beside.inside(CellSide{cell, side}))
        marks.halved[at(marks.edges.at({cell, side}))] = 1;
  }
  return any;
}

/// A line that may be halved.
struct Candidate {
  double gain;  ///< what it loses for a new node
  std::size_t body;
  Index line;
  double share;  ///< of the error that falls to it now
  double nodes;  ///< that halving it adds

  bool operator<(const Candidate& other) const {
    return std::tie(gain, other.body, other.line) < std::tie(other.gain, body, line);
  }
};

/// The lines of all bodies, the one first whose halving pays most.
struct RefinementLines {
  std::vector<std::vector<Index>> of_edge;  ///< the line of each edge, body by body
  std::vector<std::vector<char>> halved;    ///< how often each line is
  double share = 0;                         ///< of the error, on all of them
  std::priority_queue<Candidate> queue;

  void add_body(const Mesh& mesh, const MeshEdges& edges, const std::vector<double>& shares) {
    // Of three nodes per side: two more on it, and the middle of the edge that leaves it.
    const double per_edge = mesh.order() == MeshOrder::Quadratic ? 3 : 1;
    const std::vector<Index>& own = of_edge.emplace_back(refinement_lines(mesh, edges));
    const std::size_t count = at(1 + *std::max_element(own.begin(), own.end()));
    halved.emplace_back(count, 0);
    std::vector<double> of_line(count, 0);
    std::vector<double> nodes(count, 0);
    for (std::size_t e = 0; e < own.size(); ++e) {
      of_line[at(own[e])] += shares[e];
      nodes[at(own[e])] += per_edge;
    }
    for (std::size_t c = 0; c < count; ++c) {
      share += of_line[c];
      queue.push({of_line[c] / nodes[c], of_edge.size() - 1, static_cast<Index>(c), of_line[c],
                  nodes[c]});
    }
  }

  /// Whether halving helps. \return a line has a share of the error
  [[nodiscard]] bool any() const { return !queue.empty() && queue.top().share != 0; }

  /// Halves the first line. A quarter of its error stays. \return how many nodes are new
  double halve_worst() {
    Candidate next = queue.top();
    queue.pop();
    const double nodes = next.nodes;
    char& times = halved[next.body][at(next.line)];
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
  RefinementLines lines;
  double missing = 0;  // new nodes
  for (std::size_t b = 0; b < marks.size(); ++b) {
    missing += (growth - 1) * static_cast<double>(model.bodies[b].mesh.n_nodes());
    lines.add_body(model.bodies[b].mesh, marks[b].edges, shares[b]);
  }
  const double enough = part * lines.share;
  while ((lines.share > enough || missing > 0) && lines.any()) missing -= lines.halve_worst();
  for (std::size_t b = 0; b < marks.size(); ++b)
    for (std::size_t e = 0; e < lines.of_edge[b].size(); ++e)
      marks[b].halved[e] = lines.halved[b][at(lines.of_edge[b][e])];
  return marks;
}

std::vector<MarkedEdges> marks_where_coarse(const Model& model, const Solution& solution,
                                            std::size_t few) {
  std::vector<MarkedEdges> marks = unmarked(model);
  bool any = false;
  for (std::size_t b = 0; b < marks.size(); ++b) any = mark_thin(model.bodies[b], marks[b]) || any;
  std::vector<std::size_t> count(model.contacts.size(), 0);
  for (const Index pair : solution.contact.active()) ++count[model.contact_of[at(pair)]];
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

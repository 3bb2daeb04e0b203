// # Gaps as means over edges
//
// Node to segment puts the force of a node at one place of the target. A pressure is spread out,
// and so its work on the target should be an integral:
//
// \f[ \int p\,g\,d\Gamma \quad\text{with}\quad p = \sum_i p_i\,\psi_i, \qquad
//     \lambda_i = p_i w_i, \quad g_i = \frac1{w_i}\int\psi_i\,g\,d\Gamma. \f]
//
// Take a source edge from \f$x = 0\f$ to 2 above a target with nodes at 0, 1.5 and 3, and the
// pressure 1. The nodes of the target should get the integrals of their shape functions over
// \f$[0, 2]\f$: 0.75, 1.167 and 0.083. These are what the rows below give. Node to segment gives
// 1, 0.667 and 0.333, with the same sum and the same moment. A patch test shows the difference.
//
// Weights with negative parts look odd: the row of the node at 0 has \f$-0.9375\f$, \f$-0.125\f$
// and \f$+0.0625\f$ on the target. They add up to \f$-1\f$, and a uniform pressure uses sums of
// rows, in which the odd signs cancel.

#include "signorini/pairing/mortar.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "signorini/core/errors.hpp"
#include "signorini/pairing/mortar_segments.hpp"
#include "signorini/pairing/pair_rows.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Adds what the points of one edge count in the gaps of its two nodes, which stand for the numbers
/// of the pairs, and the integrals of psi_i to the weights.
// [edge]
void collect(const SourceEdge& edge, const EdgeSamples& samples, std::vector<PairPoint>& points,
             std::map<Index, double>& weights) {
  std::vector<EdgePoint> covered;
  for (const FacingPoint& point : samples.facing) covered.push_back(point.at);
  const DualBasis basis = dual_basis(covered, samples.share);
  for (const Index i : {0, 1}) {
    if (basis.mean(i) == 0) continue;  // nothing covered, or handed to the other end
    const Index node = edge.nodes[static_cast<std::size_t>(i)];
    weights[node] += basis.length * basis.mean(i);
    for (const FacingPoint& point : samples.facing)
      points.push_back(
          {node, edge.side, point.xi, point.target, point.at.length * basis.value(point.at.s)(i)});
  }
}
// [edge]

// Weights are sums, too: a node has two edges, and only when both are collected is it known what a
// point is a share of. So lists grow first, and numbers follow.

/// What the edges of a source have collected. Nodes stand for the numbers of pairs.
struct Collected {
  std::vector<PairPoint> points;
  std::map<Index, double> weights;
};

/// Edge by edge: cut it into segments, sample them, make the dual functions of what is covered, and
/// collect.
Collected sample(const Interface& interface, const GapOptions& options, int n_points) {
  Collected all;
  std::vector<std::vector<double>> cuts(interface.sides.size());
  if (options.quadrature == Quadrature::Segments) cuts = segment_cuts(interface);
  for (std::size_t k = 0; k < cuts.size(); ++k)
    for (const SourceEdge& edge : edges_of(interface.sides[k]))
      collect(edge, sample_edge(edge, interface, cuts[k], n_points), all.points, all.weights);
  return all;
}

/// Leaves out the nodes all of whose points are farther off than a reach. If there are no others, they stay.
void leave_out_far(double reach, Collected& all) {
  std::set<Index> near;
  for (const PairPoint& point : all.points)
    if (point.place.gap <= reach) near.insert(point.pair);
  if (near.empty()) return;
  const auto far = [&](const PairPoint& point) { return near.count(point.pair) == 0; };
  all.points.erase(std::remove_if(all.points.begin(), all.points.end(), far), all.points.end());
  for (auto it = all.weights.begin(); it != all.weights.end();)
    it = near.count(it->first) == 0 ? all.weights.erase(it) : ++it;
}

/// Until here a point knows its node. Nodes without weight have dropped out, so pairs are counted
/// anew.
Eigen::VectorXd number(const std::vector<Index>& nodes, Collected& all) {
  std::map<Index, Index> pair_of;
  Eigen::VectorXd total(static_cast<Index>(nodes.size()));
  for (Index pair = 0; pair < total.size(); ++pair) {
    const Index node = nodes[static_cast<std::size_t>(pair)];
    pair_of[node] = pair;
    total(pair) = all.weights.at(node);
  }
  for (PairPoint& point : all.points) point.pair = pair_of.at(point.pair);
  return total;
}

}  // namespace

// On straight sides two points per segment are exact. Along parabolas the integrand is no polynomial, and
// a third point is worth its price; more of them would only resolve what the pressure, a line
// between two nodes, cannot follow.

/// First all edges, then numbers, then rows: a node collects from two edges.
Pairs mortar(const Surface& source, const Surface& target, const GapOptions& options) {
  require_input(options.points >= 0 && options.points <= 16,
                "mortar: there are rules of 1 to 16 points (0: its own choice), got ",
                options.points);
  const Interface interface(source, target, options);
  const bool curved =
      source.mesh.order() == MeshOrder::Quadratic || target.mesh.order() == MeshOrder::Quadratic;
  const int own = options.quadrature == Quadrature::Segments && curved ? 3 : 2;
  Collected all = sample(interface, options, options.points > 0 ? options.points : own);
  if (std::isfinite(options.reach)) leave_out_far(options.reach, all);
  Pairs pairs;
  for (const Index node : boundary_nodes(source.mesh, source.boundary))
    (all.weights.count(node) != 0 ? pairs.node : pairs.unpaired).push_back(node);
  interface.check_paired(pairs.node.size());
  const Eigen::VectorXd total = number(pairs.node, all);
  pairs.position = source.mesh.nodes(pairs.node, Eigen::all);
  pairs.weight = options.depth.factor * total;
  write_rows(interface, all.points, total, options, pairs);
  return pairs;
}

namespace gap_operator {

GapOperator mortar() {
  GapOperator member{"mortar", "gaps weighted over the edges around every node of the source",
                     signorini::mortar};
  member.passes_patch_test = true;
  member.takes_points = true;
  member.takes_quadrature = true;
  return member;
}

}  // namespace gap_operator

}  // namespace signorini

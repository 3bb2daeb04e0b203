#include "signorini/contact/mortar.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "signorini/contact/mortar_segments.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// What the corners of the source collect from the edges: integrals of psi_i times something.
class Collector {
 public:
  Collector(const Interface& interface, bool sliding);

  /// Adds psi_i of one point of an edge, times the point's gap and motion, to both corners.
  void add(const SideCurve& edge, const FacingPoint& point, const SideCurve& facing,
           const Vector2d& psi);
  /// Adds the integrals of psi_i over an edge, which is bare if they are zero.
  void add_weight(const SideCurve& edge, const DualBasis& basis);
  /// Divides by the weights.
  [[nodiscard]] Pairs pairs(const Surface& source, const GapOptions& options) const;

 private:
  struct Sums {
    double weight = 0;
    double gap = 0;
    Vector2d normal = Vector2d::Zero();
    std::map<Index, double> opening, sliding;  // by column
  };
  /// Adds what the motion of a node does to the pair of a corner.
  void move(Sums& sums, Index node, double amount, const Vector2d& normal) const;

  Index source_first_, target_first_;
  bool sliding_;
  std::map<Index, Sums> sums_;  // by corner of the source
  std::set<Index> bare_;        // midpoints of edges that face nothing
};

Collector::Collector(const Interface& interface, bool sliding)
    : source_first_(interface.source().first_node),
      target_first_(interface.target().first_node),
      sliding_(sliding) {
  for (const SideCurve& edge : interface.source_sides())
    for (const Index node : {edge.nodes().front(), edge.nodes().back()}) sums_.try_emplace(node);
}

void Collector::move(Sums& sums, Index node, double amount, const Vector2d& normal) const {
  for (Index axis = 0; axis < 2; ++axis) {
    sums.opening[2 * node + axis] += amount * normal(axis);
    if (sliding_) sums.sliding[2 * node + axis] += amount * (axis == 0 ? normal(1) : -normal(0));
  }
}

void Collector::add(const SideCurve& edge, const FacingPoint& point, const SideCurve& facing,
                    const Vector2d& psi) {
  const SideShape N = edge.shape(point.at.s);
  const SideShape M = facing.shape(point.target.xi);
  const std::size_t corner[2] = {0, edge.nodes().size() - 1};
  for (Index i = 0; i < 2; ++i) {
    const double amount = point.at.length * psi(i);
    if (amount == 0) continue;
    Sums& sums = sums_.at(edge.nodes()[corner[i]]);
    sums.gap += amount * point.target.gap;
    sums.normal += amount * point.target.normal;
    for (std::size_t k = 0; k < edge.nodes().size(); ++k)
      move(sums, source_first_ + edge.nodes()[k], amount * N.value(static_cast<Index>(k)),
           point.target.normal);
    for (std::size_t k = 0; k < facing.nodes().size(); ++k)
      move(sums, target_first_ + facing.nodes()[k], -amount * M.value(static_cast<Index>(k)),
           point.target.normal);
  }
}

void Collector::add_weight(const SideCurve& edge, const DualBasis& basis) {
  sums_.at(edge.nodes().front()).weight += basis.length * basis.mean(0);
  sums_.at(edge.nodes().back()).weight += basis.length * basis.mean(1);
  if (basis.length == 0 && edge.nodes().size() == 3) bare_.insert(edge.nodes()[1]);
}

Pairs Collector::pairs(const Surface& source, const GapOptions& options) const {
  Pairs pairs;
  for (const Index node : boundary_nodes(source.mesh, source.boundary)) {
    const auto corner = sums_.find(node);
    if (corner != sums_.end() && corner->second.weight > 0)
      pairs.node.push_back(node);
    else if (corner != sums_.end() || bare_.count(node) != 0)
      pairs.unpaired.push_back(node);
  }
  const Index n_pairs = static_cast<Index>(pairs.node.size());
  pairs.initial_gap.resize(n_pairs);
  pairs.weight.resize(n_pairs);
  pairs.position.resize(n_pairs, 2);
  pairs.normal.resize(n_pairs, 2);
  std::vector<Eigen::Triplet<double>> opening;
  std::vector<Eigen::Triplet<double>> sliding;
  for (Index pair = 0; pair < n_pairs; ++pair) {
    const Index node = pairs.node[static_cast<std::size_t>(pair)];
    const Sums& sums = sums_.at(node);
    pairs.initial_gap(pair) = sums.gap / sums.weight;
    pairs.weight(pair) = options.thickness * sums.weight;
    pairs.position.row(pair) = source.mesh.nodes.row(node);
    pairs.normal.row(pair) = sums.normal.normalized().transpose();
    const int row = static_cast<int>(pair);
    for (const auto& [column, sum] : sums.opening)
      opening.emplace_back(row, static_cast<int>(column), sum / sums.weight);
    for (const auto& [column, sum] : sums.sliding)
      sliding.emplace_back(row, static_cast<int>(column), sum / sums.weight);
  }
  pairs.opening.resize(n_pairs, 2 * options.n_nodes);
  pairs.opening.setFromTriplets(opening.begin(), opening.end());
  pairs.sliding.resize(n_pairs, 2 * options.n_nodes);
  pairs.sliding.setFromTriplets(sliding.begin(), sliding.end());
  return pairs;
}

}  // namespace

Pairs mortar(const Surface& source, const Surface& target, const GapOptions& options) {
  pose(options.points >= 0 && options.points <= 16,
       "mortar: there are rules of 1 to 16 points (0: its own choice), got ", options.points);
  const Interface interface(source, target, options);
  const std::vector<SideCurve>& edges = interface.source_sides();
  const bool cut = options.quadrature == Quadrature::Segments;
  const bool curved = source.mesh.cells.cols() == 8 || target.mesh.cells.cols() == 8;
  const int points = options.points > 0 ? options.points : (cut && curved ? 3 : 2);
  std::vector<std::vector<double>> cuts(edges.size());
  if (cut) cuts = segment_cuts(interface);

  Collector collector(interface, options.sliding);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const EdgeSamples samples = sample_edge(edges[k], interface, cuts[k], points);
    std::vector<EdgePoint> covered;
    for (const FacingPoint& point : samples.facing) covered.push_back(point.at);
    const DualBasis basis = dual_basis(covered, samples.share);
    for (const FacingPoint& point : samples.facing)
      collector.add(edges[k], point, interface.search().side(point.target.side),
                    basis.value(point.at.s));
    collector.add_weight(edges[k], basis);
  }
  Pairs pairs = collector.pairs(source, options);
  interface.check_paired(pairs.node.size());
  return pairs;
}

}  // namespace signorini

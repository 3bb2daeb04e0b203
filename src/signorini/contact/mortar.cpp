#include "signorini/contact/mortar.hpp"

#include <map>

#include "signorini/contact/mortar_segments.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

/// What the nodes of the source collect from the edges: integrals of psi_i times something.
class Collector {
 public:
  Collector(const Interface& interface, const GapOptions& options)
      : interface_(interface), options_(options) {}

  /// Adds the integrals over one edge to both of its nodes.
  void add(const SourceEdge& edge, const EdgeSamples& samples);
  /// Divides by the weights.
  [[nodiscard]] Pairs pairs() const;

 private:
  struct Sums {
    double weight = 0;
    double gap = 0;
    Vector2d normal = Vector2d::Zero();
    std::map<Index, double> opening, sliding;  // by column
  };
  /// Adds what a point does to the pair of a node, times an amount.
  void add(Sums& sums, const SideCurve& side, const FacingPoint& point, double amount) const;
  /// Adds what the motion of the nodes of a side does, with the point moving as N does.
  void move(Sums& sums, const SideCurve& side, Index first_node, const SideShape& N, double amount,
            const Vector2d& normal) const;

  const Interface& interface_;
  const GapOptions& options_;
  std::map<Index, Sums> sums_;  // by node of the source
};

void Collector::add(const SourceEdge& edge, const EdgeSamples& samples) {
  std::vector<EdgePoint> covered;
  for (const FacingPoint& point : samples.facing) covered.push_back(point.at);
  const DualBasis basis = dual_basis(covered, samples.share);
  for (const Index i : {0, 1}) {
    if (basis.mean(i) == 0) continue;  // nothing covered, or handed to the other end
    Sums& sums = sums_[edge.nodes[static_cast<std::size_t>(i)]];
    sums.weight += basis.length * basis.mean(i);
    for (const FacingPoint& point : samples.facing)
      add(sums, *edge.side, point, point.at.length * basis.value(point.at.s)(i));
  }
}

void Collector::add(Sums& sums, const SideCurve& side, const FacingPoint& point,
                    double amount) const {
  const SideCurve& facing = interface_.search().side(point.target.side);
  const Vector2d& normal = point.target.normal;
  sums.gap += amount * point.target.gap;
  sums.normal += amount * normal;
  move(sums, side, interface_.source().first_node, side.shape(point.xi), amount, normal);
  move(sums, facing, interface_.target().first_node, facing.shape(point.target.xi), -amount,
       normal);
}

void Collector::move(Sums& sums, const SideCurve& side, Index first_node, const SideShape& N,
                     double amount, const Vector2d& normal) const {
  const Vector2d tangent(normal.y(), -normal.x());
  for (std::size_t k = 0; k < side.nodes().size(); ++k)
    for (Index axis = 0; axis < 2; ++axis) {
      const Index column = 2 * (first_node + side.nodes()[k]) + axis;
      const double share = amount * N.value(static_cast<Index>(k));
      sums.opening[column] += share * normal(axis);
      if (options_.sliding) sums.sliding[column] += share * tangent(axis);
    }
}

Pairs Collector::pairs() const {
  const Surface& source = interface_.source();
  Pairs pairs;
  for (const Index node : boundary_nodes(source.mesh, source.boundary))
    (sums_.count(node) != 0 ? pairs.node : pairs.unpaired).push_back(node);
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
    pairs.weight(pair) = options_.thickness * sums.weight;
    pairs.position.row(pair) = source.mesh.nodes.row(node);
    pairs.normal.row(pair) = sums.normal.normalized().transpose();
    const int row = static_cast<int>(pair);
    for (const auto& [column, sum] : sums.opening)
      opening.emplace_back(row, static_cast<int>(column), sum / sums.weight);
    for (const auto& [column, sum] : sums.sliding)
      sliding.emplace_back(row, static_cast<int>(column), sum / sums.weight);
  }
  pairs.opening.resize(n_pairs, 2 * options_.n_nodes);
  pairs.opening.setFromTriplets(opening.begin(), opening.end());
  pairs.sliding.resize(n_pairs, 2 * options_.n_nodes);
  pairs.sliding.setFromTriplets(sliding.begin(), sliding.end());
  return pairs;
}

}  // namespace

Pairs mortar(const Surface& source, const Surface& target, const GapOptions& options) {
  pose(options.points >= 0 && options.points <= 16,
       "mortar: there are rules of 1 to 16 points (0: its own choice), got ", options.points);
  const Interface interface(source, target, options);
  const std::vector<SideCurve>& sides = interface.source_sides();
  const bool cut = options.quadrature == Quadrature::Segments;
  const bool curved = source.mesh.cells.cols() == 8 || target.mesh.cells.cols() == 8;
  const int points = options.points > 0 ? options.points : (cut && curved ? 3 : 2);
  std::vector<std::vector<double>> cuts(sides.size());
  if (cut) cuts = segment_cuts(interface);

  Collector collector(interface, options);
  for (std::size_t k = 0; k < sides.size(); ++k)
    for (const SourceEdge& edge : edges_of(sides[k]))
      collector.add(edge, sample_edge(edge, interface, cuts[k], points));
  Pairs pairs = collector.pairs();
  interface.check_paired(pairs.node.size());
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

// # Contact at Gauss points
//
// The second paper integrates the contact pressure over the sides of the source with a Gauss rule,
// and gives each point \f$g\f$ of the rule a gap and a pressure of its own. What a point stands
// for is
//
// \f[ w_g = \omega_g\,\lvert x'(\xi_g)\rvert\,t, \f]
//
// half the length of a straight side times the weight of the rule times the depth: 0.5 for each of
// two points on a side of length 1. A pressure \f$p_g\f$ is a force \f$p_g w_g\f$.
//
// There is a catch. On a straight side with two nodes the two points see
// \f$0.79\,u_1 + 0.21\,u_2\f$ and \f$0.21\,u_1 + 0.79\,u_2\f$, two independent numbers for two
// nodes. Two sides in a row have four points and three nodes: four gaps of which one follows from
// the others. Four pressures then are not determined, only the forces that they make on the nodes.
// Chapter 10 shows what a solver does with this freedom.

#include "signorini/pairing/gauss_points.hpp"

#include <set>

#include "signorini/core/errors.hpp"
#include "signorini/fem/element.hpp"
#include "signorini/pairing/pair_rows.hpp"

namespace signorini {
namespace {

/// What a Gauss point stands for: half the length of a straight side times the weight of the rule
/// and the depth. A pressure times it is the force of the pair.
/// \PaperEq{LinEtAl, 33} \PaperEq{LinEtAl, 34} \PaperEq{LinEtAl, 35}
/// \PaperEq{LinEtAl, 38} \PaperEq{LinEtAl, 39} \PaperEq{LinEtAl, 40}
double share_of(const SideCurve& side, const GaussPoint& gauss, const Depth& depth) {
  const double x = side.point(gauss.xi).position().x();
  return gauss.weight * side.tangent(gauss.xi).norm() * depth.at(x);
}

}  // namespace

Pairs gauss_points(const Surface& source, const Surface& target, const GapOptions& options) {
  require_input(options.points >= 0 && options.points <= 6,
                "gauss_points: there are rules of 1 to 6 points (0: two), got ", options.points);
  const Interface interface(source, target, options);
  std::vector<PairPoint> points;
  std::vector<double> weights;
  std::set<Eigen::Index> paired;
  for (const SideCurve& side : interface.sides)
    for (const GaussPoint& gauss : gauss_line(options.points == 0 ? 2 : options.points)) {
      const AnchoredPoint x = side.point(gauss.xi);  // \PaperEq{LinEtAl, 32}
      const Projection place = interface.closest(x, side.normal(gauss.xi));
      if (!place.found) continue;
      points.push_back({static_cast<Eigen::Index>(points.size()), &side, gauss.xi, place});
      weights.push_back(share_of(side, gauss, options.depth));
      paired.insert(side.nodes().begin(), side.nodes().end());
    }
  interface.check_paired(points.size());
  const auto n_pairs = static_cast<Eigen::Index>(points.size());
  Pairs pairs;
  pairs.weight = Eigen::VectorXd::Map(weights.data(), n_pairs);
  pairs.position.resize(n_pairs, 2);
  for (const PairPoint& point : points)
    pairs.position.row(point.pair) = point.side->point(point.xi).position().transpose();
  pairs.node.assign(points.size(), -1);
  for (const Eigen::Index node : boundary_nodes(source.mesh, source.boundary))
    if (paired.count(node) == 0) pairs.unpaired.push_back(node);
  write_rows(interface, points, Eigen::VectorXd::Ones(n_pairs), options, pairs);
  return pairs;
}

namespace gap_operator {

GapOperator gauss_points() {
  GapOperator member{"gauss_points", "every Gauss point of the source against the side it faces",
                     signorini::gauss_points};
  member.takes_points = true;
  return member;
}

}  // namespace gap_operator

}  // namespace signorini

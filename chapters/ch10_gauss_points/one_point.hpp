// One Gauss point: a cell that rests on a wider one.
#pragma once
#include <array>

#include "interfaces.hpp"
#include "signorini/contact/gauss_points.hpp"

namespace ch10 {

using Eigen::VectorXd;

/// What a pressure of 3 and a shear of 1 at the first point put on the nodes.
struct OnePoint {
  Pairs pairs;
  std::array<double, 4> x, normal, friction;
};

/// \PaperEq{LinEtAl, 32} to \PaperEq{LinEtAl, 36}, \PaperEq{LinEtAl, 38} to \PaperEq{LinEtAl, 41}
inline OnePoint press_one_point() {
  // [one point]
  const Mesh slave = moved(make_block({}), {0.75, 1}),
             master = block("block", {0, 0}, {2, 1}, 1, 1);
  GapOptions options;
  options.n_nodes = slave.n_nodes() + master.n_nodes();
  options.sliding = true;
  const Pairs pairs = gauss_points({slave, "bottom", 0}, {master, "top", slave.n_nodes()}, options);
  const double share = pairs.weight(0);                                      // l_12 / 2
  const VectorXd normal = pairs.opening.row(0).transpose() * (3 * share);    // (33)-(36)
  const VectorXd friction = pairs.sliding.row(0).transpose() * (1 * share);  // (38)-(41)
  // [one point]
  OnePoint point{pairs, {}, {}, {}};
  const std::vector<Eigen::Index> on = boundary_nodes(slave, "bottom");
  const std::vector<Eigen::Index> below = boundary_nodes(master, "top");
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Index own = k < 2 ? on[k] : below[k - 2];
    const Eigen::Index node = k < 2 ? own : slave.n_nodes() + own;
    point.x[k] = (k < 2 ? slave : master).nodes(own, 0);
    point.normal[k] = normal(2 * node + 1);
    point.friction[k] = friction(2 * node);
  }
  return point;
}

}  // namespace ch10

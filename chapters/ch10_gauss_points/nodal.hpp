// Forces of nodes: Gauss points only integrate their gaps.
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "interfaces.hpp"
#include "signorini/contact/mortar_segments.hpp"
#include "signorini/core/dense.hpp"

namespace ch10 {

// [quadrature]
inline Eigen::Vector2d nodal_errors(
    const Sampling& by) {  // worst of three blocks, mean of three discs
  Eigen::Vector2d error(0, 0);
  for (const auto& [source, target] : {std::pair(8, 11), std::pair(11, 8), std::pair(7, 15)}) {
    const Eigen::VectorXd p = solved(blocks(source, target, by), "blocks").solution.pressure;
    error(0) = std::max(error(0), (p.array() - 1).abs().maxCoeff());
  }
  for (const Eigen::Index cells : {18, 21, 23}) {
    const SolvedScene disc = solved(hertz(cells, by), "disc");
    const Pairs& pairs = disc.model.pairs;
    error(1) += against_hertz(pairs.position, pairs.weight, disc.solution.pressure).rms / 3;
  }
  return error;
}
// [quadrature]

/// The k for which y = c x^k fits best, by least squares of the logarithms.
inline double power(const std::vector<double>& x, const std::vector<double>& y) {
  const Eigen::Index n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd lines = Eigen::MatrixXd::Ones(n, 2);
  lines.col(1) = Eigen::VectorXd::Map(x.data(), n).array().log();
  const Eigen::VectorXd logs = Eigen::VectorXd::Map(y.data(), n).array().log();
  return least_norm_solution(lines, logs)(1);
}

/// Pieces into which the nodes of the lower block cut the edges of the upper one.
inline std::size_t count_segments(Eigen::Index source_edges, Eigen::Index target_edges) {
  const Scene scene = blocks(source_edges, target_edges, {});
  const Mesh& upper = scene.bodies[0].mesh;
  const Mesh& lower = scene.bodies[1].mesh;
  GapOptions options;
  options.n_nodes = upper.n_nodes() + lower.n_nodes();
  const Interface interface({upper, "bottom", 0}, {lower, "top", upper.n_nodes()}, options);
  std::size_t segments = 0;
  for (const std::vector<double>& cuts : segment_cuts(interface)) segments += 1 + cuts.size();
  return segments;
}

/// Pressures that are nodal forces over the nodes' shares, against the closed form.
// [lumped]
inline PressureError lumped_error(const Scene& scene, const SolvedScene& run) {
  const BoundaryForces nodes = boundary_forces(run, {"rim", scene.bodies[0].mesh.name});
  return against_hertz(nodes.position, nodes.weight,
                       nodes.force.col(1).cwiseQuotient(nodes.weight));
}
// [lumped]

}  // namespace ch10

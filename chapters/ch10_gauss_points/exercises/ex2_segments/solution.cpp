#include <algorithm>
#include <cmath>
#include <vector>

#include "exercise.hpp"

namespace ex10_2 {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Ends of the segments: nodes of either side, in order; doubled ones make segments of no length.
std::vector<double> ends(const VectorXd& source, const VectorXd& target) {
  std::vector<double> x(source.begin(), source.end());
  x.insert(x.end(), target.begin(), target.end());
  std::sort(x.begin(), x.end());
  return x;
}

/// Number of the edge on which x lies.
Index edge_at(const VectorXd& nodes, double x) {
  Index edge = 0;
  while (edge + 2 < nodes.size() && nodes(edge + 1) < x) ++edge;
  return edge;
}

}  // namespace

Eigen::MatrixXd projection(const VectorXd& source, const VectorXd& target) {
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(source.size(), target.size());
  const std::vector<double> x = ends(source, target);
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const double half = 0.5 * (x[k + 1] - x[k]), middle = 0.5 * (x[k + 1] + x[k]);
    const Index i = edge_at(source, middle), j = edge_at(target, middle);
    for (const double xi : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
      const double at = middle + half * xi;
      const double s = 2 * (at - source(i)) / (source(i + 1) - source(i)) - 1;
      const double r = (at - target(j)) / (target(j + 1) - target(j));
      const Eigen::Vector2d psi(0.5 * (1 - 3 * s), 0.5 * (1 + 3 * s)), N(1 - r, r);
      P.block<2, 2>(i, j) += half * psi * N.transpose();
    }
  }
  for (Index i = 0; i < source.size(); ++i) P.row(i) /= P.row(i).sum();  // the N_j have the sum 1
  return P;
}

}  // namespace ex10_2

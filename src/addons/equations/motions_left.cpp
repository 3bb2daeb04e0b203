#include <algorithm>
#include <cmath>

#include "addons/equations/equations.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/motions.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using SparseVector = Eigen::SparseVector<double>;

/// A share of a motion that is no more than this is rounding.
constexpr double rounded = 1e-10;

/// A combination of motions: that of the first body in it stands for all in words.
FreeMotion combined_motion(const std::vector<FreeMotion>& modes, const VectorXd& amplitude) {
  FreeMotion whole;
  std::vector<std::string> bodies;
  for (Index k = 0; k < amplitude.size(); ++k) {
    if (amplitude(k) == 0) continue;
    const FreeMotion& one = modes[at(k)];
    if (std::find(bodies.begin(), bodies.end(), one.body) == bodies.end()) bodies.push_back(one.body);
    if (bodies.size() == 1) {
      const Eigen::Vector3d sum = whole.motion + amplitude(k) * one.motion;
      const SparseVector shape = whole.shape;
      whole = one;
      whole.motion = sum;
      whole.shape = shape;
    }
    if (whole.shape.size() == 0) whole.shape.resize(one.shape.size());
    whole.shape = SparseVector(whole.shape + amplitude(k) * one.shape);
  }
  for (std::size_t b = 1; b < bodies.size(); ++b) whole.body += " and " + bodies[b];
  return whole;
}

}  // namespace

std::vector<FreeMotion> motions_left(std::vector<FreeMotion> modes, const NodalRows& free,
                                     const Eliminated& solved) {
  if (modes.empty()) return modes;
  const MatrixXd shapes = mode_shapes(modes);
  MatrixXd moved = free * shapes;
  const MatrixXd size = free.cwiseAbs() * shapes.cwiseAbs();
  const double rounding = 64 * std::max(epsilon, direction_rounding(modes));
  moved = (moved.array().abs() <= rounding * size.array()).select(0, moved);
  if (moved.rows() < moved.cols())
    moved.conservativeResizeLike(MatrixXd::Zero(moved.cols(), moved.cols()));
  const ColumnSpan span = column_span(moved, rounding * static_cast<double>(moved.cols()));
  const std::vector<Index> held(span.order.begin(), span.order.begin() + span.rank);
  std::vector<Index> others(span.order.begin() + span.rank, span.order.end());
  std::sort(others.begin(), others.end());
  std::vector<FreeMotion> left;
  for (const Index k : others) {
    VectorXd amplitude = VectorXd::Zero(moved.cols());
    if (!held.empty())
      amplitude(held) = -least_norm_solution(moved(Eigen::all, held), moved.col(k));
    amplitude(k) = 1;
    amplitude = (amplitude.array().abs() <= rounded).select(0, amplitude);
    left.push_back(combined_motion(modes, amplitude));
    VectorXd shape = left.back().shape;
    const VectorXd given = solved.by * shape;
    shape(solved.unknown) = given;
    left.back().shape = shape.sparseView();
  }
  return left;
}

}  // namespace signorini

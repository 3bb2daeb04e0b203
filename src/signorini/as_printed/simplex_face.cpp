#include "signorini/as_printed/simplex_face.hpp"

#include <cmath>
#include <limits>

#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

SimplexFace::SimplexFace(const ContactProblem& problem)
    : problem_(problem), root_(problem.compliance.diagonal().cwiseMax(0.0).cwiseSqrt()) {}

Eigen::VectorXd SimplexFace::factor_row(Index vertex) const {
  const Index k = static_cast<Index>(vertices_.size());
  Eigen::VectorXd row = problem_.compliance(vertices_, vertex);
  factor_.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(row);
  return row;
}

void SimplexFace::append(Index vertex) {
  const Index k = static_cast<Index>(vertices_.size());
  if (k == 0) ++factorisations_;
  if (factor_.rows() == k) factor_.conservativeResize(2 * k + 1, 2 * k + 1);
  const Eigen::VectorXd row = factor_row(vertex);
  factor_.row(k).head(k) = row.transpose();
  factor_(k, k) = std::sqrt(problem_.compliance(vertex, vertex) - row.squaredNorm());
  vertices_.push_back(vertex);
}

void SimplexFace::drop(Index place) {
  const std::vector<Index> later(vertices_.begin() + place + 1, vertices_.end());
  vertices_.resize(static_cast<std::size_t>(place));
  if (place > 0) ++factorisations_;
  for (const Index vertex : later) append(vertex);
  Eigen::VectorXd left(force_.size() - 1);
  left << force_.head(place), force_.tail(force_.size() - 1 - place);
  force_ = left;
}

void SimplexFace::settle() {  // forces from scratch; what rounding makes tensile is dropped
  while (!vertices_.empty()) {
    const Index k = static_cast<Index>(vertices_.size());
    const auto L = factor_.topLeftCorner(k, k).triangularView<Eigen::Lower>();
    force_ = -problem_.free_gap(vertices_);
    L.solveInPlace(force_);
    L.transpose().solveInPlace(force_);
    Index weakest = 0;
    if (force_.minCoeff(&weakest) > 0) return;
    drop(weakest);
  }
}

bool SimplexFace::add(Index vertex) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double own = problem_.compliance(vertex, vertex);
  double force = 0;  // of the new pair
  while (true) {
    const Index k = static_cast<Index>(vertices_.size());
    const Eigen::VectorXd row = factor_row(vertex);
    Eigen::VectorXd yield = row;  // how much the others give up per unit of the new force
    factor_.topLeftCorner(k, k).triangularView<Eigen::Lower>().transpose().solveInPlace(yield);
    const double pivot = own - row.squaredNorm();
    const double overlap = -problem_.free_gap(vertex) - own * force -
                           problem_.compliance(vertices_, vertex).dot(force_);
    // pivot = z.Gz for z = (1, -yield), so that rounding in G counts with the square of the sum of |z|.
    const double rounding = static_cast<double>(k + 1) * epsilon;
    const double size = std::sqrt(own) + yield.cwiseAbs().dot(root_(vertices_));
    double step = pivot > epsilon * size * size ? overlap / pivot : infinity;
    Index weakest = -1;
    for (Index j = 0; j < k; ++j) {
      if (yield(j) <= rounding * yield.cwiseAbs().maxCoeff()) continue;
      if (force_(j) / yield(j) < step) {
        step = force_(j) / yield(j);
        weakest = j;
      }
    }
    if (step == infinity) {
      infeasibility_.setZero(problem_.free_gap.size());
      infeasibility_(vertices_) = (-yield).cwiseMax(0.0);
      infeasibility_(vertex) = 1;
      return false;
    }
    force += step;
    force_ -= step * yield;
    if (weakest < 0) break;
    drop(weakest);
  }
  append(vertex);
  settle();
  return true;
}

Eigen::VectorXd SimplexFace::forces() const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(problem_.free_gap.size());
  all(vertices_) = force_;
  return all;
}

}  // namespace signorini

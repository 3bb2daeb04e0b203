#include "addons/checks/polyhedron.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Polyhedron::Polyhedron(const MatrixXd& G, const VectorXd& h)
    : G_(G),
      h_(h),
      slacks_(G.rows()),
      k_(G.cols()),
      rows_(slacks_ + k_, k_ + 1),
      nonbasic_(at(k_)) {
  rows_ << G, h, MatrixXd::Identity(k_, k_), VectorXd::Zero(k_);
  std::iota(nonbasic_.begin(), nonbasic_.end(), slacks_);
  for (Index j = 0; j < k_; ++j) {
    Index row = blocking(j, 1);
    if (row < 0) row = blocking(j, -1);
    if (row >= 0) pivot(row, j);
  }
}

double Polyhedron::rounding() const {
  return static_cast<double>(slacks_ + k_ + pivots_ + 1) * epsilon;
}

Index Polyhedron::blocking(Index column, double sign) const {
  const auto value = rows_.col(k_).head(slacks_);
  const double tiny = rounding() * rows_.col(column).cwiseAbs().maxCoeff();
  const double slack = rounding() * (slacks_ > 0 ? value.maxCoeff() : 0);
  double step = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < slacks_; ++i)
    if (const double falls = -sign * rows_(i, column); falls > tiny)
      step = std::min(step, (value(i) + slack) / falls);
  Index first = -1;
  double fastest = tiny;
  for (Index i = 0; i < slacks_; ++i)
    if (const double falls = -sign * rows_(i, column);
        falls > fastest && value(i) <= step * falls) {
      fastest = falls;
      first = i;
    }
  return first;
}

void Polyhedron::pivot(Index row, Index column) {
  const Eigen::RowVectorXd old = rows_.row(row);
  rows_.col(column) /= old(column);
  for (Index j = 0; j <= k_; ++j)
    if (j != column && old(j) != 0) rows_.col(j) -= old(j) * rows_.col(column);
  rows_.row(row).setZero();
  rows_(row, column) = 1;
  rows_.col(k_).head(slacks_) = rows_.col(k_).head(slacks_).cwiseMax(0.0);  // negative is rounding
  nonbasic_[at(column)] = row;
  ++pivots_;
}

VectorXd Polyhedron::vertex() const {
  if (k_ == 0) return {};
  MatrixXd met = MatrixXd::Zero(k_, k_);
  VectorXd value = VectorXd::Zero(k_);
  for (Index j = 0; j < k_; ++j) {
    const Index variable = nonbasic_[at(j)];
    if (variable >= slacks_) {
      met(j, variable - slacks_) = 1;
    } else {
      met.row(j) = G_.row(variable);
      value(j) = -h_(variable);
    }
  }
  return LuFactor(met).solve(value);
}

double Polyhedron::most(const VectorXd& c) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const Index limit = pivots_ + 10 * rows_.rows();
  for (bool moves = true; pivots_ < limit;) {
    const auto coordinates = rows_.bottomRows(k_);
    const VectorXd gain = coordinates.transpose() * c;
    const VectorXd size = rounding() * (coordinates.cwiseAbs().transpose() * c.cwiseAbs());
    Index entering = -1;
    for (Index j = 0; j < k_; ++j) {
      const Index variable = nonbasic_[at(j)];
      if (variable >= slacks_ && std::abs(gain(j)) > size(j)) return unbounded;  // along a line
      if (variable >= slacks_ || gain(j) <= size(j)) continue;
      const bool better =
          entering < 0 || (moves ? gain(j) > gain(entering) : variable < nonbasic_[at(entering)]);
      if (better) entering = j;
    }
    if (entering < 0) {
      const VectorXd y = vertex();
      const VectorXd terms = G_.cwiseAbs() * y.cwiseAbs() + h_;
      const bool inside = ((G_ * y + h_).array() >= -1e3 * rounding() * terms.array()).all();
      return inside ? c.dot(y) : std::numeric_limits<double>::quiet_NaN();
    }
    const Index row = blocking(entering, 1);
    if (row < 0) return unbounded;
    moves = rows_(row, k_) > 0;
    pivot(row, entering);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::pair<double, double> Polyhedron::range(const VectorXd& c) {
  const double high = most(c);
  return {-most(-c), high};
}

}  // namespace signorini

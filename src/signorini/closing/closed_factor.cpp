#include "signorini/closing/closed_factor.hpp"

#include <Eigen/Householder>
#include <algorithm>
#include <cmath>

#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Rotation = Eigen::JacobiRotation<double>;

/// (x, y) becomes the adjoint of the rotation times it.
void rotate(const Rotation& rotation, double& x, double& y) {
  const double old = x;
  x = rotation.c() * old - rotation.s() * y;
  y = rotation.s() * old + rotation.c() * y;
}

/// What rounding may have done to gaps, in numbers scaled to |G_ij| <= 1.
void set_rounding(const Eigen::VectorXd& free_gap, const Eigen::VectorXd& force, Index active,
                  Eigen::VectorXd& rounding) {
  rounding = static_cast<double>(active + 1) * epsilon *
             (free_gap.cwiseAbs().array() + force.head(active).sum());
}

}  // namespace

ClosedTriangle::ClosedTriangle(Index capacity)
    : R_(capacity, capacity), column_(capacity), response_(capacity) {
  rotations_.reserve(static_cast<std::size_t>(capacity));
}

void ClosedTriangle::forward() {
  auto x = column();
  R_.topLeftCorner(size_, size_).triangularView<Eigen::Upper>().transpose().solveInPlace(x);
}

void ClosedTriangle::respond() {
  response_.head(size_) = column();
  auto r = response_.head(size_);
  R_.topLeftCorner(size_, size_).triangularView<Eigen::Upper>().solveInPlace(r);
}

void ClosedTriangle::append(double diagonal) {
  R_.col(size_).head(size_) = column();
  R_(size_, size_) = diagonal;
  ++size_;
}

const std::vector<Rotation>& ClosedTriangle::remove(Index position) {
  rotations_.clear();
  for (Index j = position; j + 1 < size_; ++j) {
    R_.col(j).head(j + 2) = R_.col(j + 1).head(j + 2);
    for (Index i = position; i < j; ++i)
      rotate(rotations_[static_cast<std::size_t>(i - position)], R_(i, j), R_(i + 1, j));
    Rotation next;
    next.makeGivens(R_(j, j), R_(j + 1, j), &R_(j, j));
    rotations_.push_back(next);
  }
  --size_;
  return rotations_;
}

ComplianceFactor::ComplianceFactor(const ScaledProblem& problem)
    : ClosedTriangle(problem.free_gap.size()), problem_(problem) {}

double ComplianceFactor::press(const std::vector<Index>& active, Index pair) {
  for (Index k = 0; k < size(); ++k)
    column()(k) = problem_.compliance(active[static_cast<std::size_t>(k)], pair);
  forward();
  opening_ = problem_.compliance(pair, pair) - column().squaredNorm();
  respond();
  // G itself is rounded, so that the opening (-r, 1) G (-r, 1) is no better known than this.
  const double sum = 1 + response().cwiseAbs().sum();
  if (opening_ <= static_cast<double>(size() + 1) * epsilon * sum * sum) opening_ = 0;
  return opening_;
}

void ComplianceFactor::join() { append(std::sqrt(opening_)); }

void ComplianceFactor::gaps(const std::vector<Index>& active, const Eigen::VectorXd& force,
                            Eigen::VectorXd& gap, Eigen::VectorXd& rounding) const {
  gap = problem_.free_gap;
  for (Index k = 0; k < size(); ++k)
    gap += force(k) * problem_.compliance.col(active[static_cast<std::size_t>(k)]);
  set_rounding(problem_.free_gap, force, size(), rounding);
}

HalfFactor::HalfFactor(const ScaledHalf& problem)
    : ClosedTriangle(std::min(problem.half.rows(), problem.half.cols())),
      problem_(problem),
      J_(Eigen::MatrixXd::Identity(problem.half.rows(), problem.half.rows())),
      turned_(problem.half.rows()),
      work_(problem.half.rows()) {}

double HalfFactor::press(const std::vector<Index>& /*active*/, Index pair) {
  turned_.noalias() = J_.transpose() * problem_.half.col(pair);
  column() = turned_.head(size());
  respond();
  const double rest = turned_.tail(J_.rows() - size()).norm();
  const double sum = 1 + response().cwiseAbs().sum();
  const double rounding = static_cast<double>(J_.rows() + updates_) * epsilon * sum;
  return rest <= rounding ? 0 : rest * rest;
}

void HalfFactor::join() {
  // A reflection turns what W leaves of the column into the next direction of J.
  const Index left = J_.rows() - size();
  auto rest = turned_.tail(left);
  double factor = 0;
  double diagonal = 0;
  rest.makeHouseholderInPlace(factor, diagonal);
  rest(0) = 1;
  work_.noalias() = J_.rightCols(left) * rest;
  work_ *= factor;
  J_.rightCols(left).noalias() -= work_ * rest.transpose();
  append(diagonal);
  ++updates_;
}

void HalfFactor::leave(Index position) {
  for (const Rotation& rotation : remove(position)) {
    J_.applyOnTheRight(position, position + 1, rotation);
    ++position;
  }
  ++updates_;
}

void HalfFactor::gaps(const std::vector<Index>& active, const Eigen::VectorXd& force,
                      Eigen::VectorXd& gap, Eigen::VectorXd& rounding) {
  work_.setZero();
  for (Index k = 0; k < size(); ++k)
    work_ += force(k) * problem_.half.col(active[static_cast<std::size_t>(k)]);
  gap = problem_.free_gap;
  gap.noalias() += problem_.half.transpose() * work_;
  set_rounding(problem_.free_gap, force, size(), rounding);
}

}  // namespace signorini

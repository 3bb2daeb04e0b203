#include "signorini/solvers/dictionary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

Dictionary::Dictionary(const ScaledProblem& problem, const Eigen::VectorXd& covering)
    : n_(covering.size()),
      rows_(n_, n_ + 2),
      column_(n_),
      row_(n_ + 2),
      basic_(at(n_)),
      nonbasic_(at(n_ + 1)),
      place_(at(2 * n_ + 1)) {
  rows_.leftCols(n_) = problem.compliance;
  rows_.col(n_) = covering;
  rows_.col(n_ + 1) = problem.free;
  std::iota(basic_.begin(), basic_.end(), Index{0});
  std::iota(nonbasic_.begin(), nonbasic_.end(), n_);
  for (Index k = 0; k < n_; ++k) place_[at(basic_[at(k)])] = k;
  for (Index k = 0; k <= n_; ++k) place_[at(nonbasic_[at(k)])] = k;
  ties_.reserve(at(n_));
}

Index Dictionary::first_row() const {
  const double largest = (-value().array() / rows_.col(n_).array()).maxCoeff();
  const double slack = rounding() * value().cwiseAbs().maxCoeff();
  Index row = 0;
  for (Index i = 0; i < n_; ++i)
    if (-value()(i) >= rows_(i, n_) * largest - slack) row = i;
  return row;
}

Index Dictionary::blocking_row(Index entering) {
  const auto growth = column(entering);
  const double fastest = growth.cwiseAbs().maxCoeff();
  const double tiny = rounding() * fastest;
  double step = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < n_; ++i)
    if (growth(i) < -tiny) step = std::min(step, std::max(value()(i), 0.0) / -growth(i));
  if (std::isinf(step)) return -1;
  const double slack = rounding() * (value().cwiseAbs().maxCoeff() + step * fastest);
  ties_.clear();
  for (Index i = 0; i < n_; ++i)
    if (growth(i) < -tiny && value()(i) + step * growth(i) <= slack) {
      if (basic(i) == artificial()) return i;
      ties_.push_back(i);
    }
  for (Index j = 0; j < n_ && ties_.size() > 1; ++j) keep_smallest(j, entering);
  return ties_.front();
}

void Dictionary::pivot(Index row, Index entering) {
  const Index place = place_[at(entering)];
  column_ = rows_.col(place);
  row_ = rows_.row(row).transpose() / -column_(row);
  row_(place) = 1 / column_(row);
  rows_.col(place).setZero();
  rows_.noalias() += column_ * row_.transpose();
  rows_.row(row) = row_.transpose();
  std::swap(basic_[at(row)], nonbasic_[at(place)]);
  place_[at(basic_[at(row)])] = row;
  place_[at(nonbasic_[at(place)])] = place;
  ++pivots_;
}

double Dictionary::rounding() const { return static_cast<double>(n_ + pivots_ + 1) * epsilon; }

bool Dictionary::is_basic(Index variable) const {
  const Index k = place_[at(variable)];
  return k < n_ && basic_[at(k)] == variable;
}

/// By how much the perturbation of q_j changes the basic variable of a row.
double Dictionary::perturbation(Index row, Index j) const {
  if (is_basic(j)) return basic(row) == j ? 1 : 0;
  return -rows_(row, place_[at(j)]);
}

/// Of the ties keeps those that the perturbation of q_j makes zero first.
void Dictionary::keep_smallest(Index j, Index entering) {
  const auto growth = column(entering);
  const double slack =
      rounding() * (is_basic(j) ? 1 : rows_.col(place_[at(j)]).cwiseAbs().maxCoeff());
  double least = std::numeric_limits<double>::infinity();
  for (const Index i : ties_) least = std::min(least, perturbation(i, j) / -growth(i));
  const auto loses = [&](Index i) { return (perturbation(i, j) - slack) / -growth(i) > least; };
  ties_.erase(std::remove_if(ties_.begin(), ties_.end(), loses), ties_.end());
}

}  // namespace signorini

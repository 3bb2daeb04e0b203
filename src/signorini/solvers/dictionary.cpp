// # The dictionary of complementary pivoting
//
// Lemke's method works on n equations with 2n + 1 unknowns, the gaps w, the forces z and one number
// \f$ z_0 \f$:
// \f[ w = Mz + c\,z_0 + q. \f]
// Solved for any n of the unknowns, the *basis*, they express these by the others. With all others
// at zero, the constants are the values of the basis. Textbooks of linear programming call this
// form a *dictionary*, or a *tableau*. A *pivot* exchanges one variable of the basis for one
// outside of it.
//
// Take M = [2 1; 1 2], q = (-7, -5), c = (1, 1). The first dictionary is the equation itself,
// \f[ w_1 = -7 + 2z_1 + z_2 + z_0, \qquad w_2 = -5 + z_1 + 2z_2 + z_0. \f]
// \f$ z_0 \f$ enters in the row of \f$ w_1 \f$, where it has to be largest:
// \f[ z_0 = 7 + w_1 - 2z_1 - z_2, \qquad w_2 = 2 + w_1 - z_1 + z_2. \f]
// Then \f$ z_1 \f$ enters. While it grows, \f$ w_2 \f$ is zero at 2, before \f$ z_0 \f$ is at 7/2:
// \f[ z_0 = 3 - w_1 - 3z_2 + 2w_2, \qquad z_1 = 2 + w_1 + z_2 - w_2. \f]
// Then \f$ z_2 \f$ enters and \f$ z_0 \f$ leaves at \f$ z_2 = 1 \f$, where \f$ z_1 = 3 \f$. The
// method is over, and the forces are (3, 1). Which variable enters is the subject of
// [lemke.cpp](lemke.cpp); this file finds the one that leaves, and pivots.

#include "signorini/solvers/dictionary.hpp"

#include <algorithm>
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

// If \f$ z_0 \f$ is large, all gaps are open. When it falls, the gap with the largest
// \f$ -q_i/c_i \f$ closes first. Of several, the lexicographic rule below takes the last: the
// perturbation \f$ \delta^i \f$ opens it least.
Index Dictionary::first_row() const {
  const double largest = (-value().array() / rows_.col(n_).array()).maxCoeff();
  const double slack = rounding() * value().cwiseAbs().maxCoeff();
  Index row = 0;
  for (Index i = 0; i < n_; ++i)
    if (-value()(i) >= rows_(i, n_) * largest - slack) row = i;
  return row;
}

// The ratio test of the simplex method: of all basic variables that fall, the first to become zero
// blocks. If two do so together, one leaves and the other one stays in the basis with the value
// zero. The next pivot may then have no length, and the path may run in circles. The *lexicographic
// rule* breaks such ties as if each \f$ q_j \f$ were \f$ q_j + \delta^j \f$ with a tiny
// \f$ \delta \f$, for which no two rows tie. It compares the effect of \f$ q_1 \f$ first, then of
// \f$ q_2 \f$, until one row is left. \f$ z_0 \f$ goes before all others, because without it the
// problem is solved.
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

// The row of the leaving variable, \f$ x_r = \dots + a\,x_e \f$, is solved for the entering one and
// put into the other rows. That changes the whole table by a matrix of rank one and costs about
// \f$ 2n^2 \f$ operations. The column of \f$ x_e \f$ becomes that of \f$ x_r \f$.
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

// Every pivot rounds the numbers of the one before. So what counts as zero grows with their number.
double Dictionary::rounding() const { return static_cast<double>(n_ + pivots_ + 1) * epsilon; }

// Rows and columns are both numbered from 0, so a place alone does not tell which of the two it is.
bool Dictionary::is_basic(Index variable) const {
  const Index k = place_[at(variable)];
  return k < n_ && basic_[at(k)] == variable;
}

// By how much the perturbation of q_j changes the basic variable of a row. Adding \f$ \delta \f$ to
// \f$ q_j \f$ does to a row what taking \f$ \delta \f$ from \f$ w_j \f$ does. So the columns of w
// in the dictionary hold these numbers with the opposite sign.
double Dictionary::perturbation(Index row, Index j) const {
  if (is_basic(j)) return basic(row) == j ? 1 : 0;
  return -rows_(row, place_[at(j)]);
}

// Of the ties keeps those that the perturbation of q_j makes zero first.
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

#include "signorini/complementarity/programme_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/exact_vector.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

const double epsilon = std::numeric_limits<double>::epsilon();

double largest(const VectorXd& v) { return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff(); }
double ratio(double part, double whole) { return part == 0 ? 0 : part / whole; }

void check(const DenseProgramme& programme) {
  const Index n = programme.load.size();
  const Index m = programme.initial_gap.size();
  require(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
              programme.A.rows() == m && programme.A.cols() == n,
          "quadratic programme: K must be ", n, " x ", n, " and A ", m, " x ", n, ", got ",
          programme.stiffness.rows(), " x ", programme.stiffness.cols(), " and ",
          programme.A.rows(), " x ", programme.A.cols());
  require(programme.equations >= 0 && programme.equations <= m,
          "quadratic programme: equations must be 0 to ", m, ", got ", programme.equations);
  require(programme.stiffness.allFinite() && programme.load.allFinite() &&
              programme.A.allFinite() && programme.initial_gap.allFinite(),
          "quadratic programme: K, p, A and g must be finite");
}

Eigen::LLT<Eigen::MatrixXd> factored(const DenseProgramme& programme) {
  Eigen::LLT<Eigen::MatrixXd> factor;
  if (programme.equations == 0) {
    factor.compute(programme.stiffness);
  } else {
    const auto E = programme.A.topRows(programme.equations);
    const double rho = ratio(programme.stiffness.trace(), E.squaredNorm());
    factor.compute(programme.stiffness + rho * E.transpose() * E);
  }
  const auto pivots = factor.matrixLLT().diagonal();
  bool positive = factor.info() == Eigen::Success;
  for (Index i = 0; positive && i < pivots.size(); ++i)
    positive = pivots(i) * pivots(i) > epsilon * programme.stiffness(i, i);
  if (!positive)
    throw ProblemError(
        "quadratic programme: K is not positive definite to rounding, so the least energy may have "
        "no limit or many places; hold the free directions with equations");
  return factor;
}

}  // namespace

ProgrammeRows::ProgrammeRows(const DenseProgramme& programme) : programme_(programme) {
  check(programme);
  factor_ = factored(programme);
  rows_of_A_ = programme.A.transpose();
  VectorXd load = programme.load;
  if (equations() > 0) {
    const auto E = programme.A.topRows(equations());
    load += ratio(programme.stiffness.trace(), E.squaredNorm()) * E.transpose() *
            programme.initial_gap.head(equations());
  }
  displacement_ = factor_.solve(load);
  gap_ = programme.initial_gap;
  gap_.noalias() -= rows_of_A_.transpose() * displacement_;
  base_.setZero(programme.load.size());
  norm_.setZero(gap_.size());
  // |D^-1/2 a_i| with D = diag K estimates |h_i|, and bounds the terms of a_i u by |D^1/2 u|.
  const VectorXd diagonal = factor_.matrixLLT().diagonal();
  VectorXd root(diagonal.size());
  for (Index i = 0; i < root.size(); ++i)
    root(i) = std::sqrt(std::max(programme.stiffness(i, i), diagonal(i) * diagonal(i)));
  weight_.resize(gap_.size());
  const VectorXd inverse = root.cwiseInverse();
  for (Index i = 0; i < gap_.size(); ++i) {
    const double size = rows_of_A_.col(i).cwiseProduct(inverse).norm();
    weight_(i) = size > 0 ? 1 / size : 0;
  }
  const double stretch = displacement_.cwiseProduct(root).norm();
  floor_.resize(gap_.size());
  for (Index i = 0; i < gap_.size(); ++i)
    floor_(i) = static_cast<double>(root.size() + 4) * epsilon *
                (std::abs(programme.initial_gap(i)) + ratio(stretch, weight_(i)));
}

ClosedBasis ProgrammeRows::empty_basis() const {
  return {programme_.load.size(), std::min(programme_.load.size(), count())};
}

void ProgrammeRows::gaps(const ClosedBasis& basis, VectorXd& gap, VectorXd& rounding) const {
  VectorXd moved = -base_;
  moved.noalias() += basis.directions() * basis.coordinates();
  const double size = moved.norm() * static_cast<double>(moved.size() + 4) * epsilon;
  factor_.matrixU().solveInPlace(moved);
  gap = gap_;
  gap.noalias() += rows_of_A_.transpose() * moved;
  rounding = floor_;
  for (Index i = 0; i < gap.size(); ++i) rounding(i) += ratio(size, weight_(i));
}

VectorXd ProgrammeRows::displacement(const ClosedBasis& basis) const {
  VectorXd moved = basis.directions() * basis.coordinates() - base_;
  factor_.matrixU().solveInPlace(moved);
  return displacement_ - moved;
}

ClosedBasis::Candidates ProgrammeRows::fetch(const std::vector<Index>& rows,
                                             const ClosedBasis& /*basis*/, const VectorXd& gap,
                                             const VectorXd& rounding) {
  const Index count = static_cast<Index>(rows.size());
  ClosedBasis::Candidates candidates;
  candidates.rows = rows;
  candidates.columns.resize(rows_of_A_.rows(), count);
  for (Index i = 0; i < count; ++i)
    candidates.columns.col(i) = rows_of_A_.col(rows[static_cast<std::size_t>(i)]);
  factor_.matrixL().solveInPlace(candidates.columns);
  candidates.gap.resize(count);
  candidates.rounding.resize(count);
  for (Index i = 0; i < count; ++i) {
    const Index row = rows[static_cast<std::size_t>(i)];
    const double norm = candidates.columns.col(i).norm();
    norm_(row) = norm > 0 ? norm : 1;
    candidates.columns.col(i) /= norm_(row);
    candidates.gap(i) = gap(row) / norm_(row);
    candidates.rounding(i) = rounding(row) / norm_(row);
  }
  return candidates;
}

ProgrammeRows::Refined ProgrammeRows::refine(ClosedBasis& basis) {
  const Index n = programme_.load.size();
  const Index k = basis.size();
  const std::vector<Index>& rows = basis.rows();
  const auto L = basis.factor().triangularView<Eigen::Lower>();
  Eigen::MatrixXd closed(k, n);  // A_W, so that residuals run down its columns
  VectorXd norm(k);
  VectorXd initial(k);
  for (Index i = 0; i < k; ++i) {
    const Index row = rows[static_cast<std::size_t>(i)];
    closed.row(i) = rows_of_A_.col(row).transpose();
    norm(i) = norm_(row);
    initial(i) = programme_.initial_gap(row);
  }
  VectorXd force;  // of normalised rows
  basis.solve(force);
  Refined refined;
  PrimalDual& solution = refined.solution;
  solution.displacement = displacement(basis);
  solution.displacement_low.setZero(n);
  VectorXd raw = force.cwiseQuotient(norm);

  double last = std::numeric_limits<double>::infinity();
  while (true) {
    ExactVector unbalanced(programme_.load);
    for (Index j = 0; j < n; ++j)
      unbalanced.add_product(programme_.stiffness.col(j), -solution.displacement(j));
    for (Index i = 0; i < k; ++i)
      unbalanced.add_product(rows_of_A_.col(rows[static_cast<std::size_t>(i)]), -raw(i));
    ExactVector open(initial);
    for (Index j = 0; j < n; ++j) open.add_product(closed.col(j), -solution.displacement(j));
    if (refined.sweeps > 0) {
      unbalanced.add_small(-(programme_.stiffness * solution.displacement_low));
      open.add_small(-(closed * solution.displacement_low));
    }
    // [K A^T; A 0] [du; dlambda] = [unbalanced; open], with K = L_K L_K^T and L_K^-1 A^T = Q L^T.
    VectorXd z = factor_.matrixL().solve(unbalanced.value());
    VectorXd a = open.value().cwiseQuotient(norm);
    L.solveInPlace(a);
    VectorXd along = basis.directions().transpose() * z - a;
    z.noalias() -= basis.directions() * along;
    factor_.matrixU().solveInPlace(z);
    L.transpose().solveInPlace(along);
    for (Index j = 0; j < n; ++j) {  // u is kept as a sum of two doubles
      const double addend = solution.displacement_low(j) + z(j);
      const double sum = solution.displacement(j) + addend;
      const double part = sum - solution.displacement(j);
      solution.displacement_low(j) = (solution.displacement(j) - (sum - part)) + (addend - part);
      solution.displacement(j) = sum;
    }
    raw += along.cwiseQuotient(norm);
    force += along;
    ++refined.sweeps;
    // A sweep shrinks the error by about the relative error that the first solution had.
    const double change = std::max(ratio(largest(z), largest(solution.displacement)),
                                   ratio(largest(along), largest(force)));
    if (change * std::min(change, last) <= epsilon * epsilon || !(change < 0.5 * last)) break;
    if (change * change <= 0.1 * epsilon && refined.sweeps == 1) break;
    last = change;
  }

  displacement_ = solution.displacement;
  basis.set_force(force);
  base_.noalias() = basis.directions() * basis.coordinates();
  gap_ = programme_.initial_gap;
  gap_.noalias() -= rows_of_A_.transpose() * displacement_;
  refined.tension.setZero(k);
  solution.force.setZero(count());
  std::vector<bool> closed_row(static_cast<std::size_t>(count()), false);
  const double pull = static_cast<double>(k + 1) * epsilon * largest(force);
  for (Index i = 0; i < k; ++i) {
    const Index row = rows[static_cast<std::size_t>(i)];
    closed_row[static_cast<std::size_t>(row)] = true;
    solution.force(row) = raw(i);
    if (row >= equations() && force(i) < -pull) refined.tension(i) = -force(i);
  }
  for (Index i = equations(); i < count(); ++i) {
    if (closed_row[static_cast<std::size_t>(i)]) {
      gap_(i) = 0;
      continue;
    }
    double size = std::abs(programme_.initial_gap(i));
    for (Index j = 0; j < n; ++j) size += std::abs(rows_of_A_(j, i) * displacement_(j));
    floor_(i) = 4 * epsilon * size;
    if (std::abs(gap_(i)) <= static_cast<double>(n) * floor_(i)) {
      ExactSum sum(programme_.initial_gap(i));
      for (Index j = 0; j < n; ++j) {
        sum.add_product(-rows_of_A_(j, i), displacement_(j));
        sum.add(-rows_of_A_(j, i) * solution.displacement_low(j));
      }
      gap_(i) = sum.value();
    }
    if (gap_(i) < -floor_(i)) ++refined.violated;
  }
  refined.gap = gap_;
  return refined;
}

}  // namespace signorini

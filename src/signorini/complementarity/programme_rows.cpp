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
/// How far a row of this weight can move when the unknowns move so far; a row without entries cannot.
double reach(double stretch, double weight) { return weight > 0 ? stretch / weight : 0; }

/// x <- L^-1 x down the columns of L; short columns are not worth the blocks of the general routine.
void solve_lower(const Eigen::MatrixXd& L, Eigen::Ref<VectorXd> x) {
  const Index n = x.size();
  for (Index j = 0; j < n; ++j) {
    x(j) /= L(j, j);
    x.tail(n - j - 1) -= x(j) * L.col(j).tail(n - j - 1);
  }
}

/// x <- L^-T x.
void solve_upper(const Eigen::MatrixXd& L, VectorXd& x) {
  const Index n = x.size();
  for (Index j = n - 1; j >= 0; --j)
    x(j) = (x(j) - L.col(j).tail(n - j - 1).dot(x.tail(n - j - 1))) / L(j, j);
}

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
  // A sum is finite only if every term is.
  require(std::isfinite(programme.stiffness.sum() * 0) && std::isfinite(programme.A.sum() * 0) &&
              std::isfinite(programme.load.sum() * 0) &&
              std::isfinite(programme.initial_gap.sum() * 0),
          "quadratic programme: K, p, A and g, and their sums, must be finite");
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
  const Index n = programme.load.size();
  displacement_ = programme.load;
  if (equations() > 0) {
    const auto E = programme.A.topRows(equations());
    displacement_ += ratio(programme.stiffness.trace(), E.squaredNorm()) * E.transpose() *
                     programme.initial_gap.head(equations());
  }
  solve_lower(factor_.matrixLLT(), displacement_);
  solve_upper(factor_.matrixLLT(), displacement_);
  gap_ = programme.initial_gap;
  gap_.noalias() -= programme.A * displacement_;
  base_.setZero(n);
  norm_.setZero(count());
  // |D^-1/2 a_i| with D = diag K estimates |h_i|, and bounds the terms of a_i u by |D^1/2 u|.
  floor_.setZero(count());
  root_.resize(n);
  for (Index j = 0; j < n; ++j) {
    const double pivot = factor_.matrixLLT()(j, j);
    const double stiffness = std::max(programme.stiffness(j, j), pivot * pivot);
    root_(j) = std::sqrt(stiffness);
    floor_ += (1 / stiffness) * programme.A.col(j).cwiseAbs2();
  }
  stretch_ = displacement_.cwiseProduct(root_).norm();
  weight_.resize(count());
  const double rounding = static_cast<double>(n + 4) * epsilon;
  for (Index i = 0; i < count(); ++i) {
    const double size = std::sqrt(floor_(i));
    weight_(i) = size > 0 ? 1 / size : 0;
    floor_(i) = rounding * (std::abs(programme.initial_gap(i)) + stretch_ * size);
  }
}

ClosedBasis ProgrammeRows::empty_basis() const {
  return {unknowns(), std::min(unknowns(), count())};
}

void ProgrammeRows::gaps(const ClosedBasis& basis, VectorXd& gap, VectorXd& rounding) {
  gap = gap_;
  rounding = floor_;
  moved_ = -base_;
  moved_.noalias() += basis.directions() * basis.coordinates();
  const double size = moved_.norm() * static_cast<double>(moved_.size() + 4) * epsilon;
  if (size == 0) return;
  solve_upper(factor_.matrixLLT(), moved_);
  gap.noalias() += programme_.A * moved_;
  for (Index i = 0; i < gap.size(); ++i) rounding(i) += reach(size, weight_(i));
}

VectorXd ProgrammeRows::displacement(const ClosedBasis& basis) const {
  VectorXd u = base_;
  u.noalias() -= basis.directions() * basis.coordinates();
  solve_upper(factor_.matrixLLT(), u);
  u += displacement_;
  return u;
}

void ProgrammeRows::fetch(const VectorXd& gap, const VectorXd& rounding,
                          ClosedBasis::Candidates& candidates) {
  const Index count = static_cast<Index>(candidates.rows.size());
  if (candidates.columns.cols() < count) candidates.columns.resize(unknowns(), count);
  for (Index i = 0; i < count; ++i)
    candidates.columns.col(i) =
        programme_.A.row(candidates.rows[static_cast<std::size_t>(i)]).transpose();
  if (unknowns() < 32) {  // the general routine packs blocks, which pays for longer columns
    for (Index i = 0; i < count; ++i) solve_lower(factor_.matrixLLT(), candidates.columns.col(i));
  } else {
    auto columns = candidates.columns.leftCols(count);
    factor_.matrixL().solveInPlace(columns);
  }
  if (candidates.gap.size() < count) {
    candidates.gap.resize(count);
    candidates.rounding.resize(count);
  }
  for (Index i = 0; i < count; ++i) {
    const Index row = candidates.rows[static_cast<std::size_t>(i)];
    const double norm = candidates.columns.col(i).norm();
    norm_(row) = norm > 0 ? norm : 1;
    candidates.columns.col(i) /= norm_(row);
    candidates.gap(i) = gap(row) / norm_(row);
    candidates.rounding(i) = rounding(row) / norm_(row);
  }
}

/// What one refinement works with.
struct ProgrammeRows::Work {
  Eigen::MatrixXd closed;  // A_W `k x n`
  VectorXd norm;           // `k` |h_i|
  VectorXd initial;        // `k` g_W
  VectorXd force;          // `k` of normalised rows
  VectorXd raw;            // `k` lambda_W
  VectorXd z;
  VectorXd a;
  VectorXd along;
};

/// One sweep: [K A^T; A 0] [du; dlambda] = residuals, with K = L_K L_K^T and L_K^-1 A^T = Q L^T.
void ProgrammeRows::correct(const ClosedBasis& basis, Refined& refined, Work& work) {
  PrimalDual& solution = refined.solution;
  const Index n = unknowns();
  const auto L = basis.factor().triangularView<Eigen::Lower>();
  ExactVector unbalanced(programme_.load);
  ExactVector open(work.initial);
  for (Index j = 0; j < n; ++j) {
    unbalanced.add_product(programme_.stiffness.col(j), -solution.displacement(j));
    open.add_product(work.closed.col(j), -solution.displacement(j));
  }
  unbalanced.add_products(work.closed, -work.raw);
  if (refined.sweeps > 0) {
    unbalanced.add_small(-(programme_.stiffness * solution.displacement_low));
    open.add_small(-(work.closed * solution.displacement_low));
  }
  work.z = unbalanced.value();
  solve_lower(factor_.matrixLLT(), work.z);
  work.a = open.value().cwiseQuotient(work.norm);
  L.solveInPlace(work.a);
  work.along.noalias() = basis.directions().transpose() * work.z;
  work.along -= work.a;
  work.z.noalias() -= basis.directions() * work.along;
  solve_upper(factor_.matrixLLT(), work.z);
  L.transpose().solveInPlace(work.along);
  for (Index j = 0; j < n; ++j) {  // u is kept as a sum of two doubles
    const double addend = solution.displacement_low(j) + work.z(j);
    const double sum = solution.displacement(j) + addend;
    const double part = sum - solution.displacement(j);
    solution.displacement_low(j) = (solution.displacement(j) - (sum - part)) + (addend - part);
    solution.displacement(j) = sum;
  }
  work.force += work.along;
  work.raw += work.along.cwiseQuotient(work.norm);
  ++refined.sweeps;
}

ProgrammeRows::Refined ProgrammeRows::refine(ClosedBasis& basis) {
  const Index k = basis.size();
  Refined refined;
  Work work;
  basis.solve(work.force);
  work.raw.resize(k);
  for (Index i = 0; i < k; ++i)
    work.raw(i) = work.force(i) / norm_(basis.rows()[static_cast<std::size_t>(i)]);
  refined.solution.displacement = displacement(basis);
  if (beyond_doubt(basis, refined, work)) {
    displacement_ = refined.solution.displacement;
    return refined;
  }
  work.force.conservativeResize(k);
  work.closed.resize(k, unknowns());
  work.initial.resize(k);
  work.norm.resize(k);
  for (Index i = 0; i < k; ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    work.closed.row(i) = programme_.A.row(row);
    work.initial(i) = programme_.initial_gap(row);
    work.norm(i) = norm_(row);
  }
  refined.solution.displacement_low.setZero(unknowns());
  double last = std::numeric_limits<double>::infinity();
  while (true) {
    correct(basis, refined, work);
    // A sweep shrinks the error by about the relative error of the first solution: two such factors
    // below rounding are enough.
    const double change = std::max(ratio(largest(work.z), largest(refined.solution.displacement)),
                                   ratio(largest(work.along), largest(work.force)));
    const double next = change * (refined.sweeps == 1 ? change : std::min(1.0, change / last));
    if (next <= 0.1 * epsilon || !(change < 0.5 * last)) break;
    last = change;
  }
  displacement_ = refined.solution.displacement;
  basis.set_force(work.force);
  judge(basis, refined, work);
  return refined;
}

/// Gaps of the present displacement in `gap_`, and in `floor_` the rounding of one term of each.
void ProgrammeRows::measure(const ClosedBasis& basis, const VectorXd& displacement) {
  base_.noalias() = basis.directions() * basis.coordinates();
  gap_ = programme_.initial_gap;
  gap_.noalias() -= programme_.A * displacement;
  // What the row moves is at most |D^-1/2 a_i| |D^1/2 u|, and was so before contact pushed back.
  stretch_ = std::max(stretch_, displacement.cwiseProduct(root_).norm());
  for (Index i = 0; i < count(); ++i)
    floor_(i) = 4 * epsilon * (std::abs(programme_.initial_gap(i)) + reach(stretch_, weight_(i)));
}

/// Whether the solution satisfies all conditions so well, and all rows are so far from the wrong side,
/// that twice the working precision could not change anything but the last digits.
bool ProgrammeRows::beyond_doubt(const ClosedBasis& basis, Refined& refined, const Work& work) {
  const Index k = basis.size();
  measure(basis, refined.solution.displacement);
  const double terms = static_cast<double>(unknowns());
  refined.solution.force.setZero(count());
  const double pull = static_cast<double>(k + 1) * epsilon * largest(work.force.head(k));
  for (Index i = 0; i < k; ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    if (std::abs(gap_(row)) > terms * floor_(row) || (row >= equations() && work.force(i) <= pull))
      return false;
    gap_(row) = 2 * terms * floor_(row);  // passes the test of the open rows
    refined.solution.force(row) = work.raw(i);
  }
  if (((gap_ - terms * floor_).array() < 0).any()) return false;
  moved_ = programme_.load;
  moved_.noalias() -= programme_.stiffness * refined.solution.displacement;
  for (Index i = 0; i < k; ++i)
    moved_ -= work.raw(i) * programme_.A.row(basis.rows()[static_cast<std::size_t>(i)]).transpose();
  if (largest(moved_) > terms * epsilon * largest(programme_.load)) return false;
  for (const Index row : basis.rows()) gap_(row) = 0;
  refined.gap = gap_;
  return true;
}

/// All gaps of the refined solution, and which rows are on the wrong side beyond rounding.
void ProgrammeRows::judge(const ClosedBasis& basis, Refined& refined, const Work& work) {
  const Index k = basis.size();
  measure(basis, displacement_);
  refined.tension.setZero(k);
  refined.solution.force.setZero(count());
  const double pull = static_cast<double>(k + 1) * epsilon * largest(work.force);
  for (Index i = 0; i < k; ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    gap_(row) = 0;
    floor_(row) = 0;
    refined.solution.force(row) = work.raw(i);
    if (row >= equations() && work.force(i) < -pull) refined.tension(i) = -work.force(i);
  }
  const double terms = static_cast<double>(unknowns());
  for (Index i = equations(); i < count(); ++i) {
    if (std::abs(gap_(i)) < terms * floor_(i)) {
      ExactSum sum(programme_.initial_gap(i));
      for (Index j = 0; j < unknowns(); ++j) {
        sum.add_product(-programme_.A(i, j), displacement_(j));
        sum.add(-programme_.A(i, j) * refined.solution.displacement_low(j));
      }
      gap_(i) = sum.value();
    }
    if (gap_(i) < -floor_(i)) ++refined.violated;
  }
  refined.gap = gap_;
}

}  // namespace signorini

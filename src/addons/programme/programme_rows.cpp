#include "addons/programme/programme_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "addons/programme/dense_programme.hpp"
#include "addons/programme/equation_split.hpp"
#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// How far a row of this weight can move when the unknowns move so far; a row without entries cannot.
double movement_within(double stretch, double weight) { return weight > 0 ? stretch / weight : 0; }

/// What each equation adds to K: along its own row as much as the unknowns of the row resist together, so that it swamps none of
/// them; where K has nothing for them, as much as it has in the mean, or 1.
VectorXd equation_stiffness(const DenseProgramme& programme, double spring) {
  const double trace = programme.stiffness.trace();
  const double mean = trace > 0 ? trace / static_cast<double>(programme.load.size()) : 1;
  VectorXd rho(programme.equations);
  for (Index i = 0; i < rho.size(); ++i) {
    double compliance = 0;
    for (Index j = 0; j < programme.load.size(); ++j) {
      const double a = programme.A(i, j);
      const double stiffness = programme.stiffness(j, j) + spring;
      if (a != 0 && stiffness > 0) compliance += a * a / stiffness;
    }
    const double square = programme.A.row(i).squaredNorm();
    rho(i) = compliance > 0 ? 1 / compliance : square > 0 ? mean / square : 0;
  }
  return rho;
}

CholeskyFactor factored(const DenseProgramme& programme, const VectorXd& rho, double spring) {
  Eigen::MatrixXd K = programme.stiffness;
  if (spring > 0) K.diagonal().array() += spring;
  if (programme.equations > 0) {
    const auto E = programme.A.topRows(programme.equations);
    K += E.transpose() * rho.asDiagonal() * E;
  }
  const CholeskyFactor factor(K);
  const auto pivots = factor.lower().diagonal();
  bool positive = factor.positive();
  for (Index i = 0; positive && i < pivots.size(); ++i)
    positive = pivots(i) * pivots(i) > static_cast<double>(pivots.size() + 1) * epsilon * K(i, i);
  if (!positive)
    throw NotDefinite(
        "quadratic programme: K is not positive definite to rounding, so the least energy may have "
        "no limit or many places; hold the free directions with equations");
  return factor;
}

/// The same with as much of each equation as is needed. \param[out] rho  what each adds
CholeskyFactor factored_with_enough(const DenseProgramme& programme, double spring, VectorXd& rho) {
  rho = equation_stiffness(programme, spring);
  try {
    return factored(programme, rho, spring);
  } catch (const NotDefinite&) {
    const std::optional<VectorXd> enough = sufficient_stiffness(programme, spring);
    if (!enough) throw;
    rho = *enough;
    return factored(programme, rho, spring);
  }
}

/// Whether no displacements satisfy the equations, beyond rounding: those of least squares do not. Rounding that an elimination leaves of
/// right sides of 0 has no size to be compared with.
bool contradictory(const DenseProgramme& programme) {
  const MatrixXd E = programme.A.topRows(programme.equations);
  const VectorXd g = programme.initial_gap.head(programme.equations);
  const VectorXd nearest = least_norm_solution(E, g);
  const VectorXd size = g.cwiseAbs() + E.cwiseAbs() * nearest.cwiseAbs();
  const double rounding = 4 * static_cast<double>(E.rows() + E.cols()) * epsilon;
  return ((g - E * nearest).array().abs() > rounding * size.array()).any();
}

}  // namespace

void check_sizes(const DenseProgramme& programme) {
  const Index n = programme.load.size();
  const Index m = programme.initial_gap.size();
  require_argument(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
                       programme.A.rows() == m && programme.A.cols() == n,
                   "quadratic programme: K must be ", n, " x ", n, " and A ", m, " x ", n, ", got ",
                   programme.stiffness.rows(), " x ", programme.stiffness.cols(), " and ",
                   programme.A.rows(), " x ", programme.A.cols());
  require_argument(programme.equations >= 0 && programme.equations <= m,
                   "quadratic programme: equations must be 0 to ", m, ", got ",
                   programme.equations);
  // A sum is finite only if every term is.
  require_argument(
      std::isfinite(programme.stiffness.sum() * 0) && std::isfinite(programme.A.sum() * 0) &&
          std::isfinite(programme.load.sum() * 0) && std::isfinite(programme.initial_gap.sum() * 0),
      "quadratic programme: K, p, A and g, and their sums, must be finite");
}

ProgrammeRows::ProgrammeRows(const DenseProgramme& programme, double spring)
    : programme_(programme), spring_(spring) {
  check_sizes(programme);
  factor_ = factored_with_enough(programme, spring, rho_);
  const Index n = programme.load.size();
  displacement_ = programme.load;
  if (equations() > 0) {
    const auto E = programme.A.topRows(equations());
    displacement_ += E.transpose() * rho_.cwiseProduct(programme.initial_gap.head(equations()));
  }
  solve_lower(factor_.lower(), displacement_);
  solve_lower_transposed(factor_.lower(), displacement_);
  gap_ = programme.initial_gap;
  gap_.noalias() -= programme.A * displacement_;
  norm_.setZero(count());
  // |D^-1/2 a_i| with D = diag K estimates |h_i|, and bounds the terms of a_i u by |D^1/2 u|.
  floor_.setZero(count());
  root_.resize(n);
  for (Index j = 0; j < n; ++j) {
    const double pivot = factor_.lower()(j, j);
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

ActiveSetFactor::Candidates ProgrammeRows::append(const std::vector<Index>& closed,
                                                  const VectorXd& gap, const VectorXd& rounding,
                                                  ActiveSetFactor& basis) {
  ActiveSetFactor::Candidates candidates;
  candidates.rows.resize(static_cast<std::size_t>(equations()));
  std::iota(candidates.rows.begin(), candidates.rows.end(), Index{0});
  candidates.rows.insert(candidates.rows.end(), closed.begin(), closed.end());
  fetch(gap, rounding, candidates);
  basis.append(candidates, ActiveSetFactor::Choice::All,
               static_cast<Index>(candidates.rows.size()));
  return candidates;
}

ActiveSetFactor ProgrammeRows::basis_of(const std::vector<Index>& closed) {
  ActiveSetFactor basis = empty_basis();
  VectorXd gap;
  VectorXd rounding;
  gaps(basis, gap, rounding);
  const ActiveSetFactor::Candidates candidates = append(closed, gap, rounding, basis);
  for (Index i = 0; i < equations(); ++i)
    if (std::abs(candidates.gap(i)) > 4 * candidates.rounding(i) && contradictory(programme_))
      throw ProblemError(text("quadratic programme: equation ", i + 1,
                              " contradicts the others; nothing satisfies them all"));
  return basis;
}

ActiveSetFactor ProgrammeRows::basis_at(const std::vector<Index>& closed,
                                        const PrimalDual& solution) {
  ActiveSetFactor basis = empty_basis();
  displacement_ = solution.displacement;
  gap_ = programme_.initial_gap - programme_.A * displacement_;
  static_cast<void>(append(closed, gap_, floor_, basis));
  VectorXd force(basis.size());
  for (Index i = 0; i < basis.size(); ++i) {
    const Index row = basis.rows()[static_cast<std::size_t>(i)];
    force(i) = solution.force(row) * norm_(row);
  }
  basis.set_force(force);
  base_ = basis.directions() * basis.coordinates();
  moved_.setZero(unknowns());
  return basis;
}

ActiveSetFactor ProgrammeRows::empty_basis() const {
  return {unknowns(), std::min(unknowns(), count())};
}

void ProgrammeRows::gaps(const ActiveSetFactor& basis, VectorXd& gap, VectorXd& rounding) {
  gap = gap_;
  rounding = floor_;
  moved_.noalias() = basis.directions() * basis.coordinates();
  if (base_.size() > 0) moved_ -= base_;
  const double size = moved_.norm() * static_cast<double>(moved_.size() + 4) * epsilon;
  if (size == 0) return;
  solve_lower_transposed(factor_.lower(), moved_);
  gap.noalias() += programme_.A * moved_;
  for (Index i = 0; i < gap.size(); ++i) rounding(i) += movement_within(size, weight_(i));
}

void ProgrammeRows::fetch(const VectorXd& gap, const VectorXd& rounding,
                          ActiveSetFactor::Candidates& candidates) {
  const Index count = static_cast<Index>(candidates.rows.size());
  if (count == 0) return;
  if (candidates.columns.cols() < count) candidates.columns.resize(unknowns(), count);
  for (Index i = 0; i < count; ++i)
    candidates.columns.col(i) =
        programme_.A.row(candidates.rows[static_cast<std::size_t>(i)]).transpose();
  if (unknowns() < 32) {  // the general routine packs blocks, which pays for longer columns
    for (Index i = 0; i < count; ++i) solve_lower(factor_.lower(), candidates.columns.col(i));
  } else {
    solve_lower_columns(factor_.lower(), candidates.columns.leftCols(count));
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

}  // namespace signorini

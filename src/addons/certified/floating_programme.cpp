#include "addons/certified/floating_programme.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "addons/certified/certified_solve.hpp"
#include "addons/certified/programme_rows.hpp"
#include "addons/certified/proofs.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/rigid_modes.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void check(const DenseProgramme& programme, const MatrixXd& N) {
  const Index n = programme.load.size();
  const Index m = programme.initial_gap.size();
  require_argument(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
                       programme.A.rows() == m && programme.A.cols() == n && N.rows() == n,
                   "floating programme: K must be ", n, " x ", n, ", A ", m, " x ", n,
                   " and N have ", n, " rows, got ", programme.stiffness.rows(), " x ",
                   programme.stiffness.cols(), ", ", programme.A.rows(), " x ", programme.A.cols(),
                   " and ", N.rows());
  require_argument(programme.equations == 0,
                   "floating programme: equations have no place here, got ", programme.equations);
  require_argument(programme.stiffness.allFinite() && programme.load.allFinite() &&
                       programme.A.allFinite() && programme.initial_gap.allFinite() &&
                       N.allFinite(),
                   "floating programme: K, p, A, g and N must be finite");
}

/// Square roots of the diagonal of K: one unit for all unknowns. Where K has nothing, their mean.
VectorXd unknown_scale(const MatrixXd& K) {
  const double trace = K.trace();
  const double mean = trace > 0 ? trace / static_cast<double>(K.rows()) : 1;
  return K.diagonal().unaryExpr([mean](double k) { return std::sqrt(k > 0 ? k : mean); });
}

/// Scaled null vectors, orthonormal.
MatrixXd orthonormal_modes(const MatrixXd& K, const MatrixXd& N, const VectorXd& scale) {
  const double rounding = static_cast<double>(K.rows() + 1) * epsilon;
  for (Index j = 0; j < N.cols(); ++j) {
    const VectorXd stretched = (K * N.col(j)).cwiseQuotient(scale);
    const VectorXd size = (K.cwiseAbs() * N.col(j).cwiseAbs()).cwiseQuotient(scale);
    require_input(stretched.norm() <= 1e3 * rounding * size.norm() && N.col(j).norm() > 0,
                  "floating programme: column ", j + 1,
                  " of the null vectors is no rigid mode: K N is ",
                  size.norm() > 0 ? stretched.norm() / size.norm() : 0,
                  " of its terms, expected rounding; give vectors with K N = 0");
  }
  MatrixXd modes = scale.asDiagonal() * N;
  for (Index j = 0; j < N.cols(); ++j) modes.col(j).normalize();
  if (N.cols() == 0) return modes;
  ColumnSpan span = column_span(modes, rounding);
  require_input(span.rank == N.cols(), "floating programme: the ", N.cols(),
                " null vectors are dependent, of rank ", span.rank,
                "; leave out those that repeat others");
  return span.basis;
}

/// The solution of a programme with some rows as equations as well, which hold what K leaves free: then it is refined from the
/// original data. Their forces may have any sign. Nothing if there is none, or they do not hold it.
std::optional<DenseSolution> held_solution(const DenseProgramme& programme,
                                           const std::vector<Index>& closed, const Solver& solver,
                                           const SolverOptions& options) {
  std::vector<Index> order(static_cast<std::size_t>(programme.initial_gap.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_partition(order.begin() + programme.equations, order.end(), [&](Index row) {
    return std::binary_search(closed.begin(), closed.end(), row);
  });
  const DenseProgramme held{programme.stiffness, programme.load, programme.A(order, Eigen::all),
                            programme.initial_gap(order),
                            programme.equations + static_cast<Index>(closed.size())};
  try {
    static_cast<void>(ProgrammeRows(held));  // throws where they do not hold K
    DenseSolution solution = solve(held, solver, options);
    if (solution.report.status != SolveStatus::Solved) return {};
    const VectorXd force = solution.refined.force;
    const VectorXd gap = solution.gap;
    for (std::size_t k = 0; k < order.size(); ++k) {
      solution.refined.force(order[k]) = force(static_cast<Index>(k));
      solution.gap(order[k]) = gap(static_cast<Index>(k));
    }
    for (Index& row : solution.active) row = order[static_cast<std::size_t>(row)];
    for (const Index row : closed) solution.active.push_back(row);
    std::sort(solution.active.begin(), solution.active.end());
    return solution;
  } catch (const ProblemError&) {  // rounding has the last word, or these rows are dependent
    return {};
  }
}

}  // namespace

DenseCondensed condense(const DenseProgramme& programme, const MatrixXd& null_vectors) {
  check(programme, null_vectors);
  const VectorXd scale = unknown_scale(programme.stiffness);
  const MatrixXd C =
      scale.asDiagonal() * orthonormal_modes(programme.stiffness, null_vectors, scale);
  MatrixXd grounded = programme.stiffness;
  grounded.selfadjointView<Eigen::Lower>().rankUpdate(C);
  const VectorXd diagonal = grounded.diagonal();
  DenseCondensed condensed{CholeskyFactor(grounded), programme.A.transpose(), {}, {}};
  const VectorXd pivots = condensed.factor.lower().diagonal().cwiseAbs2();
  const double tiny = static_cast<double>(diagonal.size() + 1) * epsilon;
  require_input(
      condensed.factor.positive() && (pivots.array() > tiny * diagonal.array()).all(),
      "floating programme: K with ", null_vectors.cols(),
      " grounded modes is not positive definite; the body can move in more ways than the null "
      "vectors say, or K is indefinite");
  condensed.free_displacement = condensed.factor.solve(programme.load);
  solve_lower_columns(condensed.factor.lower(), condensed.half);
  condensed.problem = {gram(condensed.half),
                       programme.initial_gap - programme.A * condensed.free_displacement};
  add_rigid_modes(sparse(programme), null_vectors, condensed.problem);
  return condensed;
}

FloatingSolution solve(const DenseProgramme& programme, const MatrixXd& null_vectors,
                       const Solver& solver, const SolverOptions& options) {
  const DenseCondensed condensed = condense(programme, null_vectors);
  const CondensedProgramme small{
      condensed.problem, condensed.free_displacement,
      [&](const VectorXd& load) { return VectorXd(condensed.factor.solve(load)); }};
  Ledger ledger;
  CertifiedSolution end =
      certified_solve(sparse(programme), small, null_vectors, solver, options, ledger);
  FloatingSolution solution;
  DenseSolution& dense = solution.dense;
  dense.report = std::move(end.state.report);
  dense.active = std::move(end.state.active);
  dense.gap = std::move(end.state.gap);
  dense.farkas_certificate = std::move(end.state.farkas_certificate);
  dense.certificate = end.certificate;
  dense.refined = std::move(end.solution);
  if (dense.refined.displacement.size() > 0)
    solution.amplitude = least_norm_solution(
        null_vectors,
        dense.refined.displacement -
            condensed.factor.solve(programme.load - programme.A.transpose() * dense.refined.force));
  solution.unbounded_direction = std::move(end.state.unbounded_direction);
  if (dense.report.status == SolveStatus::Solved) dense.gap(dense.active).setZero();
  return solution;
}

std::optional<DenseSolution> semidefinite_solution(const DenseProgramme& programme,
                                                   const Solver& solver,
                                                   const SolverOptions& options) {
  const Index n = programme.load.size();
  const Index first = programme.equations;
  const Index rows = programme.initial_gap.size() - first;
  const VectorXd unit = unknown_scale(programme.stiffness).cwiseInverse();
  const MatrixXd A = programme.A * unit.asDiagonal();
  const MatrixXd E = A.topRows(first);
  const VectorXd place = first > 0 ? least_norm_solution(E, programme.initial_gap.head(first))
                                   : VectorXd(VectorXd::Zero(n));
  const MatrixXd Z = first > 0 ? null_space(E) : MatrixXd(MatrixXd::Identity(n, n));
  const double rounding = static_cast<double>(n + first + 1) * epsilon;
  const VectorXd terms = E.cwiseAbs() * place.cwiseAbs();
  const VectorXd left = E * place - programme.initial_gap.head(first);
  if ((left.array().abs() > 4 * rounding * terms.array()).any() || Z.cols() == 0) return {};
  const MatrixXd K = unit.asDiagonal() * programme.stiffness * unit.asDiagonal();
  const MatrixXd inside = Z.transpose() * K * Z;
  DenseProgramme reduced;
  reduced.stiffness = 0.5 * (inside + inside.transpose());
  if (symmetric_eigenvalues(reduced.stiffness)(0) < -rounding * K.trace()) return {};
  reduced.load = Z.transpose() * (unit.cwiseProduct(programme.load) - K * place);
  reduced.A = A.bottomRows(rows) * Z;
  reduced.initial_gap = programme.initial_gap.tail(rows) - A.bottomRows(rows) * place;
  const MatrixXd N = null_space(reduced.stiffness);
  if (N.cols() == 0) return {};
  DenseSolution solution;
  try {
    solution = solve(reduced, N, solver, options).dense;
  } catch (const ProblemError&) {  // rounding does not tell what is free
    return {};
  }
  if (solution.report.status != SolveStatus::Solved) return {};
  PrimalDual& refined = solution.refined;
  const double nothing = proof_rounding * largest(refined.force);
  std::vector<Index> pressed;
  for (Index i = 0; i < rows; ++i)
    if (refined.force(i) > nothing) pressed.push_back(i);
  if (pressed.empty()) return {};
  const MatrixXd held = (reduced.A * N)(pressed, Eigen::all).transpose();
  if (column_span(held).rank < N.cols()) return {};
  const VectorXd v = refined.displacement;
  refined.displacement = unit.cwiseProduct(place + Z * v);
  refined.displacement_low = unit.cwiseProduct(Z * refined.displacement_low);
  refined.rigid.resize(0);
  VectorXd force(first + rows);
  force.tail(rows) = refined.force;
  const VectorXd missing = programme.load - programme.stiffness * refined.displacement -
                           programme.A.bottomRows(rows).transpose() * refined.force;
  if (first > 0) force.head(first) = least_norm_solution(E.transpose(), unit.cwiseProduct(missing));
  refined.force = std::move(force);
  solution.gap = programme.initial_gap - programme.A * refined.displacement;
  for (Index& row : solution.active) solution.gap(row += first) = 0;
  if (certify(programme, refined).holds()) return solution;
  for (Index& row : pressed) row += first;
  std::optional<DenseSolution> again = held_solution(programme, pressed, solver, options);
  if (!again) return solution;
  append(solution.report, again->report);
  again->report = std::move(solution.report);
  return again;
}

}  // namespace signorini

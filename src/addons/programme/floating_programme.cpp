#include "addons/programme/floating_programme.hpp"

#include <cmath>
#include <utility>

#include "addons/certified/certified_solve.hpp"
#include "addons/programme/programme_rows.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/scene/rigid_modes.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

void check(const DenseProgramme& programme, const MatrixXd& N) {
  check_sizes(programme);
  require_argument(N.rows() == programme.load.size() && N.allFinite(),
                   "floating programme: let N have ", programme.load.size(),
                   " rows of finite numbers, got ", N.rows());
  require_argument(programme.equations == 0,
                   "floating programme: equations have no place here, got ", programme.equations);
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
  dense.active = end.state.active();
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

}  // namespace signorini

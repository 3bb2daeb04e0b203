#include "addons/programme/equation_split.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/core/rounding.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

std::optional<EquationSplit> split_by_equations(const DenseProgramme& programme, double spring) {
  if (programme.equations == 0) return {};
  EquationSplit split;
  split.K = programme.stiffness;
  if (spring > 0) split.K.diagonal().array() += spring;
  split.unit = split.K.diagonal().unaryExpr(
      [](double k) { return k != 0 ? 1 / std::sqrt(std::abs(k)) : 1.0; });
  split.K = split.unit.asDiagonal() * split.K * split.unit.asDiagonal();
  MatrixXd E = programme.A.topRows(programme.equations) * split.unit.asDiagonal();
  split.length.resize(E.rows());
  for (Index i = 0; i < E.rows(); ++i) {
    split.length(i) = E.row(i).stableNorm();
    E.row(i).stableNormalize();
  }
  if (!split.K.allFinite() || !E.allFinite()) return {};
  split.along = null_space(E);
  const Index rank = E.cols() - split.along.cols();
  if (rank == 0) return {};
  const SingularValues parts = singular_values(E);
  split.across = parts.V.leftCols(rank);
  split.U = parts.U.leftCols(rank);
  split.values = parts.values.head(rank);
  return split;
}

std::optional<VectorXd> sufficient_stiffness(const DenseProgramme& programme, double spring) {
  const std::optional<EquationSplit> split = split_by_equations(programme, spring);
  if (!split) return {};
  const MatrixXd& V = split->across;
  const MatrixXd& Z = split->along;
  MatrixXd across = V.transpose() * split->K * V;
  if (Z.cols() > 0) {
    const CholeskyFactor inner(Z.transpose() * split->K * Z);
    if (!inner.positive()) return {};
    MatrixXd half = Z.transpose() * split->K * V;
    solve_lower_columns(inner.lower(), half);
    across -= half.transpose() * half;
  }
  const VectorXd inverse = split->values.cwiseInverse();
  across = -(inverse.asDiagonal() * across * inverse.asDiagonal());
  const double least = std::max(0.0, symmetric_eigenvalues(across).maxCoeff());
  return split->length.unaryExpr(
      [&](double length) { return length > 0 ? (2 * least + 1) / (length * length) : 0; });
}

std::optional<DenseProgramme> convex_form(const DenseProgramme& programme) {
  const std::optional<EquationSplit> split = split_by_equations(programme, 0);
  if (!split) return {};
  const MatrixXd& V = split->across;
  const MatrixXd& Z = split->along;
  const MatrixXd own = Z.transpose() * split->K * Z;
  const double rounding = static_cast<double>(split->K.rows()) * epsilon;
  if (own.size() > 0 &&
      symmetric_eigenvalues(own).minCoeff() < -rounding * split->K.cwiseAbs().maxCoeff())
    return {};
  const VectorXd wanted = split->length.unaryExpr([](double l) { return l > 0 ? 1 / l : 0; })
                              .cwiseProduct(programme.initial_gap.head(programme.equations));
  const VectorXd c = V * (split->U.transpose() * wanted).cwiseQuotient(split->values);
  const VectorXd load = split->unit.cwiseProduct(programme.load) - split->K * c;
  const MatrixXd K = Z * own * Z.transpose() + V * V.transpose();
  const VectorXd back = split->unit.cwiseInverse();
  DenseProgramme convex = programme;
  convex.stiffness = back.asDiagonal() * (0.5 * (K + K.transpose())) * back.asDiagonal();
  convex.load = back.cwiseProduct(Z * (Z.transpose() * load) + c);
  return convex;
}

VectorXd equation_forces(const DenseProgramme& programme, const PrimalDual& solution) {
  const Index others = programme.A.rows() - programme.equations;
  VectorXd load = programme.load - programme.stiffness * solution.displacement -
                  programme.A.bottomRows(others).transpose() * solution.force.tail(others);
  if (solution.displacement_low.size() > 0) load -= programme.stiffness * solution.displacement_low;
  return least_norm_solution(programme.A.topRows(programme.equations).transpose(), load);
}

}  // namespace signorini

#include "addons/files/two_sided.hpp"

#include <cmath>
#include <limits>

#include "signorini/core/dense.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/exact_sum.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

bool is_equation(const TwoSidedProgramme& programme, Index row) {
  return programme.lower(row) == programme.upper(row);
}

/// The least eigenvalue of P where E x = 0, whatever the units of each x, over its rounding: > 1 if P is positive definite
/// there, < -1 if it is indefinite; not a number if it overflows.
double convexity(const MatrixXd& P, const MatrixXd& E) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Index n = P.rows();
  const VectorXd scale =
      P.diagonal().unaryExpr([](double p) { return p != 0 ? 1 / std::sqrt(std::abs(p)) : 1.0; });
  const MatrixXd scaled = scale.asDiagonal() * P * scale.asDiagonal();
  MatrixXd reduced = scaled;
  if (E.rows() > 0) {
    MatrixXd rows = E * scale.asDiagonal();
    for (Index i = 0; i < rows.rows(); ++i) rows.row(i).stableNormalize();
    if (!rows.allFinite() || !scaled.allFinite()) return unknown;
    const MatrixXd Z = null_space(rows);
    reduced = Z.transpose() * scaled * Z;
  }
  if (reduced.rows() == 0) return infinite;
  if (!reduced.allFinite()) return unknown;
  const VectorXd values = symmetric_eigenvalues(reduced);
  // Eigenvalues are rounded by the largest of them, which is no larger than this sum.
  const double largest = scaled.cwiseAbs().rowwise().sum().maxCoeff();
  return largest == 0 ? 0 : values.minCoeff() / (static_cast<double>(n) * epsilon * largest);
}

}  // namespace

OneSided one_sided(const TwoSidedProgramme& programme) {
  OneSided form;
  for (Index i = 0; i < programme.lower.size(); ++i)
    if (is_equation(programme, i)) form.rows.push_back({i, 1});
  const Index equations = static_cast<Index>(form.rows.size());
  for (Index i = 0; i < programme.lower.size(); ++i) {
    if (is_equation(programme, i)) continue;
    if (programme.upper(i) < no_bound) form.rows.push_back({i, 1});
    if (programme.lower(i) > -no_bound) form.rows.push_back({i, -1});
  }
  const Index count = static_cast<Index>(form.rows.size());
  DenseProgramme& dense = form.programme;
  dense.stiffness = programme.P;
  dense.load = -programme.q;
  dense.equations = equations;
  dense.A.resize(count, programme.q.size());
  dense.initial_gap.resize(count);
  for (Index k = 0; k < count; ++k) {
    const auto [row, sign] = form.rows[at(k)];
    dense.A.row(k) = sign * programme.A.row(row);
    dense.initial_gap(k) = sign > 0 ? programme.upper(row) : -programme.lower(row);
  }
  const double least = convexity(programme.P, dense.A.topRows(equations));
  require_input(least >= -1, "not convex: P has a negative eigenvalue",
                equations > 0 ? " where the equations hold" : " and there are no equations",
                ", so a place with balanced forces may be no optimum; let P be positive "
                "semidefinite, or add rows with l = u that hold its falling directions");
  form.definite = least > 1;
  return form;
}

double objective(const TwoSidedProgramme& programme, const PrimalDual& solution) {
  const VectorXd& x = solution.displacement;
  const VectorXd& low = solution.displacement_low;
  const Index n = programme.q.size();
  require_argument(x.size() == n && (low.size() == 0 || low.size() == n), "objective: expected ", n,
                   " unknowns, got ", x.size());
  ExactSum sum(programme.r);
  for (Index i = 0; i < n; ++i) {
    ExactSum slope(programme.q(i));  // of the objective half-way from 0 to x
    double small = 0;
    for (Index j = 0; j < n; ++j) {
      slope.add_product(0.5 * programme.P(i, j), x(j));
      if (low.size() > 0) small += programme.P(i, j) * low(j);
    }
    sum.add_product(slope.value(), x(i));
    sum.add(small * x(i));
    if (low.size() > 0) sum.add(programme.q(i) * low(i));
  }
  return sum.value();
}

VectorXd multipliers(const OneSided& form, const VectorXd& force, Index count) {
  require_argument(at(force.size()) == form.rows.size(),
                   "multipliers: expected one force for each of ", form.rows.size(), " rows, got ",
                   force.size());
  VectorXd y = VectorXd::Zero(count);
  for (Index k = 0; k < force.size(); ++k) {
    const auto [row, sign] = form.rows[at(k)];
    y(row) += sign * force(k);
  }
  return y;
}

}  // namespace signorini

/// \file
/// Quadratic programmes as collections write them, with two-sided rows, and their one-sided form.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Bounds of this magnitude or more are no bounds, as in the collection [\ref MarosMeszaros1999].
constexpr double no_bound = 1e20;

/// A quadratic programme with rows that are bounded on both sides.
///
/// \f[ \min_x \tfrac12 x^T P x + q^T x + r \quad\text{subject to}\quad l \le A x \le u. \f]
struct TwoSidedProgramme {
  Eigen::MatrixXd P;      ///< `n x n`, symmetric
  Eigen::VectorXd q;      ///< `n`
  double r = 0;           ///< constant of the objective
  Eigen::MatrixXd A;      ///< `m x n`
  Eigen::VectorXd lower;  ///< l `m`, -1e20 or less: none
  Eigen::VectorXd upper;  ///< u `m`, 1e20 or more: none; equal to l: an equation
  std::optional<double> published_optimum = {};  ///< the least objective that the file reports
};

/// A two-sided programme as one of the form that the solvers know.
///
/// K = P and p = -q. First the equations; then every finite u_i gives the row \f$ a_i x \le u_i \f$,
/// every finite l_i the row \f$ -a_i x \le -l_i \f$.
struct OneSided {
  /// Where a row comes from.
  struct Row {
    Eigen::Index row;  ///< of the two-sided programme
    double sign;       ///< 1 for an equation or an upper bound, -1 for a lower bound
  };
  DenseProgramme programme;  ///< with `rows.size()` rows
  std::vector<Row> rows;     ///< one for each row of `programme`
  bool definite = true;  ///< whether P is positive definite, to rounding, where the equations hold
};

/// Turns a programme around.
/// \param programme  of any size
/// \return the same programme with one-sided rows
/// \throws ProblemError "not convex" if P has a negative eigenvalue, beyond rounding, where the equations hold
[[nodiscard]] OneSided one_sided(const TwoSidedProgramme& programme);

/// The objective, with its large terms summed in twice the working precision.
/// \param programme  P, q, r
/// \param solution   x as displacements, in two parts
/// \return \f$ \tfrac12 x^T P x + q^T x + r \f$
/// \throws std::invalid_argument if x does not have the size of q
[[nodiscard]] double objective(const TwoSidedProgramme& programme, const PrimalDual& solution);

/// The multipliers of two-sided rows.
/// \param form   rows
/// \param force  lambda, one for each row of `form`
/// \param count  m
/// \return y `m` with \f$ P x + q + A^T y = 0 \f$: y_i > 0 at the upper bound, < 0 at the lower one
/// \throws std::invalid_argument if there is not one force for each row
[[nodiscard]] Eigen::VectorXd multipliers(const OneSided& form, const Eigen::VectorXd& force,
                                          Eigen::Index count);

}  // namespace signorini
